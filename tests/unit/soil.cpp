#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "soil/drucker_prager.hpp"

namespace slidezone {
namespace {

constexpr SoilTraits cohesive{.has_cone = false, .has_softening = false};
constexpr SoilTraits general{.has_cone = true, .has_softening = true};

double tau(const Stress& s) {
  const double mean = (s.xx + s.yy + s.zz) / 3;
  return std::sqrt(0.5 * (std::pow(s.xx - mean, 2) + std::pow(s.yy - mean, 2) + std::pow(s.zz - mean, 2)) + s.xy * s.xy);
}
double mean_stress(const Stress& s) { return (s.xx + s.yy + s.zz) / 3; }

Material frictional() {
  return {.density = 2000,
          .youngs_modulus = 10e6,
          .poisson_ratio = 0.3,
          .peak_cohesion = 5e3,
          .residual_cohesion = 5e3,
          .peak_friction_angle = 0.5,
          .residual_friction_angle = 0.5,
          .dilation_angle = 0.1};
}

// Reference: an independent return mapping; digits as printed there, hence tolerances of half a digit.
const Material reference_soil{.density = 1, .youngs_modulus = 10e6, .poisson_ratio = 0.3, .peak_cohesion = 2000, .residual_cohesion = 2000};

/// The elastic trial stress of its point of shear: compressed along x by 0.001.
template <class Real>
StressOf<Real> reference_trial() {
  const ElasticModuli moduli = elastic_moduli(reference_soil);
  const double along = (moduli.bulk + 4 * moduli.shear / 3) * -0.001;
  const double across = (moduli.bulk - 2 * moduli.shear / 3) * -0.001;
  return {static_cast<Real>(-5000 + along), static_cast<Real>(-6000 + across), static_cast<Real>(-7000 + across), -1000};
}

/// Returns it to the yield surface and holds the result against the reference.
template <class Real>
void expect_reference(double stress_tolerance, double strain_tolerance) {
  const auto soil = soil_constants<Real>(reference_soil);
  StressOf<Real> stress = reference_trial<Real>();
  const Real plastic = return_to_yield<cohesive>(stress, soil, yield_surface<cohesive>(soil, Real{2000}, Real{0}));
  EXPECT_NEAR(stress.xx, -16537.46896, stress_tolerance);
  EXPECT_NEAR(stress.yy, -12964.30500, stress_tolerance);
  EXPECT_NEAR(stress.zz, -13498.22605, stress_tolerance);
  EXPECT_NEAR(stress.xy, -533.92105, stress_tolerance);
  EXPECT_NEAR(plastic, 2.620747e-4, strain_tolerance);
}

TEST(ReturnMapping, GivesTheReferencePointOfShear) {
  EXPECT_NEAR(tau(reference_trial<double>()), 3745.87215, 5e-6);
  expect_reference<double>(5e-6, 5e-11);
}

TEST(ReturnMapping, IsGoodToTheLastBitsOfAFloat) {
  expect_reference<float>(4e-3, 1e-9);  // neighbouring floats of 16 kPa are 2e-3 Pa apart
}

TEST(ReturnMapping, LeavesElasticStatesAlone) {
  const SoilConstants soil = soil_constants(frictional());
  const YieldSurface yield = yield_surface<general>(soil, 5e3, 0);
  Stress stress{-10e3, -12e3, -11e3, 1e3};
  const Stress before = stress;
  EXPECT_EQ(return_to_yield<general>(stress, soil, yield), 0);
  EXPECT_NEAR(stress.xx, before.xx, 1e-11);
  EXPECT_NEAR(stress.xy, before.xy, 1e-12);
}

/// A stress with the given invariants.
Stress with_invariants(double mean, double t) { return {mean + t, mean - t, mean, 0}; }

TEST(ReturnMapping, ReturnsToTheConeAlongTheFlow) {
  const SoilConstants soil = soil_constants(frictional());
  const YieldSurface yield = yield_surface<general>(soil, 5e3, 0);
  Stress stress = with_invariants(-20e3, 40e3);
  return_to_yield<general>(stress, soil, yield);
  EXPECT_NEAR(tau(stress) + yield.q_phi * mean_stress(stress) - yield.k_c, 0, 1e-9);
  // The return moves by (G, K q_psi) in the plane of (tau, mean stress).
  EXPECT_NEAR((-20e3 - mean_stress(stress)) / (40e3 - tau(stress)), soil.bulk * soil.q_psi / soil.shear, 1e-12);
}

TEST(ReturnMapping, CutsTensionOffAndMeetsBothSurfacesAtTheCorner) {
  Material material = frictional();
  material.tension_cutoff = 1e3;
  const SoilConstants soil = soil_constants(material);
  const YieldSurface yield = yield_surface<general>(soil, 5e3, 0);
  ASSERT_EQ(yield.tension, 1e3);

  Stress pure = with_invariants(9e3, 0.5e3);
  const double plastic = return_to_yield<general>(pure, soil, yield);
  EXPECT_NEAR(mean_stress(pure), 1e3, 1e-9);
  EXPECT_NEAR(tau(pure), 0.5e3, 1e-9);
  EXPECT_NEAR(plastic, std::numbers::sqrt2 / 3 * 8e3 / soil.bulk, 1e-15);

  Stress corner = with_invariants(20e3, 20e3);
  return_to_yield<general>(corner, soil, yield);
  EXPECT_NEAR(mean_stress(corner), 1e3, 1e-9);
  EXPECT_NEAR(tau(corner), yield.k_c - yield.q_phi * 1e3, 1e-9);
}

TEST(ReturnMapping, NeverLeavesAStateOutside) {
  Material material = frictional();
  material.tension_cutoff = 2e3;
  const SoilConstants soil = soil_constants(material);
  const YieldSurface yield = yield_surface<general>(soil, 5e3, 0);
  for (double mean = -50e3; mean <= 50e3; mean += 1.7e3)
    for (double t = 0; t <= 60e3; t += 1.3e3) {
      Stress stress = with_invariants(mean, t);
      EXPECT_GE(return_to_yield<general>(stress, soil, yield), 0);
      EXPECT_LE(tau(stress) + yield.q_phi * mean_stress(stress) - yield.k_c, 1e-8);
      EXPECT_LE(mean_stress(stress), yield.tension + 1e-8);
    }
}

TEST(ReturnMapping, StopsAtTheApexWithoutACutOff) {
  const SoilConstants soil = soil_constants(frictional());
  const YieldSurface yield = yield_surface<general>(soil, 5e3, 0);
  EXPECT_NEAR(yield.tension, yield.k_c / yield.q_phi, 1e-9);
  Stress stress = with_invariants(100e3, 10e3);
  return_to_yield<general>(stress, soil, yield);
  EXPECT_NEAR(mean_stress(stress), yield.tension, 1e-9);
  EXPECT_NEAR(tau(stress), 0, 1e-8);
}

TEST(ReturnMapping, TakesSoilWithoutAnyStrength) {
  Material water{.density = 1000, .youngs_modulus = 1e6, .poisson_ratio = 0.3};
  const SoilConstants soil = soil_constants(water);
  for (const Stress& start : {Stress{0, 0, 0, 0}, Stress{-1e3, -2e3, -3e3, 5e2}}) {
    Stress stress = start;
    return_to_yield<general>(stress, soil, yield_surface<general>(soil, 0, 0));
    EXPECT_NEAR(tau(stress), 0, 1e-10);
    EXPECT_NEAR(mean_stress(stress), mean_stress(start), 1e-10);
  }
}

TEST(Softening, FallsFromPeakToResidualBeyondTheThreshold) {
  Material material = frictional();
  material.peak_cohesion = 20e3;
  material.residual_cohesion = 4e3;
  material.residual_friction_angle = 0.2;
  material.softening_threshold = 0.1;
  material.softening_shape = 8;
  const SoilConstants soil = soil_constants(material);
  const auto matched = [](double angle) { return 3 / std::sqrt(9 + 12 * std::pow(std::tan(angle), 2)); };
  EXPECT_NEAR(yield_surface<general>(soil, 20e3, 0.1).k_c, 20e3 * matched(0.5), 1e-9);
  const double part = std::exp(-8 * 0.15);
  const double angle = 0.2 + 0.3 * part;
  const YieldSurface yield = yield_surface<general>(soil, 20e3, 0.25);
  EXPECT_NEAR(yield.k_c, (4e3 + 16e3 * part) * matched(angle), 1e-9);
  EXPECT_NEAR(yield.q_phi, std::tan(angle) * matched(angle), 1e-13);
  EXPECT_NEAR(yield_surface<general>(soil, 20e3, 1e6).k_c, 4e3 * matched(0.2), 1e-9);
}

}  // namespace
}  // namespace slidezone
