#include "mpm/coulomb_watch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidezone {

CoulombWatch::CoulombWatch(double friction, std::uint64_t window, const NodeStorage& storage)
    : friction_(friction),
      window_(std::max<std::uint64_t>(1, window)),
      rows_(static_cast<std::size_t>(storage.rows)),
      columns_(static_cast<std::size_t>(storage.columns)) {}

double CoulombWatch::see(const std::vector<NodeFriction>& frictions) {
  for (const NodeFriction& friction : frictions) {
    ColumnContact& column = columns_[friction.node / rows_];
    column.along += std::abs(friction.push.x);
    column.upward += friction.push.y;
    column.work += std::max(0.0, -friction.push.x * friction.slip);
  }
  if (++steps_ < window_) return 0;
  const double beyond = excess();
  columns_.assign(columns_.size(), {});
  steps_ = 0;
  return beyond;
}

double CoulombWatch::excess_of(const ColumnContact& contact) const {
  if (contact.along == 0) return 0;
  const double lawful = friction_ * std::max(0.0, contact.upward) / contact.along;
  return contact.work * std::max(0.0, 1 - lawful);
}

double CoulombWatch::excess() const {
  double one_by_one = 0;
  ColumnContact all;
  for (const ColumnContact& column : columns_) {
    one_by_one += excess_of(column);
    all.along += column.along;
    all.upward += column.upward;
    all.work += column.work;
  }
  return std::max(one_by_one, excess_of(all));
}

void CoulombWatch::go_on(std::vector<ColumnContact> columns, std::uint64_t steps_of_run) {
  columns_ = std::move(columns);
  steps_ = steps_of_run % window_;
}

}  // namespace slidezone
