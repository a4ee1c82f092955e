#include "mpm/strips.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>

namespace slidezone {

NodeBox grown(const NodeBox& box, const NodeStorage& storage) {
  return {std::max(0, box.first_column - 1), std::min(storage.columns - 1, box.last_column + 1), std::max(0, box.first_row - 1),
          std::min(storage.rows - 1, box.last_row + 1)};
}

Strips::Strips(int threads) : workers_(std::make_shared<Workers>(threads)) {}

bool Strips::need_division() const {
  constexpr int mirrored = NodeStorage::padding + 2;  // columns on both sides of the left wall
  for (std::size_t k = 1; k < strips_.size(); ++k)
    if (strips_[k].box.first_column - 1 < mirrored) return true;
  for (std::size_t k = 0; k < strips_.size(); ++k)
    for (std::size_t other = k + 1; other < std::min(k + 3, strips_.size()); ++other)
      if (strips_[other].is_odd == strips_[k].is_odd && strips_[k].box.last_column + 1 > strips_[other].box.first_column - 1) return true;
  return false;
}

/// What a sweep over `count` points from `first` on is to see, within `box`. `dilation` becomes the part's own.
template <class Real>
static SweepData<Real> part_of(SweepData<Real> data, std::size_t first, std::size_t count, const NodeBox& box, Dilation<Real>& dilation) {
  const auto skip = [first](auto&... arrays) { ((arrays += first), ...); };
  data.point_count = count;
  data.box = box;
  skip(data.x, data.y, data.xx, data.yy, data.zz, data.xy, data.volume, data.plastic_strain, data.softening_strain, data.mass,
       data.peak_cohesion, data.soil, data.s_x, data.s_y, data.first_node);
  data.velocity += 2 * first;
  data.movement += 2 * first;
  if (data.dilation) {
    dilation = *data.dilation;
    skip(dilation.xx, dilation.xy, dilation.yx, dilation.yy, dilation.cell);
    data.dilation = &dilation;
  }
  return data;
}

/// Calls act(k) for all even strips, then for all odd ones.
template <class Act>
void Strips::for_each(Numbers strips, Act act) {
  for (const bool is_odd : {false, true}) {
    std::vector<std::size_t> chosen;
    std::copy_if(strips.begin(), strips.end(), std::back_inserter(chosen), [&](std::size_t k) { return strips_[k].is_odd == is_odd; });
    workers_->each(chosen.size(), [&](std::size_t number) { act(chosen[number]); });
  }
}

template <class Act>
void Strips::for_each(Act act) {
  std::vector<std::size_t> all(strips_.size());
  std::iota(all.begin(), all.end(), 0);
  for_each(all, act);
}

static NodeBox joined(const NodeBox& a, const NodeBox& b) {
  return {std::min(a.first_column, b.first_column), std::max(a.last_column, b.last_column), std::min(a.first_row, b.first_row),
          std::max(a.last_row, b.last_row)};
}

static SweepReport joined(const std::vector<SweepReport>& reports) {
  SweepReport all = reports.front();
  for (std::size_t k = 1; k < reports.size(); ++k) {
    all.internal_work += reports[k].internal_work;
    all.box = joined(all.box, reports[k].box);
    all.out_of_order += reports[k].out_of_order;
    all.is_broken |= reports[k].is_broken;
  }
  return all;
}

template <class Report, class Real>
Report Strips::sweep_strip(Report (*sweep)(const SweepData<Real>&), const SweepData<Real>& data, std::size_t k) const {
  Dilation<Real> dilation;
  return sweep(part_of(data, strips_[k].first, strips_[k].count, strips_[k].box, dilation));
}

template <class Real>
SweepReport Strips::move(SweepReport (*sweep)(const SweepData<Real>&), const SweepData<Real>& data) {
  for (Strip& strip : strips_) strip.box = grown(strip.box, data.storage);
  return stay(sweep, data);
}

template <class Real>
SweepReport Strips::stay(SweepReport (*sweep)(const SweepData<Real>&), const SweepData<Real>& data) {
  if (strips_.empty()) return sweep(data);
  std::vector<SweepReport> reports(strips_.size());
  for_each([&](std::size_t k) { reports[k] = sweep_strip(sweep, data, k); });
  for (std::size_t k = 0; k < strips_.size(); ++k) strips_[k].box = reports[k].box;
  return joined(reports);
}

template <class Real>
double Strips::stay(double (*sweep)(const SweepData<Real>&), const SweepData<Real>& data) {
  if (strips_.empty()) return sweep(data);
  std::vector<double> parts(strips_.size());
  for_each([&](std::size_t k) { parts[k] = sweep_strip(sweep, data, k); });
  double sum = 0;
  for (const double part : parts) sum += part;
  return sum;
}

template <class Real>
void Strips::stay(void (*sweep)(const SweepData<Real>&), const SweepData<Real>& data) {
  if (strips_.empty()) return sweep(data);
  for_each([&](std::size_t k) { sweep_strip(sweep, data, k); });
}

// ---- both sweeps as a wave ------------------------------------------------------------------------------------------------------

std::vector<std::size_t> Strips::order_of_wave() const {
  std::vector<std::size_t> order(strips_.size());
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t k = 0; k + 1 < order.size(); ++k)
    if (strips_[k].is_odd && !strips_[k + 1].is_odd) std::swap(order[k], order[k + 1]);
  return order;
}

