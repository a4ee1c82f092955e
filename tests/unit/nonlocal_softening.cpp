// Material point method: the nonlocal average of plastic strain.
#include "mpm/nonlocal_softening.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "mpm_models.hpp"

namespace slidezone {
namespace {

TEST(NonlocalSoftening, LeavesAUniformStrainAlone) {
  Model model = block(0, 0, 10, 6, clay);
  std::fill(model.points.plastic_strain.begin(), model.points.plastic_strain.end(), 0.05);
  NonlocalAverage average(model.points, model.soils, 0.1, 0.1, {.length = 0.6, .factor = 2});
  PointNumbers<double> strain(model.points.count(), 0.0);
  average.update(model.points, strain);
  for (const double value : strain) EXPECT_NEAR(value, 0.05, 1e-14);  // also at the edges and corners
}

TEST(NonlocalSoftening, IsTheGaussianAverageOfACappedPoint) {
  Model model = block(0, 0, 20, 20, clay);
  const std::size_t middle = 20 * 40 + 20;
  model.points.plastic_strain[middle] = 99;
  const double cap = 0.01 + 4.0 / 8;
  PointNumbers<double> strain(model.points.count(), 0.0);
  NonlocalAverage(model.points, model.soils, 0.1, 0.1, {.length = 0.6, .factor = 1}).update(model.points, strain);
  const auto weight = [](int k) { return std::abs(k) <= 9 ? std::exp(-0.5 * std::pow(k * 0.1 / 0.3, 2)) : 0; };
  double sum = 0;
  for (int k = -9; k <= 9; ++k) sum += weight(k);
  EXPECT_NEAR(strain[middle + 3], cap * weight(3) / (sum * sum), 1e-15);
  EXPECT_NEAR(strain[middle + 2 * 40], cap * weight(2) / (sum * sum), 1e-15);
  EXPECT_EQ(strain[middle + 12], 0);
}

TEST(NonlocalSoftening, NeverGivesStrengthBack) {
  Model model = block(0, 0, 10, 6, clay);
  NonlocalAverage average(model.points, model.soils, 0.1, 0.1, {.length = 0.6, .factor = 2});
  PointNumbers<double> strain(model.points.count(), 0.2);
  average.update(model.points, strain);
  EXPECT_EQ(*std::min_element(strain.begin(), strain.end()), 0.2);
}

TEST(NonlocalSoftening, KeepsSoilsApart) {
  Model model = block(0, 0, 10, 6, clay);
  model.soils.push_back(clay);
  for (std::size_t p = 0; p < model.points.count(); ++p) {
    model.points.soil[p] = model.points.y[p] > 0.6 ? 1 : 0;
    model.points.plastic_strain[p] = model.points.soil[p] == 1 ? 0.3 : 0;
  }
  PointNumbers<double> strain(model.points.count(), 0.0);
  NonlocalAverage(model.points, model.soils, 0.1, 0.1, {.length = 0.6, .factor = 2}).update(model.points, strain);
  for (std::size_t p = 0; p < model.points.count(); ++p) EXPECT_NEAR(strain[p], model.points.soil[p] == 1 ? 0.3 : 0, 1e-14);
}

}  // namespace
}  // namespace slidezone
