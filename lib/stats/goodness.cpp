#include "stats/goodness.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "stats/gsl_errors.hpp"

namespace slidezone {

static std::size_t bin_count(std::size_t count) {
  const auto n = static_cast<double>(count);
  return std::min(static_cast<std::size_t>(2 * std::pow(n, 0.4)), count / 5);
}

std::optional<ChiSquare> chi_square(const Fit& fit, std::span<const double> values) {
  const std::size_t bins = bin_count(values.size());
  const std::size_t estimated = fit.parameters.size();
  if (bins < estimated + 2) return std::nullopt;
  std::vector<double> found(bins, 0);
  for (const double value : values) {
    const double place = cumulative(fit, value) * static_cast<double>(bins);
    found[std::min(static_cast<std::size_t>(place), bins - 1)] += 1;
  }
  const double expected = static_cast<double>(values.size()) / static_cast<double>(bins);
  ChiSquare result{0, bins, bins - 1 - estimated, 0};
  for (const double count : found) result.statistic += (count - expected) * (count - expected) / expected;
  keep_gsl_from_aborting();
  result.p = gsl_cdf_chisq_Q(result.statistic, static_cast<double>(result.degrees_of_freedom));
  return result;
}

Distances distances(const Fit& fit, std::span<const double> values) {
  std::vector<double> ascending(values.begin(), values.end());
  std::sort(ascending.begin(), ascending.end());
  const double n = static_cast<double>(ascending.size());
  Distances found;
  double sum = 0;
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    const double rank = static_cast<double>(i + 1);
    const double below = cumulative(fit, ascending[i]);
    found.lilliefors = std::max({found.lilliefors, rank / n - below, below - (rank - 1) / n});
    // The i-th value from below and the i-th from above share a factor: regrouped, one pass suffices.
    sum += (2 * rank - 1) * std::log(below) + (2 * (n - rank) + 1) * std::log(tail(fit, ascending[i]));
  }
  found.anderson_darling = -n - sum / n;
  return found;
}

/// Stephens (1974): D times this has a law that hardly depends on n.
static double lilliefors_scale(std::size_t count) {
  const double root = std::sqrt(static_cast<double>(count));
  return root - 0.01 + 0.85 / root;
}

// ---- simulated samples: of location 0 and scale 1 ----

namespace {

/// Numbers evenly distributed in (0, 1).
std::vector<double> uniforms(std::size_t count, RandomStream stream) {
  std::vector<std::uint64_t> words(count);
  fill_words(words, stream);
  std::vector<double> numbers;
  for (const std::uint64_t word : words) numbers.push_back((static_cast<double>(word >> 12) + 0.5) * 0x1p-52);
  return numbers;
}

}  // namespace

static void fill_gev(std::span<double> sample, double shape, RandomStream stream) {
  const std::vector<double> u = uniforms(sample.size(), stream);
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const double y = -std::log(-std::log(u[i]));  // Gumbel variate
    sample[i] = std::abs(shape * y) < 1e-8 ? y * (1 + shape * y / 2) : std::expm1(shape * y) / shape;
  }
}

/// Marsaglia and Tsang (2000): d (1 + z / sqrt(9 d))^3 with d = shape - 1/3, which more than 95 of 100 pairs of z and u pass. Below shape 1
/// by that of shape + 1 times u^(1 / shape). Each round has a stream of its own, so that a sample is what it is wherever it is made.
static void fill_gamma(std::span<double> sample, double shape, RandomStream stream) {
  const double d = (shape < 1 ? shape + 1 : shape) - 1.0 / 3;
  const RandomStream of_uniforms{stream.seed, purpose("uniform numbers of gamma"), stream.sample};
  std::vector<double> z(2 * sample.size() + 20);
  fill_normals(z, stream);
  const std::vector<double> u = uniforms(2 * z.size(), of_uniforms);
  std::size_t made = 0;
  for (std::size_t i = 0; i < z.size() && made < sample.size(); ++i) {
    const double v = std::pow(1 + z[i] / std::sqrt(9 * d), 3);
    if (v <= 0 || std::log(u[2 * i]) >= z[i] * z[i] / 2 + d - d * v + d * std::log(v)) continue;
    sample[made++] = d * v * (shape < 1 ? std::pow(u[2 * i + 1], 1 / shape) : 1);
  }
}

static void fill_sample(std::span<double> sample, const Fit& fit, RandomStream stream) {
  switch (fit.family) {
    case Family::normal:
    case Family::lognormal:  // in ln x
      return fill_normals(sample, stream);
    case Family::gamma:
      return fill_gamma(sample, fit.parameters[0], stream);
    case Family::weibull: {  // of shape 1
      const std::vector<double> u = uniforms(sample.size(), stream);
      std::transform(u.begin(), u.end(), sample.begin(), [](double number) { return -std::log(number); });
      return;
    }
    case Family::gev:
      return fill_gev(sample, fit.parameters[2], stream);
  }
}

std::optional<NullDistances> simulated_distances(const Fit& fit, std::size_t count, std::size_t simulations, std::uint64_t seed) {
  if (count < 5) return std::nullopt;
  const Family family = fit.family == Family::lognormal ? Family::normal : fit.family;
  NullDistances result{std::min(count, simulated_at_most(family)), {}, {}};
  std::vector<double> sample(result.count);
  for (std::uint32_t k = 1; k <= simulations; ++k) {
    fill_sample(sample, fit, {seed, purpose("goodness of " + name_of(family)), k});
    const std::optional<Fit> own = fit_of(family, sample);
    if (!own) continue;  // a GEV whose likelihood has no maximum
    const Distances found = distances(*own, sample);
    result.anderson_darling.push_back(found.anderson_darling);
    result.lilliefors.push_back(found.lilliefors * lilliefors_scale(result.count));
  }
  std::sort(result.anderson_darling.begin(), result.anderson_darling.end());
  std::sort(result.lilliefors.begin(), result.lilliefors.end());
  return result;
}

/// Share of the simulated values, and the one found, that are at least as large.
static double share_above(const std::vector<double>& ascending, double found) {
  const auto hits = ascending.end() - std::lower_bound(ascending.begin(), ascending.end(), found);
  return (1 + static_cast<double>(hits)) / (1 + static_cast<double>(ascending.size()));
}

DistanceP p_values(const Distances& found, std::size_t count, const NullDistances& simulated) {
  return {share_above(simulated.anderson_darling, found.anderson_darling),
          share_above(simulated.lilliefors, found.lilliefors * lilliefors_scale(count))};
}

}  // namespace slidezone
