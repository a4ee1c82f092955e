// mpmrun: fails one slope once with the material point method.
//
//   scene.toml [+ points.h5 of rfmap] [+ in_situ.h5] -> one row (influence, runout, status, audit); states and tables on request
//   scene.toml -> in_situ.h5, where all its realizations may start
//   mpmrun pipelines/benchmark/scene.toml
//
// Schemas: scene.schema.json, points.json, stage.json, row.json, state.json, table.json, profile.json in data-schemas/.
#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/progress.hpp"
#include "core/provenance.hpp"
#include "core/text.hpp"
#include "core/tool.hpp"
#include "io/file.hpp"
#include "io/units.hpp"
#include "io/vtkhdf.hpp"
#include "realization/doubts.hpp"
#include "realization/explanation.hpp"
#include "realization/in_situ.hpp"
#include "realization/realization.hpp"

namespace slidezone {

struct Options {
  std::string scene;
  std::string points;
  std::uint64_t sample = 1;
  std::string output = "-";
  std::string state;
  std::string table;
  std::string profile;
  std::string frames;
  std::string every = "1 s";
  std::string in_situ;
  int threads = 1;
  bool explain = false;
  bool makes_stage = false;
};

/// What every file of this run says of itself. A row carries its number, so that rows of one study share their provenance.
static Provenance run_provenance(const std::string& schema, const Scene& scene, const std::string& points_checksum,
                                 std::optional<std::uint64_t> sample = {}) {
  Provenance result = provenance(schema, "mpmrun");
  result.details.emplace_back("scene", scene.checksum);
  if (!points_checksum.empty()) result.details.emplace_back("points", points_checksum);
  if (sample) result.details.emplace_back("sample", std::to_string(*sample));
  return result;
}

static void write_state_file(const std::string& path, const MaterialPoints& initial, const Points& now, const Provenance& provenance) {
  OutputFile file(path);
  write_state(initial, now, provenance, [&file](std::string_view bytes) { file.write(bytes); });
  file.finish();
}

/// Writes the state every so often into a folder, with an index that ParaView plays.
class FrameWriter {
 public:
  FrameWriter(const std::string& folder, double every, const MaterialPoints& initial, const Provenance& provenance)
      : folder_(folder), every_(every), initial_(initial), provenance_(provenance) {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error) throw Error(ExitCode::cannot_create, folder + ": cannot be created: " + error.message());
  }

  void see(const Moment& moment) {
    if (moment.time + 1e-9 < every_ * static_cast<double>(frames_.size() + 1)) return;
    const std::string number = std::to_string(frames_.size() + 1);
    const std::string file = "frame-" + std::string(6 - std::min<std::size_t>(6, number.size()), '0') + number + ".hdf";
    write_state_file(folder_ / file, initial_, moment.points(), provenance_);
    frames_.push_back({file, moment.time});
    write_output(folder_ / "frames.hdf.series", vtkhdf_series(frames_));
  }

 private:
  std::filesystem::path folder_;
  double every_;
  const MaterialPoints& initial_;
  const Provenance& provenance_;
  std::vector<Frame> frames_;
};

static double frame_interval(const std::string& every) {
  try {
    const double interval = parse_quantity(every, "s");
    if (interval > 0) return interval;
  } catch (const std::invalid_argument& error) {
    throw Error(ExitCode::usage, std::string("--every ") + error.what());
  }
  throw Error(ExitCode::usage, "--every wants a time above 0, found \"" + every + "\"");
}

static void report_doubts(const Doubts& doubts) {
  for (const std::string& text : doubts.warnings) warn(text);
  for (const std::string& text : doubts.notes) note(text);
}

/// What to do where the energy balance does not close.
static std::string remedy(const EnergyAudit& energy, BaseContact contact) {
  if (energy.friction_excess <= std::abs(energy.missing()))
    return "; compare a smaller time step, and note that soil which falls onto its base misses some at any";
  const std::string cause = ", most of it by friction beyond Coulomb's law: ";
  if (contact == BaseContact::two_body)
    return cause + "the normals of a two-body base lean where the soil ends; take finer cells and shorter steps";
  return cause + "soil that shakes is held down by a bilateral base; a unilateral one with a short step lets it go";
}

