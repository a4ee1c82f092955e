#include "mpm/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "mpm/contact.hpp"
#include "mpm/nodes.hpp"
#include "mpm/nonlocal_softening.hpp"
#include "mpm/point_order.hpp"
#include "mpm/rest_watch.hpp"
#include "mpm/stable_part.hpp"
#include "mpm/strips.hpp"

namespace slidezone {

namespace {

/// Every soil that some point has.
const std::vector<Material>& materials(const Model& model) { return model.point_soils.empty() ? model.soils : model.point_soils; }

/// Points are sorted once more than this part of them is out of order: half or twice as many take as long, as sorting takes
/// two fifths of a step.
constexpr double bearable_disorder = 1.0 / 32;
/// Large runs, which are divided into strips whenever their points are sorted, can be resumed where that is due.
constexpr std::uint64_t division_interval = 50;  // steps

template <class Real>
double kinetic_energy(const PointsOf<Real>& points) {
  double energy = 0;
  for (std::size_t p = 0; p < points.count(); ++p) {
    const double vx = points.velocity[2 * p];
    const double vy = points.velocity[2 * p + 1];
    energy += 0.5 * points.mass[p] * (vx * vx + vy * vy);
  }
  return energy;
}

template <class Real>
double height_of(const PointsOf<Real>& points, const Model& model) {
  const auto [lowest, highest] = std::minmax_element(points.y.begin(), points.y.end());
  return *highest - *lowest + model.point_spacing_y;
}

/// Work of gravity on all points over a thousandth of their height.
template <class Real>
double work_of_a_small_fall(const PointsOf<Real>& points, const Model& model) {
  constexpr double part = 1e-3;
  const double mass = std::accumulate(points.mass.begin(), points.mass.end(), 0.0);
  return mass * std::hypot(model.gravity.acceleration.x, model.gravity.acceleration.y) * part * height_of(points, model);
}

/// Steps in the period of the first vertical vibration of soil that is free above and held below, where its waves are slowest.
std::uint64_t steps_of_a_vibration(double height, const Model& model, double step) {
  double slowest = std::numeric_limits<double>::infinity();
  for (const Material& soil : materials(model)) slowest = std::min(slowest, std::sqrt(constrained_modulus(soil) / soil.density));
  return static_cast<std::uint64_t>(std::ceil(4 * height / (slowest * step)));
}

/// Size of a point's domain in cells, halved.
HalfSize half_size(const Model& model) {
  if (model.method.shape_functions == ShapeFunctions::linear) return {0, 0};
  return {0.5 * model.point_spacing_x / model.grid.cell_x, 0.5 * model.point_spacing_y / model.grid.cell_y};
}

/// Storage of what averaging over cells needs.
template <class Real>
struct DilationStorage {
  std::vector<Real> xx, xy, yx, yy;
  std::vector<int> cell;
  std::vector<Real> cell_volume, cell_dilation, cell_now_volume, cell_pressure;

  DilationStorage(std::size_t points, std::size_t cells)
      : xx(points),
        xy(points),
        yx(points),
        yy(points),
        cell(points),
        cell_volume(cells),
        cell_dilation(cells),
        cell_now_volume(cells),
        cell_pressure(cells) {}

  Dilation<Real> view() {
    return {
        xx.data(),           xy.data(), yx.data(), yy.data(), cell.data(), cell_volume.data(), cell_dilation.data(), cell_now_volume.data(),
        cell_pressure.data()};
  }
  void clear_sums() {
    for (auto* sums : {&cell_volume, &cell_dilation, &cell_now_volume, &cell_pressure}) std::fill(sums->begin(), sums->end(), Real{0});
  }
};

/// Where points lie in their cells, as the sweeps found last.
template <class Real>
struct Places {
  PointNumbers<Real> s_x, s_y;
  PointNumbers<int> first_node;

