// Statistics: fitted distributions, how well they fit, and the fitted tail.
#include "stats/distribution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/random.hpp"
#include "stats/goodness.hpp"
#include "stats/tail.hpp"
#include "stats_samples.hpp"

namespace slidezone {
namespace {

// ---- distributions ----

TEST(Fit, RecoversMeanAndSdOfTheLogarithm) {
  const std::vector<double> values = {std::exp(1.0), std::exp(2.0), std::exp(3.0)};
  const auto fit = fit_of(Family::lognormal, values);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->parameters[0], 2, 1e-15);
  EXPECT_NEAR(fit->parameters[1], 1, 1e-15);
  EXPECT_NEAR(tail(*fit, std::exp(2.0)), 0.5, 1e-15);
  EXPECT_NEAR(cumulative(*fit, std::exp(3.0)), 0.841344746068543, 1e-15);  // Phi(1)
  EXPECT_EQ(cumulative(*fit, -1), 0);
  EXPECT_EQ(tail(*fit, 0), 1);
}

TEST(Fit, IsRefusedWhereThereIsNone) {
  EXPECT_FALSE(fit_of(Family::lognormal, std::vector<double>{0, 1, 2}));
  EXPECT_FALSE(fit_of(Family::normal, std::vector<double>{1, 1}));
  EXPECT_FALSE(fit_of(Family::normal, std::vector<double>{1}));
}

/// Parameters and AIC of optim() on R's densities, to the 6 or 7 digits that its simplex reaches.
TEST(Fit, OfMaximumLikelihoodMatchesR) {
  struct Reference {
    Family family;
    std::vector<double> parameters;
    double aic;
    double tolerance;  // of the parameters
  };
  const Reference references[] = {{Family::normal, {}, 109.595684208692, 0},
                                  {Family::lognormal, {}, 106.209920934398, 0},
                                  {Family::gamma, {30.202152157658674, 0.349842617442206}, 107.074737513144, 1e-5},
                                  {Family::weibull, {5.11703191840906, 11.41498240736692}, 113.453639596053, 1e-6},
                                  {Family::gev, {9.6605449907618919, 1.5552558776876355, 0.0034674643401202}, 107.120217159406, 1e-5}};
  for (const Reference& reference : references) {
    const auto fit = fit_of(reference.family, distances_25);
    ASSERT_TRUE(fit) << name_of(reference.family);
    for (std::size_t i = 0; i < reference.parameters.size(); ++i)
      EXPECT_NEAR(fit->parameters[i], reference.parameters[i], reference.tolerance) << name_of(reference.family) << i;
    EXPECT_NEAR(akaike_criterion(*fit, distances_25), reference.aic, 1e-9) << name_of(reference.family);
  }
}

TEST(Fit, DensityIsTheSlopeOfTheCumulativeAndTailTheRest) {
  for (const Family family : families) {
    const Fit fit = *fit_of(family, distances_25);
    for (const double x : {5.0, 8.0, 10.5, 15.0, 20.0}) {
      const double h = 1e-5;  // rounding 1e-16 / h and truncation h^2 are both near 1e-10
      EXPECT_NEAR((cumulative(fit, x + h) - cumulative(fit, x - h)) / (2 * h), density(fit, x), 1e-9) << name_of(family) << x;
      EXPECT_NEAR(cumulative(fit, x) + tail(fit, x), 1, 1e-15) << name_of(family) << x;
    }
  }
}

TEST(Fit, OfScaledValuesIsScaled) {
  std::vector<double> scaled = distances_25;
  for (double& value : scaled) value *= 1000;
  for (const Family family : {Family::gamma, Family::weibull, Family::gev}) {
    const Fit fit = *fit_of(family, distances_25);
    const Fit large = *fit_of(family, scaled);
    EXPECT_NEAR(tail(large, 14000), tail(fit, 14), 1e-7)
        << name_of(family);  // the GEV's simplex stops at 1e-9 of its likelihood's arguments
  }
}

TEST(Gev, KnowsItsEndAndItsGumbelLimit) {
  const Fit bounded{Family::gev, {0, 1, -0.5}};  // ends at 2
  EXPECT_EQ(cumulative(bounded, 2.5), 1);
  EXPECT_EQ(tail(bounded, 2.5), 0);
  EXPECT_EQ(density(bounded, 2.5), 0);
  const Fit heavy{Family::gev, {0, 1, 0.5}};  // begins at -2
  EXPECT_EQ(cumulative(heavy, -2.5), 0);
  const Fit gumbel{Family::gev, {0, 1, 0}};
  const Fit near_gumbel{Family::gev, {0, 1, 1e-9}};
  EXPECT_DOUBLE_EQ(cumulative(gumbel, 1), std::exp(-std::exp(-1.0)));
  EXPECT_NEAR(cumulative(near_gumbel, 1), cumulative(gumbel, 1), 1e-9);
}

// ---- goodness of fit ----

TEST(Distances, MatchNortestOfR) {
  const Distances normal = distances(*fit_of(Family::normal, distances_25), distances_25);
  EXPECT_NEAR(normal.anderson_darling, 0.5149290812851, 1e-12);
  EXPECT_NEAR(normal.lilliefors, 0.1343589578166, 1e-12);
  const Distances lognormal = distances(*fit_of(Family::lognormal, distances_25), distances_25);
  EXPECT_NEAR(lognormal.anderson_darling, 0.2197170271949, 1e-12);
  EXPECT_NEAR(lognormal.lilliefors, 0.0982372881763, 1e-12);
}

TEST(Distances, HaveTheirSimulatedP) {
  // nortest's approximations give .174, .290 and .816, .772; they are good to .01, 4000 simulations to 2 sqrt(p (1 - p) / 4000) = .016.
  const auto simulated = simulated_distances({Family::normal, {}}, 25, 4000, 1);
  ASSERT_TRUE(simulated);
  const DistanceP normal = p_values(distances(*fit_of(Family::normal, distances_25), distances_25), 25, *simulated);
  EXPECT_NEAR(normal.anderson_darling, 0.1737, 0.025);
  EXPECT_NEAR(normal.lilliefors, 0.2897, 0.025);
  const DistanceP lognormal = p_values(distances(*fit_of(Family::lognormal, distances_25), distances_25), 25, *simulated);
  EXPECT_NEAR(lognormal.anderson_darling, 0.8155, 0.025);
  EXPECT_NEAR(lognormal.lilliefors, 0.7717, 0.025);
}

TEST(Distances, SimulatedLimitsAreThePublishedOnes) {
  // 5 % points: A^2 (1 + .75 / n + 2.25 / n^2) = .752 and scaled D = .895 for a Normal, A^2 (1 + .2 / sqrt(n)) = .757 for a Weibull
  // (D'Agostino and Stephens 1986). The 95 % point of 4000 simulations scatters by .02 (two standard errors).
  const std::size_t place = 3800;
  const auto normal = simulated_distances({Family::normal, {}}, 100, 4000, 1);
  EXPECT_NEAR(normal->anderson_darling[place] * (1 + 0.75 / 100), 0.752, 0.025);
  EXPECT_NEAR(normal->lilliefors[place], 0.895, 0.02);
  const auto weibull = simulated_distances({Family::weibull, {}}, 100, 4000, 1);
  EXPECT_NEAR(weibull->anderson_darling[place] * (1 + 0.02), 0.757, 0.025);
}

TEST(Distances, SimulatedLimitsOfGammaAreThePublishedOnes) {
  // 5 % points of A^2: .786 at shape 1; large shapes tend to the Normal's .752 (Lockhart and Stephens 1985). The GEV has none in print:
  // with one parameter more, its limit lies below the .757 of Gumbel's law.
  const auto limit = [](const Fit& fit) {
    const auto simulated = simulated_distances(fit, 100, 2000, 1);
    return simulated->anderson_darling[static_cast<std::size_t>(0.95 * static_cast<double>(simulated->anderson_darling.size()))];
  };
  EXPECT_NEAR(limit({Family::gamma, {1, 1}}), 0.786, 0.05);  // 2000 simulations scatter by 0.035 (two standard errors)
  EXPECT_NEAR(limit({Family::gamma, {400, 1}}), 0.752, 0.05);
  EXPECT_LT(limit({Family::gev, {0, 1, 0.2}}), 0.757);
}

TEST(Distances, PValuesOfSamplesOfTheirOwnFamilyAreEven) {
  // Halves of squared normal numbers are gamma of shape 1/2. The mean of 40 even p values is 1/2 within 2 sqrt(1 / 12 / 40) = 0.09.
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    std::vector<double> values(60);
    fill_normals(values, {seed, purpose("squares"), 1});
    for (double& value : values) value = value * value / 2;
    const Fit fit = *fit_of(Family::gamma, values);
    sum += p_values(distances(fit, values), 60, *simulated_distances(fit, 60, 200, seed)).anderson_darling;
  }
  EXPECT_NEAR(sum / 40, 0.5, 0.1);
}