/// Of a run that was not stopped at an end of the grid, and yet reached one, or nearly so.
static void report_walls(const Row& row, const Scene& scene, const std::string& at_end) {
  if (row.status == Status::left_domain) {
    const bool is_right = is_at_right_wall(scene, row.runout);
    warn(std::string("left the domain: ") + (is_right ? "the slide reaches the right wall" : "the failure reaches the left wall") + at_end +
         ", so that influence and runout are lower bounds; lengthen the ground there, or call the wall \"symmetry\" in [walls] where "
         "nothing lies behind");
    return;
  }
  const double gap = scene.slope.crest.x - row.influence;
  if (goes_on_behind(scene.boundaries.left) && row.influence > 0 && gap < scene.slope.crest.y)
    note("the failure ends " + format_brief(gap, 3) +
         " m from the left wall, less than the slope's height: on longer ground it may go farther");
}

static void report_trouble(const Row& row, const Outcome& outcome, const Scene& scene) {
  if (!outcome.trouble.empty()) warn((outcome.ending == Ending::diverged ? "diverged: " : "left the domain: ") + outcome.trouble);
  if (outcome.ending == Ending::diverged) return;
  const std::string at_end = " after step " + std::to_string(outcome.steps) + ", time " + format_brief(outcome.time) + " s";
  if (outcome.trouble.empty()) report_walls(row, scene, at_end);
  const std::string missed = "the energy balance misses " + format_brief(100 * std::abs(row.energy_error), 3) + " % of the work done";
  if (row.status == Status::diverged)
    warn("diverged: " + missed + at_end + remedy(outcome.energy, scene.boundaries.base));
  else if (std::abs(row.energy_error) > energy_error_warning)
    warn(missed + remedy(outcome.energy, scene.boundaries.base));
}

static void make_stage(const Options& options, const Scene& scene, const MaterialPoints& points) {
  const std::optional<ElasticStage> stage = in_situ_stage(scene, points);
  const double time = stage ? static_cast<double>(stage->steps()) * time_step(model_of(scene, points, {})) : 0;
  note(stage ? "all realizations share " + format_brief(time, 3) + " s of " + format_brief(scene.time.end) + " s"
             : "realizations share nothing: they differ or yield from the start");
  write_output(options.output, stage_file(stage, run_provenance("slidezone-stage 1", scene, "")));
}