  explicit Places(std::size_t points) : s_x(points), s_y(points), first_node(points) {}
};

/// Names what is wrong with the points: the first one that is outside the grid, or has lost its volume or its numbers.
template <class Real>
std::string trouble_of(const PointsOf<Real>& points, const GridShape& grid, std::uint64_t step, double time) {
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
  for (std::size_t p = 0; p < points.count(); ++p)
    if (std::abs(points.movement[2 * p]) > grid.cell_x || std::abs(points.movement[2 * p + 1]) > grid.cell_y)
      return "point " + std::to_string(points.label[p]) + " moved by more than a cell" + at;
  return "a point moved by more than a cell" + at;
}

/// The state of a run between steps.
template <class Real>
class Run {
 public:
  Run(Model model, Kernel kernel)
      : model_(std::move(model)),
        points_(converted<Real>(std::move(model_.points))),
        places_(points_.count()),
        nodes_(NodeStorage(model_.grid)),
        step_(time_step(model_)),
        sweeps_(slidezone::sweeps<Real>(kernel.set, kernel.traits)),
        strips_(model_.threads),
        kinetic_at_start_(kinetic_energy(points_)) {
    audit_.least_work = std::max(kinetic_at_start_, work_of_a_small_fall(points_, model_));
    for (const Material& soil : materials(model_)) soils_.push_back(soil_constants<Real>(soil));
    const double heaviest = *std::max_element(points_.mass.begin(), points_.mass.end());
    settings_ = {model_.grid, model_.boundaries, least_mass_fraction<Real> * heaviest, step_};
    if (model_.boundaries.has_friction())
      coulomb_.emplace(model_.boundaries.base_friction, steps_of_a_vibration(height_of(points_, model_), model_, step_), nodes_.storage);
    if (model_.method.anti_locking == AntiLocking::b_bar) dilation_.emplace(points_.count(), nodes_.storage.count());
    if (model_.nonlocal_softening) {
      nonlocal_.emplace(points_, model_.soils, model_.point_spacing_x, model_.point_spacing_y, *model_.nonlocal_softening);
      points_.softening_strain = points_.plastic_strain;
      average_interval_ = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(NonlocalAverage::interval / step_));
    }
    box_ = {0, nodes_.storage.columns - 1, 0, nodes_.storage.rows - 1};
    box_ = sweeps_.place(data()).box;
    if (model_.stage)
      begin_with(*std::exchange(model_.stage, {}));
    else if (!need_sorting())
      sort_points();
  }

  /// One step; false ends the run.
  bool advance(double time) {
    if (need_sorting()) sort_points();
    if (nonlocal_ && steps_ % average_interval_ == 0) nonlocal_->update(points_, points_.softening_strain);
    box_ = grown(box_, nodes_.storage);
    nodes_.frictions.clear();
    if (can_go_as_a_wave()) return advance_as_a_wave(time);
    begin_step(nodes_, box_);
    const SweepReport report = model_.method.update_order == UpdateOrder::usf ? stress_first() : stress_last();
    audit_.internal_work += report.internal_work;
    if (report.is_broken) return stop(Ending::diverged, time);
    box_ = report.box;
    out_of_order_ = report.out_of_order;
    if (reaches_edge() && has_left_grid()) return stop(Ending::left_domain, time);
    NodeEnergies energies;
    update_velocities(nodes_, energies, box_, gravity(time), settings_, contact());
    audit_.gravity_work += energies.gravity_work(gravity(time), step_);
    grid_kinetic_ = energies.kinetic();
    if (!std::isfinite(grid_kinetic_)) return stop(Ending::diverged, time);
    follow_nodes();
    ++steps_;
    return true;
  }

  double step() const { return step_; }
  std::uint64_t steps() const { return steps_; }
  double time() const { return static_cast<double>(steps_) * step_; }
  double grid_kinetic() const { return grid_kinetic_; }
  const PointsOf<Real>& points() const { return points_; }

  /// Whether a run that begins here does the same: strips are divided where sorting is due.
  bool can_be_resumed() const { return points_.count() < Strips::least_points || is_division_due(); }

  /// After steps without yield; their kinetic energies are left to fill in.
  ElasticStage stage() const {
    ElasticStage stage{{}, converted<double>(points_), box_, new_velocities_in(nodes_, box_), audit_, {}};
    if (coulomb_) stage.contact = coulomb_->columns();
    for (auto* of_model : {&stage.points.mass, &stage.points.plastic_strain, &stage.points.softening_strain, &stage.points.peak_cohesion})
      of_model->clear();
    stage.points.soil.clear();
    return stage;
  }

  /// The points with the step in progress completed, in their first order; the run itself is not touched.
  Points completed_points() const {
    Run copy = *this;
    copy.complete();
    reorder(copy.points_, order_by_label(copy.points_));
    return converted<double>(std::move(copy.points_));
  }

  Outcome finish(Ending ending, double time) {
    if (!has_stopped_) complete();
    audit_.kinetic = kinetic_energy(points_) - kinetic_at_start_;
    if (coulomb_) audit_.friction_excess += coulomb_->excess();
    Outcome outcome;
    outcome.ending = has_stopped_ ? ending_ : ending;
    outcome.steps = steps_;
    outcome.time = time;
    outcome.energy = audit_;
    outcome.trouble = trouble_;
    reorder(points_, order_by_label(points_));
    outcome.points = converted<double>(std::move(points_));
    return outcome;
  }

