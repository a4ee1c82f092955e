// Circulant embedding: exact stationary Gaussian fields on a mesh at the cost of two Fourier transforms (Dietrich and Newsam 1997).
//
// The covariance is continued periodically on a mesh of at least twice the cells, where its matrix is circulant and its
// eigenvalues are the Fourier transform of its first row. White noise filtered by their square roots has the periodic covariance,
// and a corner of it the wanted one. Needs eigenvalues that are not negative: the axis at whose far side the correlation
// is stronger is doubled until they are so to rounding (1e-12 of the largest). What is set to zero then is the error of the covariance, and
// is reported. Fourier transforms by FFTW3 without measurement: the same plan in every run.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "core/random.hpp"
#include "field/model.hpp"

namespace slidezone {

class CirculantEmbedding {
 public:
  /// Throws ExitCode::data where no padding up to `largest_mesh` cells will do.
  explicit CirculantEmbedding(const FieldModel& model, std::size_t largest_mesh = std::size_t{1} << 26);
  ~CirculantEmbedding();
  CirculantEmbedding(CirculantEmbedding&&) noexcept;

  /// Fills one standard Gaussian field.
  void fill(std::span<double> values, RandomStream stream);

  double covariance_error() const;
  std::size_t cells_x() const;  // of the padded mesh
  std::size_t cells_y() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace slidezone
