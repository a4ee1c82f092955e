#include "summary/zone_tables.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"

namespace slidezone {

// ---- structures ----

static Structure structure_of(const Table& table, std::size_t index) {
  const std::string& side = table.text(index, "side");
  const Structure structure{table.text(index, "name"), side == "toe", table.number(index, "distance_m")};
  if (structure.name.empty()) fail_at(table.where(index), "column 'name': found nothing, expected a name");
  if (side != "toe" && side != "crest") fail_at(table.where(index), "column 'side': found '" + side + "', expected toe or crest");
  if (structure.distance < 0)
    fail_at(table.where(index), "column 'distance_m': found '" + table.text(index, "distance_m") +
                                    "', expected a distance >= 0 from the toe or the crest, away from the slope");
  return structure;
}

std::vector<Structure> parse_structures(std::string_view bytes, const std::string& file) {
  const std::vector<std::string> columns = {"name", "side", "distance_m"};
  const Table table = parse_tsv(bytes, file, "slidezone-structures-input 1", columns);
  for (const std::string& name : table.columns()) {
    if (std::find(columns.begin(), columns.end(), name) == columns.end())
      fail_at(table.header(), "unknown column '" + name + "'" + nearest_hint(name, columns) + "; expected name, side and distance_m");
  }
  if (table.row_count() == 0) fail_at(table.header(), "found a header without rows, expected at least one structure");
  std::vector<Structure> structures;
  for (std::size_t i = 0; i < table.row_count(); ++i) {
    structures.push_back(structure_of(table, i));
    for (std::size_t j = 0; j < i; ++j) {
      if (structures[j].name == structures[i].name)
        fail_at(table.where(i), "structure '" + structures[i].name + "' stands twice, first at " + to_string(table.where(j)));
    }
  }
  return structures;
}

// ---- lines of one study, and the worst of several ----

namespace {

/// What the estimate is of, the estimate, and what else is said of it.
struct Line {
  std::vector<std::string> what;
  Estimate estimate;
  std::vector<std::string> more;
};
using Lines = std::vector<Line>;

}  // namespace

/// The larger of two numbers; the other one where one is nan.
static double larger(double a, double b) { return std::fmax(a, b); }

static Lines worst_of(const std::vector<Lines>& studies) {
  Lines worst = studies.front();
  for (const Lines& study : studies) {
    for (std::size_t i = 0; i < worst.size(); ++i) {
      Estimate& estimate = worst[i].estimate;
      const Estimate& other = study[i].estimate;
      estimate = {larger(estimate.value, other.value),
                  {larger(estimate.interval.low, other.interval.low), larger(estimate.interval.high, other.interval.high)}};
      for (std::string& word : worst[i].more) word = "nan";  // a fit belongs to one study
    }
  }
  return worst;
}

/// The lines of every study below each other; with several, their names before and the worst case after them.
static std::vector<std::pair<std::string, Lines>> with_worst_case(std::span<const NamedEnsemble> studies, const std::vector<Lines>& lines) {
  std::vector<std::pair<std::string, Lines>> result;
  for (std::size_t i = 0; i < studies.size(); ++i) result.emplace_back(studies[i].name, lines[i]);
  if (!studies.front().name.empty()) result.emplace_back("worst_case", worst_of(lines));
  return result;
}

static Table table_with(std::span<const NamedEnsemble> studies, std::vector<std::string> columns) {
  if (!studies.front().name.empty()) columns.insert(columns.begin(), "study");
  return Table(std::move(columns));
}

static void add_line(Table& table, const std::string& study, const Line& line, const std::vector<std::string>& more) {
  std::vector<std::string> fields = line.what;
  if (!study.empty()) fields.insert(fields.begin(), study);
  const Estimate& estimate = line.estimate;
  fields.insert(fields.end(), {format_real(estimate.value), format_limit(estimate.interval.low), format_limit(estimate.interval.high)});
  fields.insert(fields.end(), more.begin(), more.end());
  table.add_row(std::move(fields));
}

// ---- classes ----

std::optional<TailFit> tail_of(const ReachOfStudy& reach, const ZoneOptions& options) {
  if (!options.has_tails || has_blocks(reach.sample) || count_of(reach.sample, Knowledge::exact) < reach.sample.size()) return std::nullopt;
  return tail_fit(known_values(reach.sample));
}

std::string words_on(const TailFit& fit) {
  return "threshold " + format_real(fit.threshold) + " m, exceedances " + std::to_string(fit.exceedances) + ", scale " +
         format_brief(fit.scale, 6) + " m, shape " + format_brief(fit.shape, 6) + ", distance " + format_brief(fit.distance, 4);
}

std::vector<std::string> thin_boundaries(const NamedEnsemble& study, const ZoneOptions& options) {
  std::vector<std::string> notes;
  if (options.has_tails) return notes;
  const std::size_t runs = study.ensemble.failure.size();
  for (const double p : options.classes.thresholds) {
    if (static_cast<double>(runs) * p < 1)
      notes.push_back(std::to_string(runs) + " runs cannot tell where the probability falls to " + format_real(100 * p) +
                      " %: the distance given is the farthest run's");
  }
  return notes;
}

static Lines class_lines(const NamedEnsemble& study, const ZoneOptions& options) {
  Lines lines;
  for (const ReachOfStudy* reach : {&study.ensemble.influence, &study.ensemble.runout}) {
    const std::optional<TailFit> tail = tail_of(*reach, options);
    const auto found = tail ? boundaries_by_tail(reach->sample, options.classes, *tail) : boundaries(reach->sample, options.classes);
    for (const Boundary& boundary : found)
      lines.push_back({{reach->quantity, boundary.name, format_real(boundary.probability)}, boundary.distance, {}});
  }
  return lines;
}

Table class_table(std::span<const NamedEnsemble> studies, const ZoneOptions& options) {
  Table table = table_with(studies, {"quantity", "class", "probability", "distance_m", "ci_low_m", "ci_high_m"});
  std::vector<Lines> lines;
  for (const NamedEnsemble& study : studies) lines.push_back(class_lines(study, options));
  for (const auto& [name, of_study] : with_worst_case(studies, lines)) {
    for (const Line& line : of_study) add_line(table, name, line, {});
  }
  return table;
}

// ---- curves ----

/// Distances that cover the reach of every study.
static std::vector<double> shared_distances(std::span<const NamedEnsemble> studies, ReachOfStudy Ensemble::*reach) {
  double farthest = 0;
  for (const NamedEnsemble& study : studies)
    farthest = larger(farthest, moments_of(known_values((study.ensemble.*reach).sample)).maximum());
  return curve_distances(farthest);
}

static Lines curve_lines(const NamedEnsemble& study, const ZoneOptions& options, std::span<const NamedEnsemble> studies) {
  Lines lines;
  const double failure = failure_probability(study.ensemble).value;
  for (const auto member : {&Ensemble::influence, &Ensemble::runout}) {
    const ReachOfStudy& reach = study.ensemble.*member;
    for (const CurvePoint& point :
         exceedance_curve(reach.sample, known_values(reach.slides), failure, shared_distances(studies, member), options.band))
      lines.push_back(
          {{reach.quantity, format_real(point.distance)}, point.exceedance, {format_real(point.normal), format_real(point.lognormal)}});
  }
  return lines;
}

Table curve_table(std::span<const NamedEnsemble> studies, const ZoneOptions& options) {
  Table table = table_with(studies, {"quantity", "distance_m", "probability", "ci_low", "ci_high", "normal", "lognormal"});
  std::vector<Lines> lines;
  for (const NamedEnsemble& study : studies) lines.push_back(curve_lines(study, options, studies));
  for (const auto& [name, of_study] : with_worst_case(studies, lines)) {
    for (const Line& line : of_study) add_line(table, name, line, line.more);
  }
  return table;
}

// ---- classed structures ----

static Lines structure_lines(const NamedEnsemble& study, std::span<const Structure> structures, const ZoneOptions& options) {
  Lines lines;
  for (const Structure& structure : structures) {
    const ReachOfStudy& reach = structure.is_at_toe ? study.ensemble.runout : study.ensemble.influence;
    lines.push_back({{structure.name, structure.is_at_toe ? "toe" : "crest", format_real(structure.distance)},
                     exceedance_estimate(reach.sample, structure.distance, options.band),
                     {}});
  }
  return lines;
}

Table structure_table(std::span<const NamedEnsemble> studies, std::span<const Structure> structures, const ZoneOptions& options) {
  Table table = table_with(studies, {"name", "side", "distance_m", "probability", "ci_low", "ci_high", "class", "class_low", "class_high"});
  std::vector<Lines> lines;
  for (const NamedEnsemble& study : studies) lines.push_back(structure_lines(study, structures, options));
  for (const auto& [name, of_study] : with_worst_case(studies, lines)) {
    for (const Line& line : of_study) {
      const Estimate& hazard = line.estimate;
      add_line(table, name, line,
               {class_of(options.classes, hazard.value), class_of(options.classes, hazard.interval.low),
                class_of(options.classes, hazard.interval.high)});
    }
  }
  return table;
}

}  // namespace slidezone