 private:
  void begin_with(ElasticStage stage) {
    reorder(points_, stage.points.label);
    auto begun = converted<Real>(std::move(stage.points));
    using Begun = decltype(begun);
    for (auto places : {&Begun::x, &Begun::y}) points_.*places = std::move(begun.*places);
    for (auto values : {&Begun::velocity, &Begun::movement, &Begun::xx, &Begun::yy, &Begun::zz, &Begun::xy, &Begun::volume})
      points_.*values = std::move(begun.*values);
    box_ = stage.box;
    out_of_order_ = sweeps_.place(data()).out_of_order;
    set_new_velocities(nodes_, box_, stage.new_velocity);
    audit_ = stage.energy;
    steps_ = stage.steps();
    grid_kinetic_ = stage.kinetic.back();
    if (coulomb_) coulomb_->go_on(std::move(stage.contact), steps_);
  }

  // ---- parts of a step ----

  bool is_division_due() const { return points_.count() >= Strips::least_points && steps_ % division_interval == 0; }

  /// Depends on nothing but where points are and how they are sorted, so that runs may be resumed.
  bool need_sorting() const {
    return out_of_order_ > bearable_disorder * static_cast<double>(points_.count()) || is_division_due() || strips_.need_division();
  }

  void sort_points() {
    reorder(points_, order_by_node(places_.first_node));
    out_of_order_ = sweeps_.place(data()).out_of_order;
    strips_.divide(points_.count(), box_, [&](std::size_t p) { return places_.first_node[p] / nodes_.storage.rows; });
  }

  /// MUSL where nothing has to be known of all points between the two sweeps; points that may leave the grid are looked at there.
  bool can_go_as_a_wave() const {
    return strips_.are_many() && model_.method.update_order == UpdateOrder::musl && !dilation_ &&
           model_.boundaries.base != BaseContact::two_body && !reaches_edge();
  }

  /// The same as the rest of `advance`, with points read once.
  bool advance_as_a_wave(double time) {
    NodeEnergies energies;
    const auto between = [&](const NodeBox& box) {
      fold_mass(nodes_, box, settings_);
      update_velocities(nodes_, energies, box, gravity(time), settings_, {});
    };
    const TwoSweeps<Real> sweeps = {.sweep_a = sweeps_.update_and_map,
                                    .sweep_b = sweeps_.gather_and_map,
                                    .prepare = [&](const NodeBox& box) { begin_step(nodes_, box); },
                                    .between = between,
                                    .finish = [&](const NodeBox& box) { update_new_velocities(nodes_, box, settings_); }};
    const TwoReports reports = strips_.pass(sweeps, data());
    audit_.internal_work += reports.a.internal_work;
    if (reports.a.is_broken) return stop(Ending::diverged, time);
    box_ = reports.a.box;
    out_of_order_ = reports.a.out_of_order;
    audit_.gravity_work += energies.gravity_work(gravity(time), step_);
    grid_kinetic_ = energies.kinetic();
    if (!std::isfinite(grid_kinetic_)) return stop(Ending::diverged, time);
    audit_.damping_work += reports.b;
    count_friction();
    ++steps_;
    return true;
  }

  /// MUSL and USL: stress by the last node velocities, move, then everything to the nodes.
  SweepReport stress_last() {
    SweepReport report;
    if (dilation_) {
      report = update_with_mean_dilation();
      strips_.stay(sweeps_.map_with_mean_stress, data());
    } else {
      report = strips_.move(sweeps_.update_and_map, data());
    }
    fold_mass(nodes_, report.box, settings_);
    return report;
  }

  SweepReport update_with_mean_dilation() {
    dilation_->clear_sums();
    strips_.stay(sweeps_.gather_dilation, data());
    return strips_.move(sweeps_.update_with_mean_dilation, data());
  }

  /// USF: move, momentum to the nodes, stress by their velocities, then force to the nodes.
  SweepReport stress_first() {
    const SweepReport moved = strips_.move(sweeps_.move_and_map_momentum, data());
    if (moved.is_broken) return moved;
    fold_mass(nodes_, moved.box, settings_);
    copy_momenta(nodes_, moved.box);
    update_new_velocities(nodes_, moved.box, settings_);
    return strips_.stay(sweeps_.update_and_map_force, data());
  }

  /// Points follow the nodes, and the nodes get the velocities that the next strain is made of.
  void follow_nodes() {
    if (model_.method.update_order == UpdateOrder::musl) {
      audit_.damping_work += strips_.stay(sweeps_.gather_and_map, data());
      update_new_velocities(nodes_, box_, settings_);
    } else {
      audit_.damping_work += strips_.stay(sweeps_.gather, data());
      copy_velocities(nodes_, box_);
    }
    count_friction();
  }

