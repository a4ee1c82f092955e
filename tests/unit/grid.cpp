#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "grid/gimp.hpp"
#include "grid/node_storage.hpp"

namespace slidezone {
namespace {

/// The GIMP shape function of Bardenhagen and Kober (2004), piece by piece: node at 0, point at x, half-size l, cell 1.
double piecewise(double x, double l) {
  const double d = std::abs(x);
  if (d < l) return 1 - (x * x + l * l) / (2 * l);
  if (d <= 1 - l) return 1 - d;
  if (d < 1 + l) return std::pow(1 + l - d, 2) / (4 * l);
  return 0;
}

AxisWeights weights_at(double x, double l) { return axis_weights(x, std::floor(x - l), l, l > 0 ? 1 / (4 * l) : 0); }

TEST(Gimp, AgreesWithThePiecewiseDefinition) {
  for (const double l : {0.5, 0.25, 0.125, 0.0625})
    for (double x = -0.4; x < 3; x += 0.0173) {
      const AxisValues values = shape_values(weights_at(x, l));
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(values.node[k], piecewise(x - (std::floor(x - l) + k), l), 1e-14) << x << " " << l;
    }
}

TEST(Gimp, SlopesAreDerivativesOfValues) {
  constexpr double h = 1e-6;
  for (const double l : {0.5, 0.25})
    for (double x = 0.01; x < 2; x += 0.0317) {
      const double first = std::floor(x - l);
      if (std::floor(x - h - l) != first || std::floor(x + h - l) != first) continue;
      const AxisValues slopes = shape_slopes(weights_at(x, l));
      const AxisValues below = shape_values(weights_at(x - h, l));
      const AxisValues above = shape_values(weights_at(x + h, l));
      // Second derivatives jump by up to 1 / (2 l): the difference quotient is exact to about h.
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(slopes.node[k], (above.node[k] - below.node[k]) / (2 * h), 3 * h / l) << x;
    }
}

TEST(Gimp, IsAPartitionOfUnityAlsoAcrossTheEdges) {
  for (const double l : {0.0, 0.125, 0.25, 0.5})
    for (double x = -0.49; x < 2.5; x += 0.01) {
      const AxisWeights w = weights_at(x, l);
      const AxisValues values = shape_values(w);
      const AxisValues slopes = shape_slopes(w);
      EXPECT_NEAR(values.node[0] + values.node[1] + values.node[2], 1, 1e-15);
      EXPECT_NEAR(slopes.node[0] + slopes.node[1] + slopes.node[2], 0, 1e-15);
      EXPECT_GE(std::min({values.node[0], values.node[1], values.node[2]}), -1e-15);
      // A point is where its nodes say that it is.
      const double first = std::floor(x - l);
      EXPECT_NEAR(values.node[0] * first + values.node[1] * (first + 1) + values.node[2] * (first + 2), x, 1e-14);
    }
}

TEST(NodeStorage, HoldsEveryNodeThatAPointInTheGridReaches) {
  const GridShape shape{0.2, 0.1, 7, 3};
  const NodeStorage storage(shape);
  // A point on the far corner starts at node cells - 1 + padding at most, reaches three, and is read as rows of four.
  EXPECT_LE(shape.cells_x + NodeStorage::padding + 3, storage.columns);
  EXPECT_LE(storage.index(shape.cells_x + NodeStorage::padding + 1, shape.cells_y + NodeStorage::padding) + 4, storage.count());
}

}  // namespace
}  // namespace slidezone
