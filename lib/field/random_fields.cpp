#include "field/random_fields.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/vector_loop.hpp"
#include "field/lognormal.hpp"

namespace slidezone {

/// What `make` makes; its errors name the field, or all of those that are drawn together.
template <class Make>
static auto named(const std::string& field, Make make) {
  try {
    return make();
  } catch (const Error& error) {
    throw Error(error.code(), "[field." + field + "]: " + error.what());
  }
}

/// Normals do not exceed 8.6: core/random.hpp.
static void check_positive(const FieldPlan& plan, const CellTransform& transform) {
  const double least = transform.marginal().value(-8.6);
  double lowest = transform.with_trend(least, 0);
  for (std::size_t cell = 0; cell < plan.model.trend.depth.size(); ++cell) lowest = std::min(lowest, transform.with_trend(least, cell));
  if (lowest <= 0)
    throw Error(ExitCode::data, "values may fall to " + format_brief(lowest) +
                                    ", where they want to be above 0; take a marginal that is, e.g. lognormal or truncated normal");
}

RandomFields::RandomFields(std::vector<FieldPlan> plans, const std::vector<CrossCorrelation>& correlated, std::uint64_t seed,
                           const StudyDesign& design)
    : plans_(std::move(plans)), places_(plans_.size()), seed_(seed), design_(design) {
  for (const FieldPlan& plan : plans_) {
    transforms_.push_back(named(plan.name, [&] { return CellTransform(plan.model); }));
    if (plan.is_positive) named(plan.name, [&] { check_positive(plan, transforms_.back()); });
  }
  std::vector<bool> is_grouped(plans_.size(), false);
  for (const CrossCorrelation& together : correlated) {
    for (const std::size_t field : together.fields) is_grouped[field] = true;
    add_group(together.fields, &together);
  }
  for (std::size_t field = 0; field < plans_.size(); ++field)
    if (!is_grouped[field]) add_group({field}, nullptr);
}

void RandomFields::add_group(const std::vector<std::size_t>& fields, const CrossCorrelation* correlated) {
  const FieldPlan& first = plans_[fields.front()];
  std::string names = first.name;
  for (std::size_t member = 1; member < fields.size(); ++member) names += ", " + plans_[fields[member]].name;
  named(names, [&] {
    Group group{GaussianField(first.model), {}, fields, Eigen::MatrixXd::Ones(1, 1), {}, {}, 0};
    std::vector<MarginalTransform> marginals;
    std::vector<ConditionedField> conditioned;
    for (const std::size_t field : fields) {
      places_[field] = {groups_.size(), marginals.size()};
      marginals.push_back(transforms_[field].marginal());
      conditioned.push_back({transforms_[field], plans_[field].measurements});
    }
    if (design_.design == Design::latin_hypercube) group.hypercube.emplace(first.model, design_);
    if (correlated != nullptr) group.mixing = mixing_of(*correlated, marginals);
    if (fields.size() > 1) group.drawn.assign(fields.size(), std::vector<double>(first.model.mesh.size()));
    if (std::ranges::any_of(conditioned, [](const ConditionedField& field) { return !field.measurements.empty(); }))
      group.conditioning.emplace(first.model, group.mixing * group.mixing.transpose(), conditioned);
    groups_.push_back(std::move(group));
  });
}

SLIDEZONE_VECTOR_LOOP
static void scale(double* values, double factor, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) values[i] *= factor;
}

SLIDEZONE_VECTOR_LOOP
static void add_multiple(double* __restrict sum, const double* __restrict term, double factor, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) sum[i] += factor * term[i];
}

/// From independent fields to correlated ones, in place: from the last, which no other needs.
static void mix(std::span<const std::span<double>> fields, const Eigen::MatrixXd& factor) {
  for (std::size_t i = fields.size(); i-- > 1;) {
    const auto row = static_cast<Eigen::Index>(i);
    scale(fields[i].data(), factor(row, row), fields[i].size());
    for (std::size_t j = 0; j < i; ++j)
      add_multiple(fields[i].data(), fields[j].data(), factor(row, static_cast<Eigen::Index>(j)), fields[i].size());
  }
}

void RandomFields::draw(Group& group, std::span<const std::span<double>> values, std::uint32_t sample) const {
  const bool is_mirrored = design_.design == Design::antithetic && sample % 2 == 0;
  const double sign = is_mirrored ? -1 : 1;
  std::vector<RandomStream> streams;
  for (const std::size_t field : group.fields) streams.push_back({seed_, purpose(plans_[field].name), is_mirrored ? sample - 1 : sample});
  for (std::size_t member = 0; member < values.size(); ++member) {
    group.gaussian.fill(values[member], streams[member]);
    if (is_mirrored) scale(values[member].data(), sign, values[member].size());
    if (group.hypercube) group.hypercube->apply(values[member], streams[member]);
  }
  mix(values, group.mixing);
  if (group.conditioning) group.conditioning->apply(values, streams, sign);
}

std::size_t RandomFields::fill(std::size_t field, std::span<double> values, std::uint32_t sample) {
  fill_gaussian(field, values, sample);
  return make_values(field, values);
}

void RandomFields::fill_gaussian(std::size_t field, std::span<double> values, std::uint32_t sample) {
  const auto [group_number, member] = places_[field];
  Group& group = groups_[group_number];
  if (group.drawn.empty()) {
    draw(group, std::span(&values, 1), sample);
  } else {
    if (group.drawn_sample != sample) draw(group, std::vector<std::span<double>>(group.drawn.begin(), group.drawn.end()), sample);
    group.drawn_sample = sample;
    std::ranges::copy(group.drawn[member], values.begin());
  }
}

std::size_t RandomFields::make_values(std::size_t field, std::span<double> values) const {
  transforms_[field].apply(values);
  const Limits& limits = plans_[field].limits;
  const std::size_t raised = std::isfinite(limits.low) ? raise_to_floor(values, limits.low) : 0;
  return raised + (std::isfinite(limits.high) ? lower_to_ceiling(values, limits.high) : 0);
}

}  // namespace slidezone
