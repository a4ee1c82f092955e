#include "mpm/point_order.hpp"

#include <algorithm>

namespace slidezone {

int first_node(double place, double cell, double half, int count) {
  return static_cast<int>(std::clamp(place / cell - half + NodeStorage::padding, 0.0, count - 1.0));
}

template <class Real>
std::vector<int> order_by_node(const PointsOf<Real>& points, const NodeStorage& storage, const GridShape& grid, HalfSize half) {
  const auto node_of = [&](std::size_t p) {
    return storage.index(first_node(points.x[p], grid.cell_x, half.x, storage.columns),
                         first_node(points.y[p], grid.cell_y, half.y, storage.rows));
  };
  std::vector<int> place(storage.count() + 1, 0);
  for (std::size_t p = 0; p < points.count(); ++p) ++place[node_of(p) + 1];
  for (std::size_t node = 1; node < place.size(); ++node) place[node] += place[node - 1];
  std::vector<int> order(points.count());
  for (std::size_t p = 0; p < points.count(); ++p) order[static_cast<std::size_t>(place[node_of(p)]++)] = static_cast<int>(p);
  return order;
}

template <class Real>
std::vector<int> order_by_label(const PointsOf<Real>& points) {
  std::vector<int> order(points.count());
  for (std::size_t p = 0; p < points.count(); ++p) order[static_cast<std::size_t>(points.label[p])] = static_cast<int>(p);
  return order;
}

template std::vector<int> order_by_node(const PointsOf<double>&, const NodeStorage&, const GridShape&, HalfSize);
template std::vector<int> order_by_node(const PointsOf<float>&, const NodeStorage&, const GridShape&, HalfSize);
template std::vector<int> order_by_label(const PointsOf<double>&);
template std::vector<int> order_by_label(const PointsOf<float>&);

}  // namespace slidezone