int Strips::first_column(Numbers strips) const {
  int first = std::numeric_limits<int>::max();
  for (const std::size_t k : strips) first = std::min(first, strips_[k].box.first_column);
  return first;
}

int Strips::last_column(Numbers strips) const {
  int last = 0;
  for (const std::size_t k : strips) last = std::max(last, strips_[k].box.last_column);
  return last;
}

NodeBox Strips::columns_of(const NodeBox& box, Numbers strips) const {
  return {first_column(strips), last_column(strips), box.first_row, box.last_row};
}

namespace {

/// Work on the nodes of a box that goes on from left to right.
class NodeWork {
 public:
  NodeWork(const NodeBox& box, const std::function<void(const NodeBox&)>& work) : rest_(box), work_(work) {}

  /// Does the columns up to `column`, excluded, that are not done yet.
  void go_on_to(int column) {
    if (column <= rest_.first_column) return;
    work_({rest_.first_column, column, rest_.first_row, rest_.last_row});
    rest_.first_column = column;
  }
  int next_column() const { return rest_.first_column; }

 private:
  NodeBox rest_;
  const std::function<void(const NodeBox&)>& work_;
};

}  // namespace

template <class Real>
TwoReports Strips::pass(const TwoSweeps<Real>& sweeps, const SweepData<Real>& data) {
  for (Strip& strip : strips_) strip.box = grown(strip.box, data.storage);
  const std::vector<std::size_t> order = order_of_wave();
  const NodeBox box = columns_of(data.box, order);
  NodeWork prepare(box, sweeps.prepare), between(box, sweeps.between), finish(box, sweeps.finish);
  const auto complete = [&](Numbers to_come) { return to_come.empty() ? box.last_column : first_column(to_come); };
  const auto next_of = [&](Numbers strips) { return strips.first(std::min(strips_a_thread * workers_->count(), strips.size())); };
  std::vector<SweepReport> reports(strips_.size());
  std::vector<double> parts(strips_.size());
  bool is_broken = false;
  for (Numbers to_sweep = order, to_follow = order; !to_sweep.empty();) {
    const Numbers ahead = next_of(to_sweep);
    prepare.go_on_to(last_column(ahead));
    for_each(ahead, [&](std::size_t k) { reports[k] = sweep_strip(sweeps.sweep_a, data, k); });
    for (const std::size_t k : ahead) {
      strips_[k].box = reports[k].box;
      is_broken |= reports[k].is_broken;
    }
    to_sweep = to_sweep.subspan(ahead.size());
    if (is_broken) continue;
    between.go_on_to(complete(to_sweep));
    while (!to_follow.empty() && last_column(next_of(to_follow)) <= between.next_column()) {
      const Numbers behind = next_of(to_follow);
      for_each(behind, [&](std::size_t k) { parts[k] = sweep_strip(sweeps.sweep_b, data, k); });
      to_follow = to_follow.subspan(behind.size());
      finish.go_on_to(complete(to_follow));
    }
  }
  return {joined(reports), std::accumulate(parts.begin(), parts.end(), 0.0)};
}

template SweepReport Strips::move(SweepReport (*)(const SweepData<double>&), const SweepData<double>&);
template SweepReport Strips::move(SweepReport (*)(const SweepData<float>&), const SweepData<float>&);
template SweepReport Strips::stay(SweepReport (*)(const SweepData<double>&), const SweepData<double>&);
template SweepReport Strips::stay(SweepReport (*)(const SweepData<float>&), const SweepData<float>&);
template double Strips::stay(double (*)(const SweepData<double>&), const SweepData<double>&);
template double Strips::stay(double (*)(const SweepData<float>&), const SweepData<float>&);
template void Strips::stay(void (*)(const SweepData<double>&), const SweepData<double>&);
template void Strips::stay(void (*)(const SweepData<float>&), const SweepData<float>&);
template TwoReports Strips::pass(const TwoSweeps<double>&, const SweepData<double>&);
template TwoReports Strips::pass(const TwoSweeps<float>&, const SweepData<float>&);

}  // namespace slidezone
