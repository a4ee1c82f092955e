#include "io/vtkhdf.hpp"

#include <array>
#include <cassert>
#include <cstdint>
#include <numeric>

#include "core/text.hpp"
#include "io/hdf5_image.hpp"

namespace slidezone {

constexpr std::uint8_t vtk_vertex = 1;  // cell type of VTK

std::string vtkhdf_points(std::span<const double> x, std::span<const double> y, const std::vector<PointData>& data,
                          const Provenance& provenance) {
  assert(x.size() == y.size());
  const std::size_t count = x.size();
  std::vector<double> points(3 * count, 0.0);
  for (std::size_t p = 0; p < count; ++p) {
    points[3 * p] = x[p];
    points[3 * p + 1] = y[p];
  }
  std::vector<std::int64_t> connectivity(count);
  std::iota(connectivity.begin(), connectivity.end(), std::int64_t{0});
  std::vector<std::int64_t> offsets(count + 1);
  std::iota(offsets.begin(), offsets.end(), std::int64_t{0});
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
  writer.dataset("VTKHDF/Points", points, {count, 3});
  writer.dataset("VTKHDF/Connectivity", connectivity);
  writer.dataset("VTKHDF/Offsets", offsets);
  writer.dataset("VTKHDF/Types", std::vector<std::uint8_t>(count, vtk_vertex));
  writer.group("VTKHDF/PointData");
  for (const PointData& item : data) writer.dataset("VTKHDF/PointData/" + item.name, item.values, {item.values.size()});
  return writer.image();
}

std::string vtkhdf_series(const std::vector<Frame>& frames) {
  std::string text = "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [\n";
  for (std::size_t k = 0; k < frames.size(); ++k)
    text += "    {\"name\": \"" + frames[k].file + "\", \"time\": " + format_real(frames[k].time) + "}" +
            (k + 1 < frames.size() ? "," : "") + "\n";
  return text + "  ]\n}\n";
}

}  // namespace slidezone
