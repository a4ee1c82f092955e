#include "mpm/point_order.hpp"

#include <algorithm>
#include <numeric>

namespace slidezone {

std::vector<int> order_by_node(std::span<const int> first_nodes) {
  const auto [low, high] = std::minmax_element(first_nodes.begin(), first_nodes.end());
  const int least = *low;
  const auto number_of = [least](int node) { return static_cast<std::size_t>(node - least); };
  std::vector<int> place(number_of(*high) + 2, 0);
  for (const int node : first_nodes) ++place[number_of(node) + 1];
  std::partial_sum(place.begin(), place.end(), place.begin());
  std::vector<int> order(first_nodes.size());
  int p = 0;
  for (const int node : first_nodes) order[static_cast<std::size_t>(place[number_of(node)]++)] = p++;
  return order;
}

template <class Real>
std::vector<int> order_by_label(const PointsOf<Real>& points) {
  std::vector<int> order(points.count());
  for (std::size_t p = 0; p < points.count(); ++p) order[static_cast<std::size_t>(points.label[p])] = static_cast<int>(p);
  return order;
}

template std::vector<int> order_by_label(const PointsOf<double>&);
template std::vector<int> order_by_label(const PointsOf<float>&);

}  // namespace slidezone