TEST(ChiSquare, IsZeroForValuesSpreadAsTheFit) {
  // 120 values at the middles of 120 equal probabilities of the fit.
  const Fit fit{Family::lognormal, {0, 1}};
  std::vector<double> values;
  for (int i = 0; i < 120; ++i) {
    double low = -10, high = 10;  // bisection of the cumulative in ln x
    for (int step = 0; step < 60; ++step) {
      const double middle = (low + high) / 2;
      (cumulative(fit, std::exp(middle)) < (i + 0.5) / 120 ? low : high) = middle;
    }
    values.push_back(std::exp(low));
  }
  const auto test = chi_square(fit, values);  // 2 * 120^0.4 = 13.6
  ASSERT_TRUE(test);
  EXPECT_EQ(test->bins, 13u);
  EXPECT_EQ(test->degrees_of_freedom, 10u);
  EXPECT_LT(test->statistic, 0.84);  // bins of 9 and 10 for 9.23 expected: at most 13 * 0.77^2 / 9.23
  EXPECT_GT(test->p, 0.999);         // 10 degrees of freedom exceed 0.84 with probability 0.9999
}

TEST(ChiSquare, SeesTwoHeapsAndWantsTwentyValues) {
  std::vector<double> heaps;
  for (int i = 0; i < 100; ++i) heaps.push_back((i % 2 == 0 ? 7 : 11) + 0.001 * i);
  EXPECT_LT(chi_square(*fit_of(Family::normal, heaps), heaps)->p, 1e-9);
  EXPECT_FALSE(chi_square(Fit{Family::normal, {10, 5}}, one_to(19)));
  EXPECT_TRUE(chi_square(Fit{Family::normal, {10, 5}}, one_to(20)));
}

