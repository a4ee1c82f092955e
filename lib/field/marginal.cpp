#include "field/marginal.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_gamma.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/vector_loop.hpp"
#include "field/lognormal.hpp"

namespace slidezone {

namespace {

constexpr double last = 8.75;  // normals do not exceed 8.6: core/random.hpp
constexpr double per_unit = 64;

using Quantile = std::function<double(double)>;

/// Of a distribution with quantiles of lower and upper probabilities: each normal takes the tail that keeps its digits.
template <class Lower, class Upper>
Quantile from_tails(Lower lower, Upper upper) {
  return [=](double g) { return g < 0 ? lower(gsl_cdf_ugaussian_P(g)) : upper(gsl_cdf_ugaussian_Q(g)); };
}

Quantile truncated_normal(const Marginal& marginal) {
  const double sd = marginal.mean * marginal.cov, mean = marginal.mean;
  const double a = (marginal.low - mean) / sd, b = (marginal.high - mean) / sd;
  const double below = gsl_cdf_ugaussian_P(a), up_to_high = gsl_cdf_ugaussian_P(b);
  const double above = gsl_cdf_ugaussian_Q(b), from_low = gsl_cdf_ugaussian_Q(a);
  return from_tails([=](double p) { return mean + sd * gsl_cdf_ugaussian_Pinv(below + p * (up_to_high - below)); },
                    [=](double q) { return mean + sd * gsl_cdf_ugaussian_Qinv(above + q * (from_low - above)); });
}

/// The quantile x of GSL's search, or where that failed the result of bisection: far in the tails of narrow distributions it does.
double or_bisected(double x, double (*tail)(double, double, double), double probability, double a, double b) {
  constexpr double tolerance = 1e-7;  // of the probability: far less of the quantile
  if (std::isfinite(x) && std::abs(tail(x, a, b) - probability) <= tolerance * probability) return x;
  const bool rises = tail(0, a, b) < 0.5;
  const auto is_below = [&](double place) { return (tail(place, a, b) < probability) == rises; };
  double low = 0, high = 1;
  while (is_below(high) && std::isfinite(high)) high *= 2;
  for (double middle = high / 2; middle > low && middle < high; middle = (low + high) / 2) (is_below(middle) ? low : high) = middle;
  return low;
}

Quantile beta(const Marginal& marginal) {
  const double low = marginal.low, width = marginal.high - marginal.low;
  const double m = (marginal.mean - low) / width, s = marginal.mean * marginal.cov / width;
  const double nu = m * (1 - m) / (s * s) - 1;
  if (!(m > 0 && m < 1 && nu > 0))
    throw Error(ExitCode::data, "a beta distribution from " + format_brief(low) + " to " + format_brief(marginal.high) + " of mean " +
                                    format_brief(marginal.mean) + " has a standard deviation below " +
                                    format_brief(width * std::sqrt(std::max(0.0, m * (1 - m)))) + ", found " +
                                    format_brief(marginal.mean * marginal.cov));
  constexpr double narrowest = 1e6;  // beyond, GSL's incomplete beta function loses its digits
  if (nu > narrowest)
    throw Error(ExitCode::data,
                "a beta distribution whose standard deviation is below some 1/2000 of its width is out of reach; "
                "move its ends closer to the mean or take a truncated normal");
  const double alpha = m * nu, beta = (1 - m) * nu;
  return from_tails([=](double p) { return low + width * or_bisected(gsl_cdf_beta_Pinv(p, alpha, beta), gsl_cdf_beta_P, p, alpha, beta); },
                    [=](double q) { return low + width * or_bisected(gsl_cdf_beta_Qinv(q, alpha, beta), gsl_cdf_beta_Q, q, alpha, beta); });
}

Quantile gamma(const Marginal& marginal) {
  const double shape = 1 / (marginal.cov * marginal.cov), scale = marginal.mean / shape;
  constexpr double narrowest = 1e5;  // beyond, GSL's incomplete gamma function loses its digits
  if (shape > narrowest)
    throw Error(ExitCode::data, "a gamma distribution of a cov below " + format_brief(1 / std::sqrt(narrowest)) +
                                    " is out of reach; take a normal distribution");
  return from_tails([=](double p) { return scale * or_bisected(gsl_cdf_gamma_Pinv(p, shape, 1), gsl_cdf_gamma_P, p, shape, 1); },
                    [=](double q) { return scale * or_bisected(gsl_cdf_gamma_Qinv(q, shape, 1), gsl_cdf_gamma_Q, q, shape, 1); });
}

/// The COV of a Weibull distribution falls with its shape: bisection on its logarithm.
double weibull_shape(double cov) {
  double low = std::log(0.05), high = std::log(1e5);  // above, the difference of the logarithms below loses its digits
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2, k = std::exp(middle);
    const double ratio = gsl_sf_lngamma(1 + 2 / k) - 2 * gsl_sf_lngamma(1 + 1 / k);
    (std::expm1(ratio) > cov * cov ? low : high) = middle;
  }
  return std::exp(low);
}

Quantile weibull(const Marginal& marginal) {
  const double shape = weibull_shape(marginal.cov), scale = marginal.mean / gsl_sf_gamma(1 + 1 / shape);
  return from_tails([=](double p) { return gsl_cdf_weibull_Pinv(p, scale, shape); },
                    [=](double q) { return gsl_cdf_weibull_Qinv(q, scale, shape); });
}

Quantile uniform(const Marginal& marginal) {
  const double half = std::numbers::sqrt3 * marginal.cov * marginal.mean, low = marginal.mean - half;
  return [=](double g) { return low + 2 * half * gsl_cdf_ugaussian_P(g); };
}

Quantile empirical(std::vector<double> data) {
  std::ranges::sort(data);
  return [data](double g) {
    const double place =
        std::clamp(gsl_cdf_ugaussian_P(g) * static_cast<double>(data.size()) - 0.5, 0.0, static_cast<double>(data.size() - 1));
    const auto i = std::min(static_cast<std::size_t>(place), data.size() - 1), next = std::min(i + 1, data.size() - 1);
    return data[i] + (place - static_cast<double>(i)) * (data[next] - data[i]);
  };
}

Quantile quantile_of(const Marginal& marginal) {
  switch (marginal.distribution) {
    case Distribution::lognormal:
      return [law = lognormal(marginal.mean, marginal.cov)](double g) { return std::exp(law.lambda + law.zeta * g); };
    case Distribution::normal:
      return [mean = marginal.mean, cov = marginal.cov](double g) { return mean * (1 + cov * g); };
    case Distribution::truncated_normal:
      return truncated_normal(marginal);
    case Distribution::beta:
      return beta(marginal);
    case Distribution::gamma:
      return gamma(marginal);
    case Distribution::weibull:
      return weibull(marginal);
    case Distribution::uniform:
      return uniform(marginal);
    case Distribution::empirical:
      return empirical(marginal.data);
  }
  return {};
}

bool wants_table(Distribution distribution) {
  return distribution == Distribution::truncated_normal || distribution == Distribution::beta || distribution == Distribution::gamma ||
         distribution == Distribution::weibull;
}

/// Values at g = -last - 1/64, -last, ..., last + 1/64: one more at either end for the cubics.
std::vector<double> table_of(const Quantile& quantile) {
  std::vector<double> table;
  for (int i = -1; i <= static_cast<int>(2 * last * per_unit) + 1; ++i) table.push_back(quantile(i / per_unit - last));
  const auto falls = [](double a, double b) { return !(b >= a - 1e-9 * std::abs(a)); };  // beyond rounding, or not a number
  if (std::ranges::adjacent_find(table, falls) != table.end())
    throw Error(ExitCode::data, "the quantiles of this distribution are out of reach; take another coefficient of variation");
  return table;
}

/// Cubic through four neighbours (Lagrange), between the nearest two also where the quantiles turn sharply.
SLIDEZONE_VECTOR_LOOP
void interpolate(double* values, std::size_t count, const double* table) {
  for (std::size_t i = 0; i < count; ++i) {
    const double place = (std::min(std::max(values[i], -last), last) + last) * per_unit;
    const int node = std::min(static_cast<int>(place), static_cast<int>(2 * last * per_unit) - 1);
    const double t = place - node;
    const double* y = table + node;  // at t = -1, 0, 1, 2
    const double cubic = y[0] * (-t * (t - 1) * (t - 2) / 6) + y[1] * ((t + 1) * (t - 1) * (t - 2) / 2) +
                         y[2] * (-(t + 1) * t * (t - 2) / 2) + y[3] * ((t + 1) * t * (t - 1) / 6);
    values[i] = std::min(std::max(cubic, y[1]), y[2]);
  }
}

/// Values of the table must have the mean and the spread that the scene gives, which those of an extreme distribution may miss.
void check_moments(const Marginal& marginal, const std::vector<double>& table) {
  constexpr double step = 1. / 256, tolerance = 1e-3;  // of the standard deviation
  std::vector<double> weights, values;
  for (double g = -last; g <= last; g += step) {
    weights.push_back(std::exp(-g * g / 2) * step / std::sqrt(2 * std::numbers::pi));
    values.push_back(g);
  }
  interpolate(values.data(), values.size(), table.data());
  double mean = 0, squares = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    mean += weights[i] * (values[i] - marginal.mean);
    squares += weights[i] * (values[i] - marginal.mean) * (values[i] - marginal.mean);
  }
  const double wanted = marginal.mean * marginal.cov, sd = std::sqrt(squares - mean * mean);
  if (!(std::abs(mean) < tolerance * wanted && std::abs(sd - wanted) < tolerance * wanted))
    throw Error(ExitCode::data, "this distribution is out of reach: instead of a standard deviation of " + format_brief(wanted, 6) +
                                    " it would have one of " + format_brief(sd, 6) + "; take another coefficient of variation");
}

}  // namespace

