#include "field/gaussian_field.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"
#include "field/cell_correlation.hpp"
#include "field/covariance_factor.hpp"
#include "field/mesh_covariance.hpp"

namespace slidezone {

namespace {

constexpr double largest_matrix = 8e9;    // bytes that a method may take
constexpr int longest_axis = 1000;        // cells along both axes up to which factors are cheaper than Fourier transforms
constexpr std::size_t small_mesh = 2500;  // cells up to which a dense factor is a matter of seconds,
constexpr std::size_t longest_padding = std::size_t{1} << 17;  // and cheaper than Fourier transforms of this many

std::string gigabytes(double bytes) { return format_brief(std::ceil(bytes / 1e8) / 10, 15) + " GB"; }

/// Matrices of n x n numbers, as many as the method holds at a time.
void check_memory(const std::string& method, double n, double matrices) {
  const double bytes = matrices * n * n * sizeof(double);
  if (bytes > largest_matrix)
    throw Error(ExitCode::data, "method \"" + method + "\" would take " + gigabytes(bytes) + " of memory for " + format_brief(n, 9) +
                                    " cells, more than " + gigabytes(largest_matrix) + "; take a coarser mesh or method \"auto\"");
}

/// Binary noise of an elliptical lag is no correlation: its matrix has negative eigenvalues on the plane.
void check_definiteness(const Correlation& correlation) {
  if (correlation.function == Autocorrelation::binary_noise && correlation.shape == LagShape::elliptical)
    throw Error(ExitCode::data, "the autocorrelation \"binary noise\" is not positive definite with an elliptical lag; make it separable");
}

bool is_separable(const FieldModel& model) { return CellCorrelation(model).is_separable(); }

bool is_sweepable(const FieldModel& model) {
  return model.correlation.function == Autocorrelation::single_exponential && is_separable(model) && model.average == Average::point;
}

}  // namespace

GaussianField::GaussianField(const FieldModel& model) : nugget_(model.correlation.nugget) {
  check_definiteness(model.correlation);
  switch (model.method) {
    case Method::automatic:
      choose(model);
      break;
    case Method::separable:
      is_sweepable(model) ? use_sweep(model) : use_separable(model);
      break;
    case Method::circulant:
      use_circulant(model);
      break;
    case Method::cholesky:
      use_cholesky(model);
      break;
    case Method::karhunen_loeve:
      use_karhunen_loeve(model);
      break;
  }
  if (model.method != Method::automatic) report_.reason = "the scene asks for it";
}

/// The cheapest exact method.
void GaussianField::choose(const FieldModel& model) {
  const bool is_product = is_separable(model);
  if (is_sweepable(model)) {
    use_sweep(model);
    report_.reason = "a separable single exponential is an autoregression along each axis: exact, and the cheapest of all";
  } else if (is_product && model.mesh.cells_x + model.mesh.cells_y <= longest_axis) {
    use_separable(model);
    report_.reason = "the correlation is separable, and factors of " + std::to_string(model.mesh.cells_x) + " and " +
                     std::to_string(model.mesh.cells_y) + " cells are cheaper than Fourier transforms";
  } else {
    try {
      use_circulant(model);
      report_.reason = is_product ? "the axes are long: Fourier transforms are cheaper than factors"
                                  : "the correlation of the Gaussian field is not separable along x and y";
    } catch (const Error&) {
      if (model.mesh.size() > small_mesh) throw;
      use_cholesky(model);
      report_.reason = "little padding does not make the circulant matrix positive, and the mesh is small";
    }
  }
}

void GaussianField::use_sweep(const FieldModel& model) {
  method_.emplace<Sweep>(static_cast<std::size_t>(model.mesh.cells_x),
                         exponential_factor(model.mesh.cell_x, model.correlation.horizontal_scale),
                         exponential_factor(model.mesh.cell_y, model.correlation.vertical_scale));
  report_ = {"sweep", "", 0, 1};
}

void GaussianField::use_separable(const FieldModel& model) {
  if (!is_separable(model))
    throw Error(ExitCode::data,
                "method \"separable\" wants a separable correlation of the Gaussian field, without bedding angle; take method "
                "\"circulant\" or \"auto\"");
  check_memory("separable", std::max(model.mesh.cells_x, model.mesh.cells_y), 4);
  CovarianceFactor x = clipped_factor(row_covariance(model)), y = clipped_factor(column_covariance(model));
  report_ = {"separable", "", x.error + y.error + x.error * y.error, 1};
  method_.emplace<Separable>(std::move(x.lower), std::move(y.lower));
}

void GaussianField::use_circulant(const FieldModel& model) {
  const bool yields = model.method == Method::automatic && model.mesh.size() <= small_mesh;
  const CirculantEmbedding& embedding =
      yields ? method_.emplace<CirculantEmbedding>(model, longest_padding) : method_.emplace<CirculantEmbedding>(model);
  report_ = {"circulant", "", embedding.covariance_error(), 1};
}

void GaussianField::use_cholesky(const FieldModel& model) {
  check_memory("Cholesky", static_cast<double>(model.mesh.size()), 2);
  CovarianceFactor factor = jittered_factor(full_covariance(model));
  report_ = {"Cholesky", "", factor.error, 1};
  method_.emplace<Dense>(std::move(factor.lower));
}

void GaussianField::use_karhunen_loeve(const FieldModel& model) {
  const bool is_product = is_separable(model);
  check_memory("Karhunen-Loeve", is_product ? std::max(model.mesh.cells_x, model.mesh.cells_y) : static_cast<double>(model.mesh.size()), 3);
  KarhunenLoeve expansion = karhunen_loeve(model);
  report_ = {"Karhunen-Loeve", "", expansion.covariance_error, expansion.variance_kept};
  method_.emplace<KarhunenLoeve>(std::move(expansion));
}

/// Noise from cell to cell in place of the share `nugget` of the variance.
static void add_nugget(std::span<double> values, double nugget, RandomStream stream) {
  static const std::uint32_t noise = purpose("nugget");
  std::vector<double> normals(values.size());
  stream.purpose ^= noise;
  fill_normals(normals, stream);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::sqrt(1 - nugget) * values[i] + std::sqrt(nugget) * normals[i];
}

void GaussianField::fill(std::span<double> values, RandomStream stream) {
  if (CirculantEmbedding* const embedding = std::get_if<CirculantEmbedding>(&method_)) {
    embedding->fill(values, stream);
  } else if (const KarhunenLoeve* const expansion = std::get_if<KarhunenLoeve>(&method_)) {
    slidezone::fill(values, *expansion, stream);
  } else {
    fill_normals(values, stream);
    if (const Sweep* const sweep = std::get_if<Sweep>(&method_)) {
      correlate_along_rows(values, sweep->row_size, sweep->x);
      correlate_across_rows(values, sweep->row_size, sweep->y);
    } else if (const Separable* const factors = std::get_if<Separable>(&method_)) {
      multiply_along_rows(values, factors->x);
      multiply_across_rows(values, factors->y);
    } else {
      multiply_along_rows(values, std::get<Dense>(method_).factor);
    }
  }
  if (nugget_ > 0) add_nugget(values, nugget_, stream);
}

}  // namespace slidezone
