// How a large run is shared among threads: points in strips of node columns, first every other strip side by side, then those
// between.
//
// Two strips of the same kind never reach the same node: a strip is 8 columns of first nodes, its points reach 2 nodes farther,
// and they are sorted and divided anew before they have strayed so far that the next but one would meet. So there is nothing to
// lock, and sums on nodes run in one order: the result has the same bits for any number of threads, one included. Small runs are
// one strip.
//
// Where a step allows it, both of its sweeps go over the strips as one wave from left to right: once sweep A has been where a strip
// reaches, its nodes are updated and sweep B follows while its points still are in the cache.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/workers.hpp"
#include "mpm/points.hpp"
#include "mpm/sweeps.hpp"

namespace slidezone {

/// The box with one more node on every side, within the storage: a stable step moves no point by a whole cell.
NodeBox grown(const NodeBox& box, const NodeStorage& storage);

/// A step with two sweeps, for Strips::pass. Work on nodes gets some columns at a time, from left to right; the nodes on both sides of
/// a wall, which mirror each other, come together.
template <class Real>
struct TwoSweeps {
  SweepReport (*sweep_a)(const SweepData<Real>&);
  double (*sweep_b)(const SweepData<Real>&);
  std::function<void(const NodeBox&)> prepare;  // before sweep A adds to the nodes of a box
  std::function<void(const NodeBox&)> between;  // after sweep A has added all to them, and before sweep B sees them
  std::function<void(const NodeBox&)> finish;   // after sweep B has added all to them
};

struct TwoReports {
  SweepReport a;
  double b = 0;
};

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

  /// Whether the run is divided.
  bool are_many() const { return !strips_.empty(); }

  /// Whether the next step might bring two strips of a kind to the same node, or any but the first one to the nodes that the left wall
  /// mirrors. (No strip begins at those of the right wall: it would hold points beyond it alone.)
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

  /// A whole step as a wave, for runs that are divided. Gives what moving by sweep A, work on all nodes, staying for sweep B and work
  /// on all nodes again would; where sweep A breaks, it leaves the work to the right of that undone.
  template <class Real>
  TwoReports pass(const TwoSweeps<Real>& sweeps, const SweepData<Real>& data);

 private:
  static constexpr int columns = 8;
  static constexpr std::size_t strips_a_thread = 2;  // that a wave takes at a time: one even, one odd

  struct Strip {
    std::size_t first;
    std::size_t count;
    NodeBox box;  // nodes that its points reach
    bool is_odd;
  };

  using Numbers = std::span<const std::size_t>;  // of strips

  /// Strips from left to right, but each odd one after the even one on its right.
  std::vector<std::size_t> order_of_wave() const;
  /// First and last columns, the last excluded, that some of the strips reach.
  int first_column(Numbers strips) const;
  int last_column(Numbers strips) const;
  /// The box with these columns.
  NodeBox columns_of(const NodeBox& box, Numbers strips) const;

  template <class Report, class Real>
  Report sweep_strip(Report (*sweep)(const SweepData<Real>&), const SweepData<Real>& data, std::size_t k) const;

  template <class Act>
  void for_each(Numbers strips, Act act);
  template <class Act>
  void for_each(Act act);

  std::vector<Strip> strips_;  // from left to right
  std::shared_ptr<Workers> workers_;
};

}  // namespace slidezone
