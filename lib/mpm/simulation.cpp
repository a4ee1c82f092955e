#include "mpm/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "mpm/nodes.hpp"

namespace slidezone {

namespace {

constexpr std::uint64_t sort_interval = 50;  // steps
constexpr double rest_fraction = 0.003;      // of the peak kinetic energy, where the scene has no rest rule

double kinetic_energy(const Points& points) {
  double energy = 0;
  for (std::size_t p = 0; p < points.count(); ++p) {
    const double vx = points.velocity[2 * p];
    const double vy = points.velocity[2 * p + 1];
    energy += 0.5 * points.mass[p] * (vx * vx + vy * vy);
  }
  return energy;
}

/// Work of gravity on all points over a thousandth of their height.
double work_of_a_small_fall(const Points& points, const Model& model) {
  constexpr double part = 1e-3;
  const auto [lowest, highest] = std::minmax_element(points.y.begin(), points.y.end());
  const double height = *highest - *lowest + model.point_spacing_y;
  const double mass = std::accumulate(points.mass.begin(), points.mass.end(), 0.0);
  return mass * std::hypot(model.gravity.acceleration.x, model.gravity.acceleration.y) * part * height;
}

/// Orders points by the cell that they lie in, column by column; equal cells keep their order (counting sort).
std::vector<int> order_by_cell(const Points& points, const NodeStorage& storage, const GridShape& grid) {
  const auto cell_of = [&](std::size_t p) {
    const double column = std::clamp(points.x[p] / grid.cell_x, 0.0, static_cast<double>(storage.columns - 1));
    const double row = std::clamp(points.y[p] / grid.cell_y, 0.0, static_cast<double>(storage.rows - 1));
    return storage.index(static_cast<int>(column), static_cast<int>(row));
  };
  std::vector<int> place(storage.count() + 1, 0);
  for (std::size_t p = 0; p < points.count(); ++p) ++place[cell_of(p) + 1];
  for (std::size_t cell = 1; cell < place.size(); ++cell) place[cell] += place[cell - 1];
  std::vector<int> order(points.count());
  for (std::size_t p = 0; p < points.count(); ++p) order[static_cast<std::size_t>(place[cell_of(p)]++)] = static_cast<int>(p);
  return order;
}

std::vector<int> order_by_label(const Points& points) {
  std::vector<int> order(points.count());
  for (std::size_t p = 0; p < points.count(); ++p) order[static_cast<std::size_t>(points.label[p])] = static_cast<int>(p);
  return order;
}

/// The box with one more node on every side, within the storage: a stable step moves no point by a whole cell.
NodeBox grown(const NodeBox& box, const NodeStorage& storage) {
  return {std::max(0, box.first_column - 1), std::min(storage.columns - 1, box.last_column + 1), std::max(0, box.first_row - 1),
          std::min(storage.rows - 1, box.last_row + 1)};
}

SweepData sweep_data(Points& points, Nodes& nodes, const std::vector<SoilConstants>& soils, const Model& model, const NodeBox& box,
                     double step) {
  return {.point_count = points.count(),
          .x = points.x.data(),
          .y = points.y.data(),
          .velocity = points.velocity.data(),
          .movement = points.movement.data(),
          .xx = points.xx.data(),
          .yy = points.yy.data(),
          .zz = points.zz.data(),
          .xy = points.xy.data(),
          .volume = points.volume.data(),
          .plastic_strain = points.plastic_strain.data(),
          .mass = points.mass.data(),
          .peak_cohesion = points.peak_cohesion.data(),
          .soil = points.soil.data(),
          .soils = soils.data(),
          .node_mass = nodes.mass.data(),
          .node_momentum = nodes.velocity.data(),
          .node_force = nodes.change.data(),
          .node_velocity = nodes.velocity.data(),
          .node_change = nodes.change.data(),
          .node_new_momentum = nodes.new_velocity.data(),
          .node_new_velocity = nodes.new_velocity.data(),
          .storage = nodes.storage,
          .box = box,
          .grid = model.grid,
          .half_size_x = 0.5 * model.point_spacing_x / model.grid.cell_x,
          .half_size_y = 0.5 * model.point_spacing_y / model.grid.cell_y,
          .step = step};
}

/// When the grid's kinetic energy last was above a fraction of its peak.
class RestWatch {
 public:
  explicit RestWatch(double fraction) : fraction_(fraction) {}
  void see(double time, double kinetic) {
    peak_ = std::max(peak_, kinetic);
    if (kinetic > fraction_ * peak_) moving_until_ = time;
  }
  double moving_until() const { return moving_until_; }

