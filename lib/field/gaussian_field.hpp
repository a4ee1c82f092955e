// Standard Gaussian fields on a mesh, by the method that the model names or by the cheapest exact one.
//
//   sweep           single exponential, separable, no bedding angle, at points: AR(1) along each axis, exact (field/exponential.hpp); O(n)
//   separable       any separable correlation: a triangular factor per axis (field/covariance_factor.hpp); O(n (cells_x + cells_y))
//   circulant       any correlation (field/circulant.hpp); O(n log n), n of the padded mesh
//   Cholesky        any correlation, the paper's method (Eqs. 25-27): a triangular factor of all cells; n^2 / 2 numbers
//   Karhunen-Loeve  any correlation, cut off at a share of the variance (field/karhunen_loeve.hpp)
//
// Sweep, separable and Cholesky make the same field of the same normals. All but Karhunen-Loeve are exact; what rounding or a
// clipped eigenvalue costs is reported. A nugget is added as noise of its own stream. Sweep and separable give the same bits
// on every machine, the others do so on one kind of processor and agree to rounding between kinds.
// Throws ExitCode::data where the method cannot do what the model wants, or would take too much memory.
#pragma once

#include <span>
#include <string>
#include <variant>

#include "core/random.hpp"
#include "field/circulant.hpp"
#include "field/exponential.hpp"
#include "field/karhunen_loeve.hpp"
#include "field/model.hpp"
#include "field/triangular.hpp"

namespace slidezone {

struct MethodReport {
  std::string method;
  std::string reason;
  double covariance_error = 0;  // largest, of unit variance; a bound where "at most"
  double variance_kept = 1;
};

class GaussianField {
 public:
  explicit GaussianField(const FieldModel& model);

  /// Fills `values`, of mesh.size(), with one field of mean 0 and variance 1, or that of averages over cells.
  void fill(std::span<double> values, RandomStream stream);

  const MethodReport& report() const { return report_; }

 private:
  struct Sweep {
    std::size_t row_size;
    ExponentialFactor x, y;
  };
  struct Separable {
    LowerTriangle x, y;
  };
  struct Dense {
    LowerTriangle factor;
  };

  void use_sweep(const FieldModel& model);
  void use_separable(const FieldModel& model);
  void use_circulant(const FieldModel& model);
  void use_cholesky(const FieldModel& model);
  void use_karhunen_loeve(const FieldModel& model);
  void choose(const FieldModel& model);

  std::variant<Sweep, Separable, CirculantEmbedding, Dense, KarhunenLoeve> method_ = Sweep{};
  MethodReport report_;
  double nugget_;
};

}  // namespace slidezone