// ---- tails ----

/// Quantiles of a Gumbel distribution.
std::vector<double> gumbel_values() {
  std::vector<double> values;
  for (int i = 1; i <= 200; ++i) values.push_back(10 - 2 * std::log(-std::log((i - 0.5) / 200)));
  return values;
}

TEST(Tail, MatchesLikelihoodAndProfileInR) {
  // optim() on the same likelihood, and uniroot() on its profile, in R 4.2.2; the search ends within 1e-7.
  const TailFit fit = *tail_fit(gumbel_values());
  EXPECT_NEAR(fit.threshold, 13.5979979459, 1e-10);
  EXPECT_EQ(fit.exceedances, 30u);
  EXPECT_NEAR(fit.scale, 2.3106400767, 1e-6);
  EXPECT_NEAR(fit.shape, -0.1021672227, 1e-6);
  const Estimate far = tail_quantile(fit, gumbel_values(), 0.001);
  EXPECT_NEAR(far.value, 22.65937918, 1e-5);
  EXPECT_NEAR(far.interval.low, 20.17266156, 1e-5);
  EXPECT_NEAR(far.interval.high, 42.93833122, 1e-3);  // where the profile is flat
}

TEST(Tail, JoinsTheSampleAtTheThresholdAndHasTheQuantilesOfItsLaw) {
  const TailFit fit = *tail_fit(gumbel_values());
  EXPECT_DOUBLE_EQ(fit.share, 0.15);
  const auto exceedance = [&](double x) { return fit.share * std::pow(1 + fit.shape * (x - fit.threshold) / fit.scale, -1 / fit.shape); };
  for (const double p : {0.1, 0.01, 1e-4}) EXPECT_NEAR(exceedance(tail_quantile(fit, gumbel_values(), p).value), p, 1e-12) << p;
  EXPECT_LT(fit.distance, 0.05);  // steps of 1 / 30 about a smooth tail: half of that to either side, twice for the fit's own error
}

TEST(Tail, WithAnEndIsBounded) {
  std::vector<double> values;  // shape -1/2, ends at 1
  for (int i = 1; i <= 1000; ++i) values.push_back(1 - std::sqrt(1 - (i - 0.5) / 1000));
  const TailFit fit = *tail_fit(values);
  EXPECT_NEAR(fit.shape, -0.5, 0.1);
  EXPECT_LT(fit.threshold - fit.scale / fit.shape, 1.2);
  EXPECT_LT(tail_quantile(fit, values, 1e-9).value, 1.05);
}

TEST(Tail, WantsThirtyExceedancesThatDiffer) {
  EXPECT_FALSE(tail_fit(one_to(59)));
  EXPECT_FALSE(tail_fit(std::vector<double>(1000, 1.0)));
}

}  // namespace
}  // namespace slidezone
