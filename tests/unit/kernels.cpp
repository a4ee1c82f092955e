// Material point method: whatever instruction set, kernel and number of threads a run takes, its result is the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "mpm/simulation.hpp"
#include "mpm/strips.hpp"
#include "mpm_models.hpp"

namespace slidezone {
namespace {

constexpr InstructionSet every_set[] = {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512_in_halves,
                                        InstructionSet::avx512};

// ---- kernels --------------------------------------------------------------------------------------------------------------------

TEST(Simulate, GivesTheSameOnEveryInstructionSet) {
  const Outcome plain = simulate(deforming_block(), {}, Kernel{InstructionSet::baseline, {}});
  for (const InstructionSet set : every_set) {
    if (set > best_instruction_set()) continue;
    EXPECT_LT(worst_distance(simulate(deforming_block(), {}, Kernel{set, {}}).points, plain.points), 1e-11);
  }
}

TEST(Simulate, LetsSoilWithoutStressOrStrengthAlone) {  // tau is 0 then, and its reciprocal is not
  Material mud = clay;
  mud.peak_cohesion = mud.residual_cohesion = 0;
  Model still = block(3.1, 1.33, 5, 4, mud);
  still.gravity.acceleration = {0, 0};
  for (const Model& model : {still, in_single_precision(still)})
    for (const InstructionSet set : every_set) {
      if (set > best_instruction_set()) continue;
      const Points points = simulate(model, {}, Kernel{set, {}}).points;
      EXPECT_EQ(points.plastic_strain, PointNumbers<double>(points.count(), 0.0)) << static_cast<int>(set);
      EXPECT_EQ(points.xx, PointNumbers<double>(points.count(), 0.0)) << static_cast<int>(set);
    }
}

TEST(Simulate, GivesEqualBitsTwice) { EXPECT_EQ(simulate(deforming_block()).points.x, simulate(deforming_block()).points.x); }

TEST(Simulate, IsNotChangedByAnObserverThatLooks) {
  const Outcome seen = simulate(deforming_block(), [](const Moment& moment) {
    if (moment.step % 7 == 0) {
      EXPECT_EQ(moment.points().label[3], 3);
    }
  });
  EXPECT_EQ(seen.points.x, simulate(deforming_block()).points.x);
}

TEST(Simulate, LeavingOutWhatNoSoilNeedsChangesNoBit) {
  const std::vector<Model> models = {
      deforming_block(),
      in_single_precision(deforming_block()),
      deforming_block_of([](Material& soil) { soil.residual_cohesion = soil.peak_cohesion, soil.softening_shape = 0; }),
      deforming_block_of([](Material& soil) { soil.peak_friction_angle = 0.2, soil.dilation_angle = 0.05; }),
      deforming_block_of([](Material& soil) { soil.tension_cutoff = 1e3; }),
      in_single_precision(deforming_block_of([](Material& soil) { soil.peak_friction_angle = 0.2, soil.dilation_angle = 0.05; })),
  };
  for (const Model& model : models)
    for (const InstructionSet set : every_set) {
      if (set > best_instruction_set()) continue;
      const SoilTraits needed = soil_traits(model);
      const Points lean = simulate(model, {}, Kernel{set, needed}).points;
      EXPECT_GT(*std::max_element(lean.plastic_strain.begin(), lean.plastic_strain.end()), 0.05);
      for (const bool has_cone : {needed.has_cone, true})
        for (const bool has_softening : {needed.has_softening, true})
          for (const bool has_layers : {false, true}) {
            const Points full = simulate(model, {}, Kernel{set, {has_cone, has_softening, has_layers}}).points;
            const std::string which =
                std::to_string(static_cast<int>(set)) + (has_cone ? " cone" : "") + (has_softening ? " softening" : "");
            EXPECT_EQ(full.x, lean.x) << which;
            EXPECT_EQ(full.xx, lean.xx) << which;
            EXPECT_EQ(full.plastic_strain, lean.plastic_strain) << which;
          }
    }
}

TEST(Simulate, TakesTheLeanestKernel) {
  const auto traits = [](auto change) { return kernel_for(deforming_block_of(change)).traits; };
  EXPECT_FALSE(traits([](Material&) {}).has_cone);
  EXPECT_TRUE(traits([](Material&) {}).has_softening);
  EXPECT_FALSE(traits([](Material&) {}).has_layers);
  EXPECT_FALSE(traits([](Material& soil) { soil.residual_cohesion = soil.peak_cohesion, soil.softening_shape = 0; }).has_softening);
  EXPECT_TRUE(traits([](Material& soil) { soil.peak_friction_angle = 0.2; }).has_cone);
  EXPECT_TRUE(traits([](Material& soil) { soil.tension_cutoff = 0; }).has_cone);
}

TEST(Simulate, SoilOfPointsStandsForLayersOfTheSameSoil) {
  // Points of two soils in turn: as two layers, and as a soil of each point's own. Points move from cell to cell, so that they are
  // put in another order on the way.
  Model layers = deforming_block();
  layers.soils.push_back(clay);
  layers.soils[1].youngs_modulus *= 2;
  layers.soils[1].peak_friction_angle = 0.2;
  for (std::size_t p = 1; p < layers.points.count(); p += 2) layers.points.soil[p] = 1;
  Model own = layers;
  own.soils[0] = own.soils[1] = elastic;
  for (const int soil : layers.points.soil) own.point_soils.push_back(layers.soils[static_cast<std::size_t>(soil)]);
  EXPECT_EQ(step_limit(own), step_limit(layers));
  EXPECT_EQ(soil_of(own, own.points, 3).peak_friction_angle, 0.2);
  const Outcome expected = simulate(layers), found = simulate(own);
  EXPECT_EQ(found.points.x, expected.points.x);
  EXPECT_EQ(found.points.yy, expected.points.yy);
}

// ---- threads --------------------------------------------------------------------------------------------------------------------

TEST(Simulate, GivesEqualBitsForAnyNumberOfThreads) {
  ASSERT_GE(large_block(1).points.count(), Strips::least_points);
  for (const Scheme& method : {Scheme{}, Scheme{.anti_locking = AntiLocking::b_bar}, Scheme{.precision = Precision::single_precision}}) {
    const auto outcome = [&](int threads) {
      Model model = large_block(threads);
      model.method = method;
      return simulate(model);
    };
    const Outcome alone = outcome(1);
    EXPECT_GT(alone.points.x.back() - large_block(1).points.x.back(), 16 * 0.2);  // beyond two strips
    EXPECT_LT(std::abs(alone.energy.error()), 0.01);
    for (const int threads : {2, 5}) {
      const Outcome shared = outcome(threads);
      EXPECT_EQ(shared.points.x, alone.points.x) << threads;
      EXPECT_EQ(shared.points.xy, alone.points.xy) << threads;
      for (const auto part : {&EnergyAudit::gravity_work, &EnergyAudit::internal_work, &EnergyAudit::friction_work, &EnergyAudit::kinetic})
        EXPECT_EQ(shared.energy.*part, alone.energy.*part) << threads;
    }
  }
}

TEST(Simulate, StripsChangeNothingButTheOrderOfSums) {
  // Half of the large block is below the limit: with its mirror image at the other wall it is above it and is divided.
  Model single = block(0, 0, 100, 126, clay);
  single.grid = {0.2, 0.2, 400, 140};
  single.boundaries = {.base_friction = 0.3, .right = Wall::roller};
  single.time.end = 0.1;
  Model twin = block(0, 0, 100, 126, clay);
  const Model second = block(60, 0, 100, 126, clay);
  for (std::size_t p = 0; p < second.points.count(); ++p) {
    twin.points.x.push_back(second.points.x[p]);
    twin.points.y.push_back(second.points.y[p]);
  }
  Points all = points_at_rest(twin.points.x.size());
  all.x = twin.points.x;
  all.y = twin.points.y;
  std::fill(all.volume.begin(), all.volume.end(), 0.01);
  std::fill(all.mass.begin(), all.mass.end(), 0.01 * clay.density);
  std::fill(all.peak_cohesion.begin(), all.peak_cohesion.end(), clay.peak_cohesion);
  twin.points = all;
  twin.grid = single.grid;
  twin.boundaries = single.boundaries;
  twin.time = single.time;
  ASSERT_LT(single.points.count(), Strips::least_points);
  ASSERT_GE(twin.points.count(), Strips::least_points);
  const Outcome outcome = simulate(single);
  const Outcome divided = simulate(twin);
  const Points& expected = outcome.points;
  const Points& found = divided.points;
  constexpr std::size_t rows = 252;  // points in a column of them
  double worst = 0;
  double movement = 0;
  for (std::size_t p = 0; p < expected.count(); ++p) {
    const std::size_t image = found.count() - (p / rows + 1) * rows + p % rows;
    worst = std::max({worst, std::abs(found.x[p] - expected.x[p]), std::abs(found.y[p] - expected.y[p])});
    worst = std::max({worst, std::abs(twin.grid.width() - found.x[image] - expected.x[p]), std::abs(found.y[image] - expected.y[p])});
    movement = std::max(movement, std::abs(expected.y[p] - single.points.y[p]));
  }
  EXPECT_GT(movement, 1e-3);
  EXPECT_LT(worst, 1e-11);
  EXPECT_GT(outcome.energy.friction_work, 1);
  EXPECT_NEAR(divided.energy.friction_work / outcome.energy.friction_work, 2, 1e-9);
  EXPECT_NEAR(divided.energy.gravity_work / outcome.energy.gravity_work, 2, 1e-9);
  EXPECT_NEAR(divided.energy.internal_work / outcome.energy.internal_work, 2, 1e-9);
}

}  // namespace
}  // namespace slidezone
