// Whether friction on the base keeps to Coulomb's law over times longer than the soil's vibration. A guard beside the energy audit.
//
// In each step it does, at each node. But a base that holds both ways takes no friction while it pulls, and so soil that shakes rubs more
// than its weight presses: N swings, and the mean of max(0, N) is more than that of N. And the normals of a two-body base lean where the
// soil ends, and push it back. Elastic blocks stopped 7 to 86 % short of v^2 / (2 mu g) for these reasons, with energies that balance.
// So in windows as long as the period of the soil's first vertical vibration, 4 H / c, columns of nodes are looked at one by one and all
// together; the larger counts of what is found:
//   excess = sum max(0, -T v) max(0, 1 - mu max(0, sum N) / sum |T|)
// with the impulses on the soil, N upwards and T along the base, and the velocity v along the base that they leave the node. H is the
// soil's height at the start and c its slowest wave: shorter windows miss vibration, for in one step every node keeps to the law.
// One by one finds soil that shakes at the front of a slide while the rest stands; all together, a body that slides as a whole and
// rocks, so that its rear is held down while its front carries more than it weighs.
#pragma once

#include <cstdint>
#include <vector>

#include "mpm/nodes.hpp"

namespace slidezone {

/// What the base gave to the nodes of a column in the window so far.
struct ColumnContact {
  double along = 0;   // sum |T|, N s/m
  double upward = 0;  // sum N, N s/m
  double work = 0;    // sum max(0, -T v), J/m
};

class CoulombWatch {
 public:
  /// For a base with this coefficient of friction; windows of so many steps, at least one.
  CoulombWatch(double friction, std::uint64_t window, const NodeStorage& storage);

  /// After each step. Returns the work that friction took beyond Coulomb's law in a window that ends with this step, or 0.
  double see(const std::vector<NodeFriction>& frictions);

  /// The same for the window in progress, at the end of a run.
  double excess() const;

  /// The window in progress, column by column, and the number of its steps; to go on with it in another run.
  const std::vector<ColumnContact>& columns() const { return columns_; }
  void go_on(std::vector<ColumnContact> columns, std::uint64_t steps_of_run);

 private:
  double excess_of(const ColumnContact& contact) const;

  double friction_;
  std::uint64_t window_;
  std::size_t rows_;
  std::uint64_t steps_ = 0;  // of the window in progress
  std::vector<ColumnContact> columns_;
};

}  // namespace slidezone
