#include "field/circulant.hpp"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"
#include "field/cell_correlation.hpp"

namespace slidezone {

namespace {

struct FreePlan {
  void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
};
struct FreeArray {
  void operator()(void* array) const { fftw_free(array); }
};
using Plan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, FreePlan>;

/// Real numbers on a padded mesh that closes in itself, and their Fourier transform, of which one half says all.
struct Torus {
  std::size_t cells_x, cells_y;
  std::unique_ptr<double[], FreeArray> values;
  std::unique_ptr<fftw_complex[], FreeArray> transform;
  Plan forward, backward;

  Torus(std::size_t x, std::size_t y)
      : cells_x(x),
        cells_y(y),
        values(fftw_alloc_real(size())),
        transform(fftw_alloc_complex(modes())),
        forward(fftw_plan_dft_r2c_2d(static_cast<int>(y), static_cast<int>(x), values.get(), transform.get(), FFTW_ESTIMATE)),
        backward(fftw_plan_dft_c2r_2d(static_cast<int>(y), static_cast<int>(x), transform.get(), values.get(), FFTW_ESTIMATE)) {}

  std::size_t size() const { return cells_x * cells_y; }
  std::size_t modes() const { return (cells_x / 2 + 1) * cells_y; }
};

/// The least even number from `least` on without prime factors above 5: fast to transform.
std::size_t convenient(std::size_t least) {
  for (std::size_t size = least + least % 2;; size += 2) {
    std::size_t rest = size;
    for (const std::size_t prime : {2u, 3u, 5u})
      while (rest % prime == 0) rest /= prime;
    if (rest == 1) return size;
  }
}

/// Lag, in cells, of place i on a ring of n: the shorter way round.
double ring_lag(std::size_t i, std::size_t n) { return static_cast<double>(i) - (2 * i > n ? static_cast<double>(n) : 0); }

/// The first row of the periodic covariance. Opposite lags, two ways to the far side, get the mean: so it stays even.
void fill_with_covariance(Torus& torus, CellCorrelation& correlation) {
  for (std::size_t j = 0; j < torus.cells_y; ++j)
    for (std::size_t i = 0; i < torus.cells_x; ++i) {
      const double x = ring_lag(i, torus.cells_x), y = ring_lag(j, torus.cells_y);
      const bool is_far = 2 * i == torus.cells_x || 2 * j == torus.cells_y;
      torus.values[j * torus.cells_x + i] = is_far ? (correlation(x, y) + correlation(x, -y)) / 2 : correlation(x, y);
    }
}

struct Spectrum {
  std::vector<double> eigenvalues;  // one per mode; real, because the first row is even
  double least = 0;
  double greatest = 0;
};

Spectrum spectrum_of(Torus& torus, CellCorrelation& correlation) {
  fill_with_covariance(torus, correlation);
  fftw_execute(torus.forward.get());
  Spectrum spectrum;
  spectrum.eigenvalues.resize(torus.modes());
  for (std::size_t k = 0; k < torus.modes(); ++k) spectrum.eigenvalues[k] = torus.transform[k][0];
  spectrum.least = *std::ranges::min_element(spectrum.eigenvalues);
  spectrum.greatest = *std::ranges::max_element(spectrum.eigenvalues);
  return spectrum;
}

[[noreturn]] void fail(const Torus& torus, const Spectrum& spectrum) {
  throw Error(ExitCode::data, "circulant embedding needs eigenvalues that are not negative, but padded to " +
                                  std::to_string(torus.cells_x) + " x " + std::to_string(torus.cells_y) + " cells the least is " +
                                  format_brief(spectrum.least / spectrum.greatest, 2) +
                                  " times the greatest; take another method or shorter scales of fluctuation");
}

void check_size(std::size_t cells_x, std::size_t cells_y, std::size_t largest) {
  const double cells = static_cast<double>(cells_x) * static_cast<double>(cells_y);
  constexpr double bytes_per_cell = 20;  // values, half a transform, half a filter
  if (cells > static_cast<double>(largest))
    throw Error(ExitCode::data, "circulant embedding would pad the mesh to " + std::to_string(cells_x) + " x " + std::to_string(cells_y) +
                                    " cells, which take " + format_brief(bytes_per_cell * cells / 1e9, 3) + " GB; take a coarser mesh");
}

/// The axis at whose far side the correlation is stronger is too short: it is doubled.
void lengthen(std::size_t& cells_x, std::size_t& cells_y, CellCorrelation& correlation) {
  const double far_x = std::abs(correlation(static_cast<double>(cells_x / 2), 0));
  const double far_y = std::abs(correlation(0, static_cast<double>(cells_y / 2)));
  std::size_t& shorter = far_x >= far_y ? cells_x : cells_y;
  shorter = convenient(2 * shorter);
}

}  // namespace

struct CirculantEmbedding::State {
  std::size_t row_size;
  Torus torus;
  std::vector<double> filter;  // square roots of the eigenvalues, over the number of cells for the transforms' sake
  double error = 0;            // the sum of what was set to zero bounds the error of each covariance

  State(std::size_t columns, Torus&& padded, const Spectrum& spectrum) : row_size(columns), torus(std::move(padded)) {
    const double cells = static_cast<double>(torus.size());
    for (const double eigenvalue : spectrum.eigenvalues) {
      error += 2 * std::max(0.0, -eigenvalue) / cells;  // twice: most modes stand for two
      filter.push_back(std::sqrt(std::max(0.0, eigenvalue)) / cells);
    }
  }
};

CirculantEmbedding::CirculantEmbedding(const FieldModel& model, std::size_t largest_mesh) {
  constexpr double rounding = 1e-12;
  CellCorrelation correlation(model);
  const auto columns = static_cast<std::size_t>(model.mesh.cells_x), rows = static_cast<std::size_t>(model.mesh.cells_y);
  std::size_t x = convenient(2 * columns), y = convenient(2 * rows);
  check_size(x, y, largest_mesh);
  for (;;) {
    Torus torus(x, y);
    const Spectrum spectrum = spectrum_of(torus, correlation);
    if (spectrum.least >= -rounding * spectrum.greatest) {
      state_.reset(new State(columns, std::move(torus), spectrum));
      return;
    }
    lengthen(x, y, correlation);
    if (x * y > largest_mesh) fail(torus, spectrum);
  }
}

CirculantEmbedding::~CirculantEmbedding() = default;
CirculantEmbedding::CirculantEmbedding(CirculantEmbedding&&) noexcept = default;

void CirculantEmbedding::fill(std::span<double> values, RandomStream stream) {
  Torus& torus = state_->torus;
  fill_normals({torus.values.get(), torus.size()}, stream);
  fftw_execute(torus.forward.get());
  for (std::size_t k = 0; k < torus.modes(); ++k)
    for (double& part : torus.transform[k]) part *= state_->filter[k];
  fftw_execute(torus.backward.get());
  for (std::size_t row = 0; row * state_->row_size < values.size(); ++row)
    std::copy_n(&torus.values[row * torus.cells_x], state_->row_size, &values[row * state_->row_size]);
}

double CirculantEmbedding::covariance_error() const { return state_->error; }
std::size_t CirculantEmbedding::cells_x() const { return state_->torus.cells_x; }
std::size_t CirculantEmbedding::cells_y() const { return state_->torus.cells_y; }

}  // namespace slidezone
