#include "mpm/contact.hpp"

#include <cmath>

#include "grid/gimp.hpp"

namespace slidezone {

/// Adds a point's m grad N at the nodes of the rows y = 0 and y = -cell_y.
static void add_gradients(ContactNormals& gradients, double x, double y, double mass, const GridShape& grid, HalfSize half_size) {
  const auto over_4l = [](double l) { return l > 0 ? 1 / (4 * l) : 0; };
  const double in_x = x / grid.cell_x;
  const double in_y = y / grid.cell_y;
  const double first_x = std::floor(in_x - half_size.x);
  const double first_y = std::floor(in_y - half_size.y);
  const AxisWeights weights_x = axis_weights(in_x, first_x, half_size.x, over_4l(half_size.x));
  const AxisWeights weights_y = axis_weights(in_y, first_y, half_size.y, over_4l(half_size.y));
  const AxisValues N_x = shape_values(weights_x);
  const AxisValues N_y = shape_values(weights_y);
  const AxisValues S_x = shape_slopes(weights_x);
  const AxisValues S_y = shape_slopes(weights_y);
  for (int j = 0; j < 3; ++j) {
    const int row = static_cast<int>(first_y) + j;
    if (row != 0 && row != -1) continue;
    std::vector<Vec2>& to = row == 0 ? gradients.top : gradients.below;
    for (int i = 0; i < 3; ++i) {
      Vec2& sum = to[static_cast<std::size_t>(static_cast<int>(first_x) + i + NodeStorage::padding)];
      sum.x += mass * S_x.node[i] * N_y.node[j] / grid.cell_x;
      sum.y += mass * N_x.node[i] * S_y.node[j] / grid.cell_y;
    }
  }
}

/// Soil's gradient less that of the base, as a unit vector; 0 where there is no soil.
static Vec2 normal(Vec2 soil, double base_y) {
  if (soil.x == 0 && soil.y == 0) return {0, 0};
  const double y = soil.y - base_y;
  const double length = std::hypot(soil.x, y);
  return length > 0 ? Vec2{soil.x / length, y / length} : Vec2{0, -1};
}

template <class Real>
ContactNormals contact_normals(const PointsOf<Real>& points, const GridShape& grid, HalfSize half_size, double base_density) {
  const auto columns = static_cast<std::size_t>(NodeStorage(grid).columns);
  ContactNormals contact{std::vector<Vec2>(columns), std::vector<Vec2>(columns)};
  const double nearest = (1 + half_size.y) * grid.cell_y;  // points above do not reach the base
  for (std::size_t p = 0; p < points.count(); ++p)
    if (points.y[p] < nearest) add_gradients(contact, points.x[p], points.y[p], points.mass[p], grid, half_size);
  // A lattice that fills the half-space below y = 0: its gradient at the top row is density times cell_x, deeper it is 0.
  const double base_gradient = base_density * grid.cell_x;
  for (Vec2& gradient : contact.top) gradient = normal(gradient, base_gradient);
  for (Vec2& gradient : contact.below) gradient = normal(gradient, 0);
  return contact;
}

template ContactNormals contact_normals(const PointsOf<double>&, const GridShape&, HalfSize, double);
template ContactNormals contact_normals(const PointsOf<float>&, const GridShape&, HalfSize, double);

}  // namespace slidezone
