// zoning: how likely a place before the toe or behind the crest is to be reached, and where the hazard zones end.
// Rows ("slidezone-row 1") -> class boundaries ("slidezone-classes 1"), the exceedance curve ("slidezone-curve 1"), or the classes of
// structures ("slidezone-structures 1") that are given as a table ("slidezone-structures-input 1"). Of several studies: "slidezone-
// classes-of-studies 1", "-curve-of-studies 1", "-structures-of-studies 1". With a scene's [site]: a map ("slidezone-map 1").
//   zoning rows/*.tsv --structures structures.tsv
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/provenance.hpp"
#include "core/text.hpp"
#include "core/tool.hpp"
#include "io/file.hpp"
#include "io/table.hpp"
#include "scene/scene.hpp"
#include "summary/studies.hpp"
#include "summary/zone_map.hpp"
#include "summary/zone_tables.hpp"

namespace slidezone {
namespace {

struct Options {
  std::vector<std::string> rows = {"-"};
  std::vector<std::string> studies;  // NAME=FILE
  bool wants_classes = false;        // also without any of the three
  bool wants_curve = false;
  std::string structures;
  std::string site;  // scene
  std::vector<double> thresholds = Classes{}.thresholds;
  std::vector<std::string> names = Classes{}.names;
  std::string band = "exact";
  bool has_tails = false;
  std::string output = "-";
};

const std::vector<std::string> band_names = {"exact", "wilson", "simultaneous"};  // in the order of Band

const char* const manual = R"(Exceedance probabilities and hazard classes of places before and behind a slope.

Of the influence distance behind the crest (influence_m) and the runout distance before the toe (runout_m). Distances in m, counted away
from the slope. A place is reached where the limit state G = distance - reach is negative.

A probability is a share of all runs, failed or not; ci_low and ci_high are its 95 % band: exact (Clopper-Pearson) or Wilson's, for one
distance at a time, or simultaneous (Dvoretzky-Kiefer-Wolfowitz), for the whole curve. Runs that left the grid exceed every distance up
to their reach and are doubtful beyond, diverged runs are doubtful everywhere: doubtful runs widen the band to both sides. An end that
the runs cannot give is "unbounded". Antithetic pairs and Latin hypercubes (column design) count as fewer independent runs where those of
a block agree, never as more.

Classes by P = P(reach > distance), unless --thresholds and --class-names say otherwise:
  very_high  P > 50 %    high  50 to 10 %    medium  10 to 1 %    low  1 to 0.1 %    very_low  P <= 0.1 %

Results, one of:
  --classes   quantity class probability distance_m ci_low_m ci_high_m: the far end of each class, the distance at which P falls to
              `probability`; the last class has none. The interval is of order statistics; 1 % wants some 370 runs for an upper end,
              0.1 % some 3,700. With --tail, boundaries less likely than a tenth come from a generalized Pareto distribution fitted to
              the largest tenth of the reaches (at least 30), with the interval of its profile likelihood; the fit stands in the table's
              '#' lines: threshold, exceedances, scale, shape, Kolmogorov's distance
  --curve     quantity distance_m probability ci_low ci_high normal lognormal: P over evenly spaced distances from 0 to 1.25 times the
              farthest reach, and beside it that of the Normal and the Lognormal fit: P(failure) times the tail of the fit to the runs
              that slid; nan where there is no fit
  --structures FILE
              name side distance_m probability ci_low ci_high class class_low class_high: P at each structure, its class, and the
              classes at either end of the band. FILE is a table `name side distance_m`, side is toe or crest.
  --map SCENE the zones as GeoJSON, placed by [site] of the scene, for QGIS; with --structures FILE also the structures
Several studies (--study NAME=ROWS, once for each) give the same with a column `study` before, and then the worst case over them: the
largest value and the largest ends that any study has.)";

Classes classes_of(const Options& options) {
  if (!std::is_sorted(options.thresholds.rbegin(), options.thresholds.rend(), std::less_equal<>()))
    throw Error(ExitCode::usage, "--thresholds: expected falling probabilities, e.g. 0.5,0.1,0.01");
  if (options.names.size() != options.thresholds.size() + 1)
    throw Error(ExitCode::usage, "--class-names: found " + std::to_string(options.names.size()) + " names, expected " +
                                     std::to_string(options.thresholds.size() + 1) + ": one more than thresholds");
  return {options.thresholds, options.names};
}

Band band_of(const std::string& name) {
  return static_cast<Band>(std::find(band_names.begin(), band_names.end(), name) - band_names.begin());
}

bool is_stdin_used_twice(const Options& options) {
  const auto is_stdin = [](const std::string& path) { return path == "-" || path.ends_with("=-"); };
  const std::vector<std::string>& paths = options.studies.empty() ? options.rows : options.studies;
  return std::count_if(paths.begin(), paths.end(), is_stdin) + (options.structures == "-") + (options.site == "-") > 1;
}

std::string kind_of(const Options& options) {
  if (!options.site.empty()) return "map";
  if (options.wants_curve) return "curve";
  return options.structures.empty() ? "classes" : "structures";
}

std::vector<Structure> structures_of(const Options& options) {
  if (options.structures.empty()) return {};
  return parse_structures(read_input(options.structures), input_name(options.structures));
}

/// One of the two may be mistyped, and zones would be drawn far from the slope.
void warn_of_distant_toe(const Scene& scene) {
  const Site& site = *scene.site;
  const double on_map = std::hypot(site.toe.x - site.crest.x, site.toe.y - site.crest.y);
  const double in_section = scene.slope.toe.x - scene.slope.crest.x;
  if (std::abs(on_map - in_section) > 1 + 0.1 * in_section)
    warn(scene.name + ": [site] puts the toe " + format_brief(on_map, 8) + " m from the crest, the section " + format_brief(in_section) +
         " m");
}

std::string map_of(const NamedEnsemble& study, const ZoneOptions& zones, const Options& options, Provenance& origin) {
  const Scene scene = read_scene(options.site, {.site = true});
  warn_of_distant_toe(scene);
  const Site& site = *scene.site;
  origin.details.emplace_back("scene", scene.checksum);
  return zone_map(study.ensemble, structures_of(options), zones, {site.crest, site.toe, site.bearing, site.width}, site.epsg, origin);
}

Table table_of(const std::string& kind, std::span<const NamedEnsemble> studies, const ZoneOptions& zones, const Options& options) {
  if (kind == "curve") return curve_table(studies, zones);
  if (kind == "classes") return class_table(studies, zones);
  return structure_table(studies, structures_of(options), zones);
}

void run(const Options& options) {
  if (is_stdin_used_twice(options))
    throw Error(ExitCode::usage, "only one of rows, structures and scene can come from stdin; give the others as files");
  const std::string kind = kind_of(options);
  const bool has_boundaries = kind == "classes" || kind == "map";
  if (options.has_tails && !has_boundaries) throw Error(ExitCode::usage, "--tail is of boundaries: it wants --classes or --map");
  const ZoneOptions zones{classes_of(options), band_of(options.band), options.has_tails};
  Provenance origin = provenance("slidezone-" + kind + (options.studies.empty() ? "" : "-of-studies") + " 1", "zoning");
  const std::vector<NamedEnsemble> studies =
      options.studies.empty() ? std::vector{read_study("", options.rows, origin)} : read_studies(options.studies, origin);
  for (const NamedEnsemble& study : studies) {
    if (has_boundaries) tell_boundaries(origin, study, zones);
  }
  if (kind == "map") {
    write_output(options.output, map_of(studies.front(), zones, options, origin));
  } else {
    write_output(options.output, to_tsv(table_of(kind, studies, zones, options), origin));
  }
}

bool is_word(const std::string& text) { return !text.empty() && text.find_first_of(" \t\n:") == std::string::npos; }

bool is_named_file(const std::string& text) {
  const std::string name = text.substr(0, text.find('='));
  return is_word(name) && name != "worst_case" && name.size() + 1 < text.size();
}

bool is_band(const std::string& text) { return std::find(band_names.begin(), band_names.end(), text) != band_names.end(); }

void add_options(CLI::App& app, Options& options) {
  auto* rows = app.add_option("ROWS", options.rows, "Tables of rows, one or several; - is stdin")->capture_default_str();
  auto* studies = app.add_option("--study", options.studies, "A study's name and its rows; once for each of several studies")
                      ->allow_extra_args(false)
                      ->check(text_that(is_named_file, "NAME=FILE, the name without blanks and colons, and other than worst_case"))
                      ->type_name("NAME=ROWS")
                      ->excludes(rows);
  auto* classes = app.add_flag("--classes", options.wants_classes, "Boundaries of the classes (the default)");
  auto* curve = app.add_flag("--curve", options.wants_curve, "The exceedance curve");
  auto* structures = app.add_option("--structures", options.structures, "Classes of the structures in FILE")->type_name("FILE");
  classes->excludes(curve)->excludes(structures);
  curve->excludes(structures);
  app.add_option("--map", options.site, "Zones on the map, by [site] of the scene")
      ->type_name("SCENE")
      ->excludes(classes)
      ->excludes(curve)
      ->excludes(studies);
  app.add_option("--thresholds", options.thresholds, "Falling probabilities at which classes end, with commas between")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(real_number(1e-9, 1 - 1e-9))
      ->type_name("P,...")
      ->capture_default_str();
  app.add_option("--class-names", options.names, "Names of the classes, one more than thresholds, with commas between")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(text_that(is_word, "a name without blanks and colons"))
      ->type_name("NAME,...")
      ->capture_default_str();
  app.add_option("--band", options.band, "Band of probabilities: " + list_of(band_names))
      ->check(text_that(is_band, list_of(band_names)))
      ->type_name("BAND")
      ->capture_default_str();
  app.add_flag("--tail", options.has_tails, "Far boundaries by a generalized Pareto tail");
  app.add_option("-o,--output", options.output, "Where the table goes; - is stdout")->type_name("FILE")->capture_default_str();
}

}  // namespace
}  // namespace slidezone

int main(int argc, char** argv) {
  using namespace slidezone;
  Options options;
  CLI::App app{manual, "zoning"};
  add_options(app, options);
  return tool_main(app, "cat rows/*.tsv | zoning --curve", argc, argv, [&] { run(options); });
}
