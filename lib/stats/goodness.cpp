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

/// A sample of the standard member: Normal, or Weibull of shape 1 by minus the logarithm of a uniform number.
static void fill_sample(std::span<double> sample, Family family, RandomStream stream) {
  if (family != Family::weibull) return fill_normals(sample, stream);
  std::vector<std::uint64_t> words(sample.size());
  fill_words(words, stream);
  for (std::size_t i = 0; i < sample.size(); ++i) sample[i] = -std::log((static_cast<double>(words[i] >> 12) + 0.5) * 0x1p-52);
}

std::optional<NullDistances> simulated_distances(Family family, std::size_t count, std::size_t simulations, std::uint64_t seed) {
  if (family == Family::gamma || family == Family::gev || count < 5) return std::nullopt;
  const Family standard = family == Family::lognormal ? Family::normal : family;
  NullDistances result{std::min(count, simulated_at_most), {}, {}};
  std::vector<double> sample(result.count);
  for (std::uint32_t k = 1; k <= simulations; ++k) {
    fill_sample(sample, standard, {seed, purpose("goodness of " + name_of(standard)), k});
    const Distances found = distances(*fit_of(standard, sample), sample);
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