 private:
  double fraction_;
  double peak_ = 0;
  double moving_until_ = 0;
};

/// Names what is wrong with the points: the first one that is outside the grid, or has lost its volume or its numbers.
std::string trouble_of(const Points& points, const GridShape& grid, std::uint64_t step, double time) {
  const auto at = " at step " + std::to_string(step) + ", time " + format_brief(time, 6) + " s";
  for (std::size_t p = 0; p < points.count(); ++p) {
    const double x = points.x[p];
    const double y = points.y[p];
    const std::string name = "point " + std::to_string(points.label[p]);
    const std::string place = " at (" + format_brief(x) + ", " + format_brief(y) + ") m";
    if (!std::isfinite(x + y + points.xx[p] + points.yy[p] + points.xy[p] + points.velocity[2 * p] + points.velocity[2 * p + 1]))
      return name + " has numbers that are not finite" + at;
    if (!(points.volume[p] > 0)) return name + place + " has lost its volume" + at;
    if (x < 0 || x > grid.width() || y < 0 || y > grid.height())
      return name + place + " lies outside the grid of " + format_brief(grid.width()) + " x " + format_brief(grid.height()) + " m" + at;
  }
  return "a point moved by more than a cell" + at;
}

/// The state of a run between steps.
class Run {
 public:
  Run(Model model, InstructionSet set)
      : model_(std::move(model)),
        points_(std::move(model_.points)),
        nodes_(NodeStorage(model_.grid)),
        step_(time_step(model_)),
        sweeps_(slidezone::sweeps(set, soil_traits(model_))),
        kinetic_at_start_(kinetic_energy(points_)) {
    audit_.least_work = std::max(kinetic_at_start_, work_of_a_small_fall(points_, model_));
    for (const Material& soil : model_.soils) soils_.push_back(soil_constants(soil));
    settings_ = {model_.grid, model_.boundaries, least_mass_fraction * *std::max_element(points_.mass.begin(), points_.mass.end()), step_};
    box_ = {0, nodes_.storage.columns - 1, 0, nodes_.storage.rows - 1};
    box_ = sweeps_.update(data()).box;  // at rest on a resting grid: nothing changes, but the box is found
  }

  /// One step; false ends the run.
  bool advance(double time) {
    if (steps_ % sort_interval == 0) points_ = reordered(points_, order_by_cell(points_, nodes_.storage, model_.grid));
    const NodeBox box = grown(box_, nodes_.storage);
    clear_sums(nodes_, box);
    box_ = box;
    const SweepReport report = sweeps_.update_and_map(data());
    audit_.internal_work += report.internal_work;
    if (report.is_broken) return stop(Ending::diverged, time);
    box_ = report.box;
    if (reaches_edge() && has_left_grid()) return stop(Ending::left_domain, time);
    const NodeEnergies energies = update_velocities(nodes_, box_, gravity(time), settings_);
    audit_.gravity_work += energies.gravity_work;
    audit_.friction_work += energies.friction_work;
    grid_kinetic_ = energies.kinetic;
    if (!std::isfinite(grid_kinetic_)) return stop(Ending::diverged, time);
    clear_new_sums(nodes_, box_);
    sweeps_.gather_and_map(data());
    update_new_velocities(nodes_, box_, settings_);
    ++steps_;
    return true;
  }

  double step() const { return step_; }
  std::uint64_t steps() const { return steps_; }
  double grid_kinetic() const { return grid_kinetic_; }

  /// The points with the step in progress completed, in their first order; the run itself is not touched.
  Points completed_points() const {
    Run copy = *this;
    copy.complete();
    return reordered(copy.points_, order_by_label(copy.points_));
  }

  Outcome finish(Ending ending, double time) {
    if (!has_stopped_) complete();
    audit_.kinetic = kinetic_energy(points_) - kinetic_at_start_;
    Outcome outcome;
    outcome.ending = has_stopped_ ? ending_ : ending;
    outcome.steps = steps_;
    outcome.time = time;
    outcome.energy = audit_;
    outcome.trouble = trouble_;
    outcome.points = reordered(points_, order_by_label(points_));
    return outcome;
  }