MarginalTransform::MarginalTransform(const Marginal& marginal) : marginal_(marginal) {
  gsl_set_error_handler_off();  // failures show as values that are not finite
  quantile_ = quantile_of(marginal);
  if (wants_table(marginal.distribution)) table_ = table_of(quantile_);
  if (!table_.empty() && marginal.distribution != Distribution::truncated_normal) check_moments(marginal, table_);
}

/// The least normal within +-8.6 whose value is not below what `is_below` says, by bisection to the last digit.
template <class IsBelow>
static double least_normal(IsBelow is_below) {
  double low = -8.6, high = 8.6;
  for (double middle = 0; middle > low && middle < high; middle = (low + high) / 2) (is_below(middle) ? low : high) = middle;
  return high;
}

/// Where the quantile is level, as at the ends of data and where data repeat, the middle of its probabilities.
std::optional<double> MarginalTransform::normal(double value) const {
  if (value < quantile_(-8.6) || value > quantile_(8.6)) return std::nullopt;
  const double first = least_normal([&](double g) { return quantile_(g) < value; });
  if (marginal_.distribution != Distribution::empirical) return first;
  const double end = least_normal([&](double g) { return quantile_(g) <= value; });
  return gsl_cdf_ugaussian_Pinv((gsl_cdf_ugaussian_P(first) + gsl_cdf_ugaussian_P(end)) / 2);
}

double MarginalTransform::slope(double g) const {
  constexpr double step = 1e-3;
  return (quantile_(g + step) - quantile_(g - step)) / (2 * step);
}

void MarginalTransform::apply(std::span<double> values) const {
  if (marginal_.distribution == Distribution::lognormal)
    make_lognormal(values, lognormal(marginal_.mean, marginal_.cov));
  else if (!table_.empty())
    interpolate(values.data(), values.size(), table_.data());
  else
    for (double& value : values) value = quantile_(value);
}

}  // namespace slidezone