  void count_friction() {
    for (const NodeFriction& friction : nodes_.frictions) audit_.friction_work += friction_work(friction);
    if (coulomb_) audit_.friction_excess += coulomb_->see(nodes_.frictions);
  }

  /// Stress and movement of the step in progress.
  void complete() {
    box_ = grown(box_, nodes_.storage);
    if (model_.method.update_order == UpdateOrder::usf)
      strips_.move(sweeps_.move_and_map_momentum, data());
    else if (dilation_)
      audit_.internal_work += update_with_mean_dilation().internal_work;
    else
      audit_.internal_work += strips_.move(sweeps_.update, data()).internal_work;
  }

  ContactNormals contact() const {
    if (model_.boundaries.base != BaseContact::two_body) return {};
    return contact_normals(points_, model_.grid, half_size(model_), model_.soils.back().density);
  }

  Vec2 gravity(double time) const {
    const bool is_ramp = model_.gravity.protocol == GravityProtocol::ramp;
    const double part = is_ramp ? std::min(1.0, (time + 0.5 * step_) / model_.gravity.ramp_time) : 1;
    return {part * model_.gravity.acceleration.x, part * model_.gravity.acceleration.y};
  }

  // ---- guards ----

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

  bool stop(Ending ending, double time) {
    has_stopped_ = true;
    ending_ = ending;
    trouble_ = trouble_of(points_, model_.grid, steps_, time);
    return false;
  }

  // ---- what the sweeps see ----

  SweepData<Real> data() {
    const HalfSize half = half_size(model_);
    if (dilation_) dilation_view_ = dilation_->view();
    return {.point_count = points_.count(),
            .x = points_.x.data(),
            .y = points_.y.data(),
            .velocity = points_.velocity.data(),
            .movement = points_.movement.data(),
            .xx = points_.xx.data(),
            .yy = points_.yy.data(),
            .zz = points_.zz.data(),
            .xy = points_.xy.data(),
            .volume = points_.volume.data(),
            .plastic_strain = points_.plastic_strain.data(),
            .softening_strain = nonlocal_ ? points_.softening_strain.data() : points_.plastic_strain.data(),
            .mass = points_.mass.data(),
            .peak_cohesion = points_.peak_cohesion.data(),
            .soil = model_.point_soils.empty() ? points_.soil.data() : points_.label.data(),
            .soils = soils_.data(),
            .s_x = places_.s_x.data(),
            .s_y = places_.s_y.data(),
            .first_node = places_.first_node.data(),
            .node_sums = nodes_.sums.data(),
            .node_force = nodes_.force.data(),
            .node_motion = nodes_.motion.data(),
            .node_new_momentum = nodes_.new_velocity.data(),
            .node_new_velocity = nodes_.new_velocity.data(),
            .column_ends = nodes_.ends.data(),
            .dilation = dilation_ ? &dilation_view_ : nullptr,
            .storage = nodes_.storage,
            .box = box_,
            .grid = model_.grid,
            .half_size_x = half.x,
            .half_size_y = half.y,
            .step = step_,
            .grid_part = -std::expm1(-model_.method.damping_rate * step_),
            .fetches_ahead = strips_.are_many()};
  }