 private:
  /// Whether points reach the nodes of a side that does not hold them back: then each is looked at.
  bool reaches_edge() const {
    const bool at_left = model_.boundaries.left == Wall::open && box_.first_column <= NodeStorage::padding;
    const bool at_right = model_.boundaries.right == Wall::open && box_.last_column > model_.grid.cells_x + NodeStorage::padding;
    return at_left || at_right || box_.last_row > model_.grid.cells_y + NodeStorage::padding;
  }

  bool has_left_grid() const {
    for (std::size_t p = 0; p < points_.count(); ++p)
      if (points_.x[p] < 0 || points_.x[p] > model_.grid.width() || points_.y[p] > model_.grid.height()) return true;
    return false;
  }

  SweepData data() { return sweep_data(points_, nodes_, soils_, model_, box_, step_); }

  Vec2 gravity(double time) const {
    const bool is_ramp = model_.gravity.protocol == GravityProtocol::ramp;
    const double part = is_ramp ? std::min(1.0, (time + 0.5 * step_) / model_.gravity.ramp_time) : 1;
    return {part * model_.gravity.acceleration.x, part * model_.gravity.acceleration.y};
  }

  /// Stress and movement of the step in progress.
  void complete() {
    box_ = grown(box_, nodes_.storage);
    audit_.internal_work += sweeps_.update(data()).internal_work;
  }

  bool stop(Ending ending, double time) {
    has_stopped_ = true;
    ending_ = ending;
    trouble_ = trouble_of(points_, model_.grid, steps_, time);
    return false;
  }

  Model model_;
  Points points_;
  Nodes nodes_;
  double step_;
  Sweeps sweeps_;
  double kinetic_at_start_;
  std::vector<SoilConstants> soils_;
  NodeSettings settings_;
  NodeBox box_;
  EnergyAudit audit_;
  double grid_kinetic_ = 0;
  std::uint64_t steps_ = 0;
  bool has_stopped_ = false;
  Ending ending_ = Ending::at_end;
  std::string trouble_;
};

}  // namespace

double EnergyAudit::error() const {
  const double measure = std::max(std::abs(gravity_work), least_work);
  return measure > 0 ? missing() / measure : 0;
}

double step_limit(const Model& model) {
  double fastest = 0;
  for (const Material& soil : model.soils) fastest = std::max(fastest, std::sqrt(constrained_modulus(soil) / soil.density));
  return std::min(model.grid.cell_x, model.grid.cell_y) / fastest;
}

double time_step(const Model& model) {
  const double limit = step_limit(model);
  const double step = model.time.step.value_or(model.time.step_fraction * limit);
  if (step <= limit || !model.refuses_long_steps) return step;
  throw Error(ExitCode::data, "the time step of " + format_brief(step) + " s is beyond the stability limit of " + format_brief(limit) +
                                  " s (smallest cell over the fastest wave); take a smaller step, or 'step_fraction'");
}

SoilTraits soil_traits(const Model& model) {
  SoilTraits traits{false, false, model.soils.size() > 1};
  for (const Material& soil : model.soils) {
    traits.has_cone |= soil.peak_friction_angle > 0 || soil.dilation_angle > 0 || std::isfinite(soil.tension_cutoff);
    traits.has_softening |=
        soil.residual_cohesion < soil.peak_cohesion || soil.residual_friction_angle < soil.peak_friction_angle || soil.softening_shape > 0;
  }
  return traits;
}

Outcome simulate(Model model, const Observer& observer, std::optional<InstructionSet> set) {
  const TimeStepping stepping = model.time;
  Run run(std::move(model), set.value_or(best_instruction_set()));
  const auto last_step = static_cast<std::uint64_t>(std::ceil(stepping.end / run.step() - 1e-9));
  const std::function<Points()> points = [&run] { return run.completed_points(); };
  RestWatch watch(stepping.rest ? stepping.rest->fraction : rest_fraction);
  Ending ending = Ending::at_end;
  double time = 0;
  while (run.steps() < last_step && run.advance(time)) {
    time = static_cast<double>(run.steps()) * run.step();
    watch.see(time, run.grid_kinetic());
    if (observer) observer({run.steps(), last_step, time, points});
    if (stepping.rest && time - watch.moving_until() >= stepping.rest->hold) {
      ending = Ending::at_rest;
      break;
    }
  }
  Outcome outcome = run.finish(ending, time);
  if (watch.moving_until() < time) outcome.rest_time = watch.moving_until();
  return outcome;
}

}  // namespace slidezone
