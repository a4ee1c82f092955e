// zoning: how likely a place before the toe or behind the crest is to be reached, and where the hazard zones end.
// Rows ("slidezone-row 1") -> class boundaries ("slidezone-classes 1"), the exceedance curve ("slidezone-curve 1"), or the classes of
// structures ("slidezone-structures 1") that are given as a table ("slidezone-structures-input 1").
//   zoning rows/*.tsv --structures structures.tsv
#include "zoning/zoning.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/provenance.hpp"
#include "core/text.hpp"
#include "core/tool.hpp"
#include "ensemble/ensemble.hpp"
#include "io/file.hpp"
#include "io/table.hpp"
#include "rows/row.hpp"

namespace slidezone {
namespace {

struct Options {
  std::vector<std::string> rows = {"-"};
  bool wants_classes = false;  // also without any of the three
  bool wants_curve = false;
  std::string structures;
  std::string output = "-";
};

const char* const manual = R"(Exceedance probabilities and hazard classes of places before and behind a slope.

Of the influence distance behind the crest (influence_m) and the runout distance before the toe (runout_m). Distances in m, counted away
from the slope.

A probability is a share of all runs, failed or not; ci_low and ci_high are its exact 95 % band (Clopper-Pearson), for one distance at a
time. Runs that left the grid exceed every distance up to their reach and are doubtful beyond, diverged runs are doubtful everywhere:
doubtful runs widen the band to both sides. An end that the runs cannot give is "unbounded".

Classes by P = P(reach > distance):
  very_high  P > 50 %    high  50 to 10 %    medium  10 to 1 %    low  1 to 0.1 %    very_low  P <= 0.1 %

Results, one of:
  --classes   quantity class probability distance_m ci_low_m ci_high_m: the far end of each class, the distance at which P falls to
              `probability`; very_low has none. The interval is of order statistics; 1 % wants some 370 runs for an upper end, 0.1 %
              some 3,700
  --curve     quantity distance_m probability ci_low ci_high normal lognormal: P over evenly spaced distances from 0 to 1.25 times the
              farthest reach, and beside it that of the Normal and the Lognormal fit: P(failure) times the tail of the fit to the runs
              that slid; nan where there is no fit
  --structures FILE
              name side distance_m probability ci_low ci_high class class_low class_high: P at each structure, its class, and the
              classes at either end of the band. FILE is a table `name side distance_m`, side is toe or crest.)";

std::string realizations(const Ensemble& ensemble) { return std::to_string(ensemble.failure.size()); }

/// A boundary beyond which less than one run is expected is the largest value seen, not an estimate.
void note_thin_tail(const Ensemble& ensemble, const Classes& classes) {
  const double n = static_cast<double>(ensemble.failure.size());
  for (const double p : classes.thresholds) {
    if (n * p < 1)
      note(realizations(ensemble) + " runs cannot tell where the probability falls to " + format_real(100 * p) +
           " %: the distance given is the farthest run's");
  }
}

Table class_table(const Ensemble& ensemble) {
  const Classes classes;
  note_thin_tail(ensemble, classes);
  Table table({"quantity", "class", "probability", "distance_m", "ci_low_m", "ci_high_m"});
  for (const Reach* reach : {&ensemble.influence, &ensemble.runout}) {
    for (const Boundary& boundary : boundaries(reach->sample, classes))
      table.add_row({reach->quantity, boundary.name, format_real(boundary.probability), format_real(boundary.distance.value),
                     format_limit(boundary.distance.interval.low), format_limit(boundary.distance.interval.high)});
  }
  return table;
}

Table curve_table(const Ensemble& ensemble) {
  const double failure = failure_probability(ensemble).value;
  Table table({"quantity", "distance_m", "probability", "ci_low", "ci_high", "normal", "lognormal"});
  for (const Reach* reach : {&ensemble.influence, &ensemble.runout}) {
    const std::vector<double> distances = curve_distances(moments_of(known_values(reach->sample)).maximum());
    for (const CurvePoint& point : exceedance_curve(reach->sample, reach->of_slides, failure, distances))
      table.add_row({reach->quantity, format_real(point.distance), format_real(point.exceedance.value),
                     format_real(point.exceedance.interval.low), format_real(point.exceedance.interval.high), format_real(point.normal),
                     format_real(point.lognormal)});
  }
  return table;
}

struct Structure {
  std::string name;
  std::string side;  // "toe" or "crest"
  double distance = 0;
};

Structure structure_of(const Table& table, std::size_t index) {
  const Structure structure{table.text(index, "name"), table.text(index, "side"), table.number(index, "distance_m")};
  if (structure.name.empty()) fail_at(table.where(index), "column 'name': found nothing, expected a name");
  if (structure.side != "toe" && structure.side != "crest")
    fail_at(table.where(index), "column 'side': found '" + structure.side + "', expected toe or crest");
  if (structure.distance < 0)
    fail_at(table.where(index), "column 'distance_m': found '" + table.text(index, "distance_m") +
                                    "', expected a distance >= 0 from the toe or the crest, away from the slope");
  return structure;
}

std::vector<Structure> read_structures(const std::string& path) {
  const std::vector<std::string> columns = {"name", "side", "distance_m"};
  const Table table = parse_tsv(read_input(path), input_name(path), "slidezone-structures-input 1", columns);
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

Table structure_table(const Ensemble& ensemble, const std::string& path) {
  const Classes classes;
  Table table({"name", "side", "distance_m", "probability", "ci_low", "ci_high", "class", "class_low", "class_high"});
  for (const Structure& structure : read_structures(path)) {
    const Reach& reach = structure.side == "toe" ? ensemble.runout : ensemble.influence;
    const Estimate hazard = exceedance_estimate(reach.sample, structure.distance);
    table.add_row({structure.name, structure.side, format_real(structure.distance), format_real(hazard.value),
                   format_real(hazard.interval.low), format_real(hazard.interval.high), class_of(classes, hazard.value),
                   class_of(classes, hazard.interval.low), class_of(classes, hazard.interval.high)});
  }
  return table;
}

void run(const Options& options) {
  const bool is_stdin_taken = std::find(options.rows.begin(), options.rows.end(), "-") != options.rows.end();
  if (options.structures == "-" && is_stdin_taken)
    throw Error(ExitCode::usage, "rows and structures cannot both come from stdin; give one of them as a file");
  const std::vector<Row> rows = read_rows(options.rows);
  const Ensemble ensemble = ensemble_of(rows);
  for (const std::string& caution : cautions(rows)) warn(caution);

  const std::string kind = options.wants_curve ? "curve" : options.structures.empty() ? "classes" : "structures";
  const Table table = options.wants_curve          ? curve_table(ensemble)
                      : options.structures.empty() ? class_table(ensemble)
                                                   : structure_table(ensemble, options.structures);
  Provenance origin = provenance("slidezone-" + kind + " 1", "zoning");
  origin.details.emplace_back("rows", checksum(rows));
  origin.details.emplace_back("realizations", realizations(ensemble));
  write_output(options.output, to_tsv(table, origin));
}

}  // namespace
}  // namespace slidezone

int main(int argc, char** argv) {
  using namespace slidezone;
  Options options;
  CLI::App app{manual, "zoning"};
  app.add_option("ROWS", options.rows, "Tables of rows, one or several; - is stdin")->capture_default_str();
  auto* classes = app.add_flag("--classes", options.wants_classes, "Boundaries of the classes (the default)");
  auto* curve = app.add_flag("--curve", options.wants_curve, "The exceedance curve");
  auto* structures = app.add_option("--structures", options.structures, "Classes of the structures in FILE")->type_name("FILE");
  classes->excludes(curve)->excludes(structures);
  curve->excludes(structures);
  app.add_option("-o,--output", options.output, "Where the table goes; - is stdout")->type_name("FILE")->capture_default_str();
  return tool_main(app, "cat rows/*.tsv | zoning --curve", argc, argv, [&] { run(options); });
}
