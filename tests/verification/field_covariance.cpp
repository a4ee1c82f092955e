// The covariance that samples of a random field have: averaged over samples and mesh, along x and along y.
//
//   field_covariance FIELDS MEAN SD REACH      FIELDS of rfgen; MEAN and SD of a normal marginal, in Pa; lags up to REACH metres
//
// Prints a table: axis, lag_m, covariance of (value - MEAN) / SD at lags of whole cells. The mean is taken as known, so that the
// estimate has no bias. pipelines/accuracy holds it against the model.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/file.hpp"
#include "io/hdf5_image.hpp"

namespace slidezone {
namespace {

using Sums = std::vector<double>;  // of products, by lag in cells

double sum_of_products(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// Values at one distance along x are one row against its own shifted self, along y one row against another.
void add_products(Sums& along_x, Sums& along_y, std::span<const double> values, std::size_t row_size) {
  const std::size_t rows = values.size() / row_size;
  for (std::size_t r = 0; r < rows; ++r) {
    const auto row = values.subspan(r * row_size, row_size);
    for (std::size_t lag = 0; lag < along_x.size(); ++lag) along_x[lag] += sum_of_products(row.first(row_size - lag), row.subspan(lag));
    for (std::size_t lag = 0; lag < along_y.size() && r + lag < rows; ++lag)
      along_y[lag] += sum_of_products(row, values.subspan((r + lag) * row_size, row_size));
  }
}

/// Pairs of cells at each lag, of one sample: `length` cells along the axis in each of `lines` lines.
void print(const char* axis, const Sums& sums, double cell, std::size_t samples, std::size_t length, std::size_t lines) {
  for (std::size_t lag = 0; lag < sums.size(); ++lag) {
    const auto pairs = static_cast<double>(samples * lines * (length - lag));
    std::cout << axis << '\t' << static_cast<double>(lag) * cell << '\t' << sums[lag] / pairs << '\n';
  }
}

void run(const std::string& path, double mean, double sd, double reach) {
  const std::string image = read_input(path);
  const Hdf5Reader fields(image, path, "slidezone-fields 1");
  const std::vector<std::size_t> shape = fields.shape("cohesion");
  const double cell_x = fields.real_attribute("cohesion", "cell_x"), cell_y = fields.real_attribute("cohesion", "cell_y");
  const auto lags = [&](double cell, std::size_t cells) {
    return std::min(cells, static_cast<std::size_t>(std::lround(reach / cell)) + 1);
  };
  Sums along_x(lags(cell_x, shape[2])), along_y(lags(cell_y, shape[1]));
  for (std::size_t sample = 0; sample < shape[0]; ++sample) {
    std::vector<double> values = fields.reals("cohesion", sample);
    for (double& value : values) value = (value - mean) / sd;
    add_products(along_x, along_y, values, shape[2]);
  }
  std::cout << "axis\tlag_m\tcovariance\n";
  print("x", along_x, cell_x, shape[0], shape[2], shape[1]);
  print("y", along_y, cell_y, shape[0], shape[1], shape[2]);
}

}  // namespace
}  // namespace slidezone

int main(int argc, char** argv) try {
  if (argc != 5) throw std::invalid_argument("usage: field_covariance FIELDS MEAN SD REACH");
  slidezone::run(argv[1], std::stod(argv[2]), std::stod(argv[3]), std::stod(argv[4]));
} catch (const std::exception& error) {
  std::cerr << "field_covariance: " << error.what() << '\n';
  return 1;
}
