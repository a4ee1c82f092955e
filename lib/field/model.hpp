// What a random field is: mesh, autocorrelation, marginal distribution, and how it is sampled. Defaults are those of a scene that
// does not say otherwise. SI units.
#pragma once

#include <string>
#include <vector>

#include "field/mesh.hpp"

namespace slidezone {

/// Formulas in field/autocorrelation.hpp.
enum class Autocorrelation {
  single_exponential,
  squared_exponential,
  second_order_markov,
  third_order_markov,
  cosine_exponential,
  binary_noise,
  matern,
  spherical,
};

/// How the lags along and across the bedding go together.
enum class LagShape {
  separable,   // rho(dx / scale_x) rho(dy / scale_y)
  elliptical,  // rho(hypot(dx / scale_x, dy / scale_y))
};

struct Correlation {
  Autocorrelation function = Autocorrelation::single_exponential;
  double smoothness = 0;        // of Matern
  double horizontal_scale = 0;  // scale of fluctuation along the bedding, m
  double vertical_scale = 0;    // across the bedding, m
  LagShape shape = LagShape::separable;
  double bedding_angle = 0;  // rise of the bedding towards x, rad
  double nugget = 0;         // share of the variance that is noise without correlation from cell to cell

  bool operator==(const Correlation&) const = default;
};

/// Formulas in field/marginal.hpp.
enum class Distribution { lognormal, normal, truncated_normal, beta, gamma, weibull, uniform, empirical };

struct Marginal {
  Distribution distribution = Distribution::lognormal;
  double mean = 0;  // of the truncated normal: before it is cut; of the empirical: not used
  double cov = 0;   // coefficient of variation, likewise
  double low = 0;   // ends of the truncated normal and of beta
  double high = 0;
  std::vector<double> data;  // of the empirical
};

/// How values spread about a mean that changes with depth.
enum class Spread {
  constant_cov,  // with the mean: values are multiplied by mean(depth) / mean
  constant_sd,   // as they do at the surface: values are shifted by mean(depth) - mean
};

/// A mean that changes with depth below the ground: mean(depth) = mean + gradient depth.
struct Trend {
  double gradient = 0;  // per m
  Spread spread = Spread::constant_cov;
  std::vector<double> depth;  // of the centre of each cell of the mesh, m; empty: no trend
};

/// Which field has the correlation that is given: the Gaussian field behind the values, as in the paper, or the values themselves.
enum class CorrelationOf { gaussian, physical };

/// What a cell's number stands for: the Gaussian field at the cell's centre, or its average over the cell.
enum class Average { point, cell };

/// How points off the centres of cells get their values.
enum class Interpolation {
  cell,    // that of the cell which contains the point
  linear,  // linear between the centres of the four nearest cells, constant beyond the outermost centres
};

/// How Gaussian fields are made; field/gaussian_field.hpp says what each can do.
enum class Method { automatic, separable, circulant, cholesky, karhunen_loeve };

struct FieldModel {
  FieldMesh mesh;
  Correlation correlation;
  CorrelationOf correlation_of = CorrelationOf::gaussian;
  Average average = Average::point;
  Method method = Method::automatic;
  double variance_kept = 0.99;  // by the modes of Karhunen-Loeve
  Marginal marginal;            // with a trend: at the surface
  Trend trend;
};

/// Names in scenes, in the order of the enumerations.
const std::vector<std::string>& autocorrelation_names();
const std::vector<std::string>& lag_shape_names();
const std::vector<std::string>& distribution_names();
const std::vector<std::string>& spread_names();
const std::vector<std::string>& correlation_of_names();
const std::vector<std::string>& average_names();
const std::vector<std::string>& interpolation_names();
const std::vector<std::string>& method_names();

}  // namespace slidezone