static void run(const Options& options) {
  if ((options.scene == "-") + (options.points == "-") + (options.in_situ == "-") > 1)
    throw Error(ExitCode::usage, "only one of scene, --points and --in-situ can come from stdin; give the others as files");
  if (options.makes_stage) refuse_terminal(options.output);
  const Scene scene = read_scene(options.scene, {.grid = true, .soil = true, .time = true});
  report_doubts(doubts_on(scene));
  const MaterialPoints points = material_points(scene);
  for (const std::string& text : doubts_on_settlement(scene, points)) warn(text);
  if (options.makes_stage) return make_stage(options, scene, points);
  if (options.points.empty())
    for (const std::string& text : differences_of_means(scene)) note(text);
  std::optional<FieldSample> sample;
  std::string points_checksum;
  if (!options.points.empty()) {
    const InputFile file(options.points);
    const std::string_view image = file.bytes();
    points_checksum = checksum(image);
    sample = field_sample(image, input_name(options.points), points, options.sample);
    if (sample->scene != scene.checksum || sample->fields_scene != scene.checksum)
      note(input_name(options.points) + " was made from another scene than " + scene.name + ", or before it was changed");
  }
  const auto detailed = [&](const std::string& schema) {
    return run_provenance(schema, scene, points_checksum, sample ? std::optional(options.sample) : std::nullopt);
  };
  Model model = model_of(scene, points, sample);
  model.threads = options.threads;
  if (!options.in_situ.empty()) {
    model.stage = stage_in(InputFile(options.in_situ).bytes(), input_name(options.in_situ), scene, points);
    if (model.stage && sample) check_shares_stage(model, scene, points, input_name(options.points));
  }
  if (options.explain) {
    write_output(options.output, explanation(model, sample.has_value(), detailed("slidezone-explanation 1")));
    return;
  }
  for (const std::string& path : {options.output, options.state, options.table, options.profile})
    if (!path.empty()) check_can_create(path);
  const Provenance state_provenance = detailed("slidezone-state 1");
  std::optional<FrameWriter> frames;
  if (!options.frames.empty()) frames.emplace(options.frames, frame_interval(options.every), points, state_provenance);

  Progress progress("mpmrun", is_quiet() ? Progress::Show::never : Progress::Show::on_terminal);
  const Outcome outcome = simulate(std::move(model), [&](const Moment& moment) {
    progress.update(static_cast<double>(moment.step) / static_cast<double>(moment.last_step), format_brief(moment.time, 3) + " s");
    if (frames) frames->see(moment);
  });

  const Row row = row_of(scene, points, sample, outcome);
  report_trouble(row, outcome, scene);
  if (!options.state.empty()) write_state_file(options.state, points, outcome.points, state_provenance);
  if (!options.table.empty()) write_output(options.table, points_table(points, outcome.points, detailed("slidezone-table 1")));
  if (!options.profile.empty())
    write_output(options.profile, profile_table(scene, points, outcome.points, detailed("slidezone-profile 1")));
  write_output(options.output, to_tsv(row, run_provenance(std::string(row_schema), scene, points_checksum)));
}

}  // namespace slidezone

int main(int argc, char** argv) {
  using namespace slidezone;
  Options options;
  CLI::App app(
      "Fails one slope once with the material point method, and prints one row.\n\n"
      "The row holds influence and runout distance, status and energy balance; data-schemas/row.json explains its columns.\n"
      "Without --points every soil has its scene's strength everywhere, and the row is that of realization 0.",
      "mpmrun");
  app.add_option("scene", options.scene, "Scene (TOML); - is stdin")->required();
  app.add_option("-o,--output", options.output, "The row (TSV); - is stdout")->capture_default_str();
  CLI::Option* points = app.add_option("--points", options.points, "Field samples at the material points, from rfmap; - is stdin");
  app.add_option("--sample", options.sample, "Number of the sample in --points")
      ->check(whole_number(1))
      ->capture_default_str()
      ->needs(points);
  app.add_option("--state", options.state, "Final state of all points, VTKHDF for ParaView and VTK (name it .hdf)");
  app.add_option("--table", options.table, "Final state of all points, as TSV");
  app.add_option("--profile", options.profile, "Ground surface before and after, as TSV");
  CLI::Option* frames = app.add_option("--frames", options.frames, "Folder for states during the run, VTKHDF with an index for ParaView");
  app.add_option("--every", options.every, "Time between frames, with its unit")->capture_default_str()->needs(frames);
  CLI::Option* in_situ =
      app.add_option("--in-situ", options.in_situ, "Start from the file of --make-in-situ; the row is the same, and some time is saved");
  in_situ->excludes(frames);
  app.add_option("--threads", options.threads, "Threads that share a run of 100,000 points or more; the result does not depend on it")
      ->check(whole_number(1, 1024))
      ->capture_default_str();
  app.add_flag("--make-in-situ", options.makes_stage,
               "In place of a row, write the state before any point yields, which all realizations share (HDF5)")
      ->excludes(points, frames, in_situ);
  app.add_flag("--explain", options.explain, "Print what this scene uses and what is left out, and why, as TSV; run nothing");
  return tool_main(app, "mpmrun pipelines/benchmark/scene.toml", argc, argv, [&] { run(options); });
}
