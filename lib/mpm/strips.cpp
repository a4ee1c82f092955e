#include "mpm/strips.hpp"

#include <algorithm>

namespace slidezone {

NodeBox grown(const NodeBox& box, const NodeStorage& storage) {
  return {std::max(0, box.first_column - 1), std::min(storage.columns - 1, box.last_column + 1), std::max(0, box.first_row - 1),
          std::min(storage.rows - 1, box.last_row + 1)};
}

Strips::Strips(int threads) : workers_(std::make_shared<Workers>(threads)) {}

bool Strips::need_division() const {
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
       data.peak_cohesion, data.soil);
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
void Strips::for_each(Act act) {
  for (const bool is_odd : {false, true}) {
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < strips_.size(); ++k)
      if (strips_[k].is_odd == is_odd) chosen.push_back(k);
    workers_->each(chosen.size(), [&](std::size_t number) { act(chosen[number]); });
  }
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
    all.is_broken |= reports[k].is_broken;
  }
  return all;
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
  for_each([&](std::size_t k) {
    Dilation<Real> dilation;
    reports[k] = sweep(part_of(data, strips_[k].first, strips_[k].count, strips_[k].box, dilation));
  });
  for (std::size_t k = 0; k < strips_.size(); ++k) strips_[k].box = reports[k].box;
  return joined(reports);
}

template <class Real>
double Strips::stay(double (*sweep)(const SweepData<Real>&), const SweepData<Real>& data) {
  if (strips_.empty()) return sweep(data);
  std::vector<double> parts(strips_.size());
  for_each([&](std::size_t k) {
    Dilation<Real> dilation;
    parts[k] = sweep(part_of(data, strips_[k].first, strips_[k].count, strips_[k].box, dilation));
  });
  double sum = 0;
  for (const double part : parts) sum += part;
  return sum;
}

template <class Real>
void Strips::stay(void (*sweep)(const SweepData<Real>&), const SweepData<Real>& data) {
  if (strips_.empty()) return sweep(data);
  for_each([&](std::size_t k) {
    Dilation<Real> dilation;
    sweep(part_of(data, strips_[k].first, strips_[k].count, strips_[k].box, dilation));
  });
}

template SweepReport Strips::move(SweepReport (*)(const SweepData<double>&), const SweepData<double>&);
template SweepReport Strips::move(SweepReport (*)(const SweepData<float>&), const SweepData<float>&);
template SweepReport Strips::stay(SweepReport (*)(const SweepData<double>&), const SweepData<double>&);
template SweepReport Strips::stay(SweepReport (*)(const SweepData<float>&), const SweepData<float>&);
template double Strips::stay(double (*)(const SweepData<double>&), const SweepData<double>&);
template double Strips::stay(double (*)(const SweepData<float>&), const SweepData<float>&);
template void Strips::stay(void (*)(const SweepData<double>&), const SweepData<double>&);
template void Strips::stay(void (*)(const SweepData<float>&), const SweepData<float>&);

}  // namespace slidezone
