// How a large run is shared among threads: points in strips of node columns, first every other strip side by side, then those
// between.
//
// Two strips of the same kind never reach the same node: a strip is 8 columns of first nodes, its points reach 2 nodes farther,
// and they are sorted and divided anew before they have strayed so far that the next but one would meet. So there is nothing to
// lock, and sums on nodes run in one order: the result has the same bits for any number of threads, one included. Small runs are
// one strip.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/workers.hpp"
#include "mpm/points.hpp"
#include "mpm/sweeps.hpp"

namespace slidezone {

/// The box with one more node on every side, within the storage: a stable step moves no point by a whole cell.
NodeBox grown(const NodeBox& box, const NodeStorage& storage);

class Strips {
 public:
  /// Runs of fewer points are not divided.
  static constexpr std::size_t least_points = 100000;

  explicit Strips(int threads);

  /// Divides points, which are sorted by their first nodes, into strips. `first_column` gives that of point p.
  template <class FirstColumn>
  void divide(std::size_t point_count, const NodeBox& box, FirstColumn first_column) {
    strips_.clear();
    if (point_count < least_points) return;
    for (std::size_t p = 0; p < point_count; ++p) {
      const int start = first_column(p) / columns * columns;
      if (strips_.empty() || strips_.back().box.first_column != start)
        strips_.push_back({p, 0, {start, start + columns + 2, box.first_row, box.last_row}, start / columns % 2 == 1});
      ++strips_.back().count;
    }
  }

  /// Whether the next step might bring two strips of a kind to the same node.
  bool need_division() const;

  /// Sweeps that move points, and so find the nodes that they reach then.
  template <class Real>
  SweepReport move(SweepReport (*sweep)(const SweepData<Real>&), const SweepData<Real>& data);
  /// Sweeps that leave points where they are.
  template <class Real>
  SweepReport stay(SweepReport (*sweep)(const SweepData<Real>&), const SweepData<Real>& data);
  template <class Real>
  double stay(double (*sweep)(const SweepData<Real>&), const SweepData<Real>& data);
  template <class Real>
  void stay(void (*sweep)(const SweepData<Real>&), const SweepData<Real>& data);

 private:
  static constexpr int columns = 8;

  struct Strip {
    std::size_t first;
    std::size_t count;
    NodeBox box;  // nodes that its points reach
    bool is_odd;
  };

  template <class Act>
  void for_each(Act act);

  std::vector<Strip> strips_;  // from left to right
  std::shared_ptr<Workers> workers_;
};

}  // namespace slidezone
