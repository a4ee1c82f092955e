#include "io/vtkhdf.hpp"

#include <array>
#include <cassert>
#include <cstdint>
#include <numeric>

#include "core/text.hpp"
#include "io/hdf5_image.hpp"

namespace slidezone {

constexpr std::uint8_t vtk_vertex = 1;  // cell type of VTK

static std::vector<double> three_components(std::span<const double> x, std::span<const double> y) {
  std::vector<double> points(3 * x.size(), 0.0);
  for (std::size_t p = 0; p < x.size(); ++p) {
    points[3 * p] = x[p];
    points[3 * p + 1] = y[p];
  }
  return points;
}

void write_vtkhdf_points(std::span<const double> x, std::span<const double> y, const std::vector<PointData>& data,
                         const Provenance& provenance, const std::function<void(std::string_view)>& take) {
  assert(x.size() == y.size());
  const std::size_t count = x.size();
  const auto count_up = [](std::size_t, std::span<std::int64_t> numbers) { std::iota(numbers.begin(), numbers.end(), std::int64_t{0}); };
  const std::array<std::int64_t, 1> one_piece = {static_cast<std::int64_t>(count)};
  const std::array<std::int64_t, 2> format_version = {1, 0};

  Hdf5Writer writer;
  writer.provenance(provenance);
  writer.group("VTKHDF");
  writer.attribute("VTKHDF", "Version", format_version);
  writer.attribute("VTKHDF", "Type", std::string("UnstructuredGrid"));
  writer.dataset("VTKHDF/NumberOfPoints", one_piece);
  writer.dataset("VTKHDF/NumberOfCells", one_piece);
  writer.dataset("VTKHDF/NumberOfConnectivityIds", one_piece);
  writer.dataset("VTKHDF/Points", three_components(x, y), {count, 3});
  writer.dataset_later("VTKHDF/Connectivity", count, count_up);
  writer.dataset_later("VTKHDF/Offsets", count + 1, count_up);
  writer.dataset("VTKHDF/Types", std::vector<std::uint8_t>(count, vtk_vertex));
  writer.group("VTKHDF/PointData");
  for (const PointData& item : data)
    writer.dataset_later("VTKHDF/PointData/" + item.name, {count}, [&item](std::size_t, std::span<double> values) {
      for (std::size_t p = 0; p < values.size(); ++p) values[p] = item.value(p);
    });
  writer.write(take);
}

std::string vtkhdf_series(const std::vector<Frame>& frames) {
  std::string text = "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [\n";
  for (std::size_t k = 0; k < frames.size(); ++k)
    text += "    {\"name\": \"" + frames[k].file + "\", \"time\": " + format_real(frames[k].time) + "}" +
            (k + 1 < frames.size() ? "," : "") + "\n";
  return text + "  ]\n}\n";
}

}  // namespace slidezone
