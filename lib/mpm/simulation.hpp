// One run of the material point method: the time loop around the two sweeps (MUSL, GIMP), with its guards.
//
// Step limit: dt <= a min(cell) / c with c = sqrt(M / rho) the speed of plane waves, M the constrained modulus, and a <= 1 what the
// method allows (stable_part.hpp; 1 for the default).
// Energy audit: work of gravity = internal work + friction work + damping + kinetic energy of the points. What does not close is the
// error; it is the guard that sees an unstable step while all numbers still look plausible. What the base takes or gives by pressing
// is error too: it does not move, so it should do no work. So is what friction takes beyond Coulomb's law (coulomb_watch.hpp). The error
// is measured by the work of gravity or, where the soil hardly sinks, by what it started with: its kinetic energy, and the work that
// gravity would do on it over a thousandth of its height.
// Rest: see rest_watch.hpp.
// Ends: `diverged` names point, step and time; a point outside the grid ends the run as `left_domain`.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "grid/grid_shape.hpp"
#include "mpm/coulomb_watch.hpp"
#include "mpm/points.hpp"
#include "mpm/settings.hpp"
#include "mpm/sweeps.hpp"
#include "soil/material.hpp"

namespace slidezone {

struct EnergyAudit {
  double gravity_work = 0;  // J/m
  double internal_work = 0;
  double friction_work = 0;
  double friction_excess = 0;  // what of it is beyond Coulomb's law
  double damping_work = 0;
  double kinetic = 0;     // of the points, less what they began with
  double least_work = 0;  // the error is measured by this at least

  double missing() const { return gravity_work - internal_work - friction_work - damping_work - kinetic; }
  /// What does not close and, with the same sign, friction's excess, as a part of gravity's work or of least_work, whichever is more.
  double error() const;
};

/// A run between two steps, before any point has yielded. Models share it that differ in strength alone and are nowhere weaker than
/// the one that it was made with.
struct ElasticStage {
  std::vector<double> kinetic;       // energy on the grid after each step so far, J/m
  Points points;                     // in the order of the run; mass, strains, strength and soil are those of each model
  NodeBox box;                       // the nodes that points reach
  std::vector<double> new_velocity;  // of these nodes, as in Nodes, m/s
  EnergyAudit energy;
  std::vector<ColumnContact> contact;  // with the base in the window in progress; empty where nothing watches it

  std::uint64_t steps() const { return kinetic.size(); }
};

/// Everything that a run starts from.
struct Model {
  GridShape grid;
  double point_spacing_x = 0;  // m; a point's domain
  double point_spacing_y = 0;
  std::vector<Material> soils;
  std::vector<Material> point_soils;  // of each point by label, where parameters vary from point to point; empty: all have their layer's
  Points points;
  Boundaries boundaries;
  Gravity gravity;
  TimeStepping time;
  Scheme method;
  std::optional<NonlocalSoftening> nonlocal_softening;
  std::optional<ElasticStage> stage;  // where the run begins; absent: with the points at their start
  int threads = 1;                    // that share a run of Strips::least_points or more; the result is the same for any number
  bool refuses_long_steps = true;     // beyond step_limit; tests that look for the true limit say false
};

enum class Ending { at_end, at_rest, left_domain, diverged };

struct Outcome {
  Ending ending = Ending::at_end;
  std::uint64_t steps = 0;
  double time = 0;                                              // s
  double rest_time = std::numeric_limits<double>::quiet_NaN();  // s, when motion ended for good; nan if it did not
  EnergyAudit energy;
  std::string trouble;  // which point, step and time, where the run diverged or left the grid
  Points points;        // in the order of Model::points
};

/// What an observer is shown after every step.
struct Moment {
  std::uint64_t step;
  std::uint64_t last_step;
  double time;
  const std::function<Points()>& points;  // a copy with the step completed; costs, so ask only when needed
};
using Observer = std::function<void(const Moment&)>;

/// The soil of point p: its own, or that of its layer. Its peak cohesion is Points::peak_cohesion.
const Material& soil_of(const Model& model, const Points& points, std::size_t p);

/// Longest step that is stable wherever points lie, s; 0 where none is.
double step_limit(const Model& model);

/// The step that the run takes: as the scene says, or its fraction of the limit. Throws Error(ExitCode::data) for a step
/// beyond the limit that the model refuses.
double time_step(const Model& model);

/// Which parts of the soil model the run needs.
SoilTraits soil_traits(const Model& model);

/// What the sweeps are compiled for. Leaving out what no soil needs saves time and changes no bit of the result.
struct Kernel {
  InstructionSet set = best_instruction_set();
  SoilTraits traits;  // all that there is
};

/// The leanest kernel that can run the model on this processor.
Kernel kernel_for(const Model& model);

/// The model's elastic stage: a run that begins with it has the same bits as one from the start. It ends before the step in which the
/// first point yields, or up to 50 steps earlier where the run is divided into strips; nothing where soil yields at once.
std::optional<ElasticStage> elastic_stage(Model model);

/// Runs the model. Tests and benchmarks choose the kernel; one that leaves out what the model needs gives wrong results.
Outcome simulate(Model model, const Observer& observer = {}, std::optional<Kernel> kernel = {});

}  // namespace slidezone