  Model model_;
  PointsOf<Real> points_;
  Places<Real> places_;
  NodesOf<Real> nodes_;
  double step_;
  Sweeps<Real> sweeps_;
  Strips strips_;
  double kinetic_at_start_;
  std::vector<SoilConstantsOf<Real>> soils_;
  NodeSettings settings_;
  NodeBox box_;
  int out_of_order_ = 0;  // points; see SweepReport
  std::optional<DilationStorage<Real>> dilation_;
  Dilation<Real> dilation_view_{};
  std::optional<NonlocalAverage> nonlocal_;
  std::optional<CoulombWatch> coulomb_;
  std::uint64_t average_interval_ = 1;  // steps
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
  return measure > 0 ? (missing() + std::copysign(friction_excess, missing())) / measure : 0;
}

const Material& soil_of(const Model& model, const Points& points, std::size_t p) {
  if (model.point_soils.empty()) return model.soils[static_cast<std::size_t>(points.soil[p])];
  return model.point_soils[static_cast<std::size_t>(points.label[p])];
}

double step_limit(const Model& model) {
  const HalfSize half = half_size(model);
  double fastest = 0;
  for (const Material& soil : materials(model))
    fastest = std::max(fastest, std::sqrt(constrained_modulus(soil) / soil.density) /
                                    stable_part(model.method, std::min(half.x, half.y), soil.poisson_ratio));
  return std::min(model.grid.cell_x, model.grid.cell_y) / fastest;
}

double time_step(const Model& model) {
  const double limit = step_limit(model);
  const double step = model.time.step.value_or(model.time.step_fraction * limit);
  if ((0 < step && step <= limit) || !model.refuses_long_steps) return step;
  throw Error(ExitCode::data,
              "the time step of " + format_brief(step) + " s is beyond the stability limit of " + format_brief(limit) +
                  " s (smallest cell over the fastest wave, or what of it the method allows); take a smaller step, or 'step_fraction'");
}

SoilTraits soil_traits(const Model& model) {
  SoilTraits traits{false, false, materials(model).size() > 1};
  for (const Material& soil : materials(model)) {
    traits.has_cone |= soil.peak_friction_angle > 0 || soil.dilation_angle > 0 || std::isfinite(soil.tension_cutoff);
    traits.has_softening |=
        soil.residual_cohesion < soil.peak_cohesion || soil.residual_friction_angle < soil.peak_friction_angle || soil.softening_shape > 0;
  }
  return traits;
}

Kernel kernel_for(const Model& model) { return {best_instruction_set(), soil_traits(model)}; }

/// Steps until the end of time.
static std::uint64_t last_step(const TimeStepping& stepping, double step) {
  return static_cast<std::uint64_t>(std::ceil(stepping.end / step - 1e-9));
}

static bool is_at_rest(const TimeStepping& stepping, const RestWatch& watch, double time) {
  return stepping.rest && time - watch.moving_until() >= stepping.rest->hold;
}

template <class Real>
static bool has_yielded(const PointsOf<Real>& points) {
  return std::any_of(points.plastic_strain.begin(), points.plastic_strain.end(), [](Real strain) { return strain > 0; });
}

static bool is_single(const Model& model) { return model.method.precision == Precision::single_precision; }

template <class Real>
static std::optional<ElasticStage> elastic_stage_in(Model model) {
  const TimeStepping stepping = model.time;
  const Kernel kernel = kernel_for(model);
  Run<Real> run(std::move(model), kernel);
  RestWatch watch(stepping.rest.value_or(RestRule{}));
  std::vector<double> kinetic;
  std::optional<ElasticStage> stage;
  std::size_t steps_of_stage = 0;
  while (run.steps() < last_step(stepping, run.step()) && run.advance(run.time())) {
    kinetic.push_back(run.grid_kinetic());
    watch.see(run.time(), run.grid_kinetic(), run.points());
    if (is_at_rest(stepping, watch, run.time())) break;
    if (has_yielded(run.points())) break;
    if (!run.can_be_resumed()) continue;
    stage = run.stage();
    steps_of_stage = kinetic.size();
  }
  kinetic.resize(steps_of_stage);
  if (stage) stage->kinetic = std::move(kinetic);
  return stage;
}

std::optional<ElasticStage> elastic_stage(Model model) {
  return is_single(model) ? elastic_stage_in<float>(std::move(model)) : elastic_stage_in<double>(std::move(model));
}

template <class Real>
static Outcome simulate_in(Model model, const Observer& observer, Kernel kernel) {
  const TimeStepping stepping = model.time;
  const std::vector<double> kinetic_of_stage = model.stage ? model.stage->kinetic : std::vector<double>{};
  Run<Real> run(std::move(model), kernel);
  const std::uint64_t last = last_step(stepping, run.step());
  const std::function<Points()> points = [&run] { return run.completed_points(); };
  RestWatch watch(stepping.rest.value_or(RestRule{}));
  for (std::size_t step = 1; const double kinetic : kinetic_of_stage)
    watch.see(static_cast<double>(step++) * run.step(), kinetic, run.points());
  Ending ending = Ending::at_end;
  double time = run.time();
  while (run.steps() < last && run.advance(time)) {
    time = run.time();
    watch.see(time, run.grid_kinetic(), run.points());
    if (observer) observer({run.steps(), last, time, points});
    if (is_at_rest(stepping, watch, time)) {
      ending = Ending::at_rest;
      break;
    }
  }
  Outcome outcome = run.finish(ending, time);
  if (watch.moving_until() < time) outcome.rest_time = watch.moving_until();
  return outcome;
}

Outcome simulate(Model model, const Observer& observer, std::optional<Kernel> kernel) {
  const Kernel chosen = kernel.value_or(kernel_for(model));
  return is_single(model) ? simulate_in<float>(std::move(model), observer, chosen)
                          : simulate_in<double>(std::move(model), observer, chosen);
}

}  // namespace slidezone
