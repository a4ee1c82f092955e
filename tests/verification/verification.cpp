// Cases with an exact answer that no scene can express, driven through lib/soil, lib/grid and lib/mpm; see
// pipelines/verification. Prints a table: case, quantity, size (of a cell, a step or a strain increment where the case is
// repeated with smaller ones, else nan), the exact value and the computed one.
//
//   verification CASE ...
#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "grid/gimp.hpp"
#include "soil/drucker_prager.hpp"
#include "verification/bodies.hpp"

namespace slidezone {
namespace {

constexpr double no_size = std::numeric_limits<double>::quiet_NaN();
using std::numbers::pi;

/// Prints rows of one case.
class Rows {
 public:
  explicit Rows(std::string name) : name_(std::move(name)) {}
  void operator()(const std::string& quantity, double exact, double computed, double size = no_size) const {
    std::cout << name_ << '\t' << quantity << '\t' << size << '\t' << exact << '\t' << computed << '\n';
  }

 private:
  std::string name_;
};

// ---- one material point -----------------------------------------------------------------------------------------------------

constexpr SoilTraits all_traits{.has_cone = true, .has_softening = true, .has_layers = true};

double mean_of(const Stress& s) { return (s.xx + s.yy + s.zz) / 3; }
double root_j2(const Stress& s) {
  const double mean = mean_of(s);
  return std::sqrt(0.5 * (std::pow(s.xx - mean, 2) + std::pow(s.yy - mean, 2) + std::pow(s.zz - mean, 2)) + s.xy * s.xy);
}

/// Elastic trial stress and its return for one strain increment along x.
Stress compressed(Stress s, const SoilConstants& soil, double strain, double cohesion, double& plastic_strain) {
  const double lambda = soil.bulk - 2 * soil.shear / 3;
  s = {s.xx + (lambda + 2 * soil.shear) * strain, s.yy + lambda * strain, s.zz + lambda * strain, s.xy};
  plastic_strain += return_to_yield<all_traits>(s, soil, yield_surface<all_traits>(soil, cohesion, plastic_strain));
  return s;
}

/// The reference point of shear of an independent return mapping.
void shear_point(const Rows& row) {
  const SoilConstants soil =
      soil_constants({.density = 1, .youngs_modulus = 10e6, .poisson_ratio = 0.3, .peak_cohesion = 2000, .residual_cohesion = 2000});
  double plastic_strain = 0;
  const Stress s = compressed({-5000, -6000, -7000, -1000}, soil, -0.001, 2000, plastic_strain);
  row("stress_xx_pa", -16537.46896, s.xx);
  row("stress_yy_pa", -12964.30500, s.yy);
  row("stress_zz_pa", -13498.22605, s.zz);
  row("stress_xy_pa", -533.92105, s.xy);
  row("plastic_strain", 2.620747e-4, plastic_strain);
}

Material frictional_soil() {
  return {.density = 2000,
          .youngs_modulus = 10e6,
          .poisson_ratio = 0.3,
          .peak_cohesion = 5e3,
          .residual_cohesion = 5e3,
          .peak_friction_angle = 30 * pi / 180,
          .residual_friction_angle = 30 * pi / 180,
          .dilation_angle = 5 * pi / 180,
          .tension_cutoff = 1e3};
}

/// Pure tension beyond the cut-off: the mean stress returns to it, the excess over K is plastic volume strain.
void tension_point(const Rows& row) {
  const SoilConstants soil = soil_constants(frictional_soil());
  Stress s{9e3, 9e3, 9e3, 0};
  const double plastic_strain = return_to_yield<all_traits>(s, soil, yield_surface<all_traits>(soil, 5e3, 0));
  row("mean_stress_pa", 1e3, mean_of(s));
  row("plastic_strain", std::sqrt(2.0) / 3 * 8e3 / soil.bulk, plastic_strain);
}

/// At the corner of both surfaces: tau there is k_c - q_phi s_t, by Koiter's rule the multipliers are the distances along
/// each axis.
void corner_point(const Rows& row) {
  const SoilConstants soil = soil_constants(frictional_soil());
  const double tangent = std::tan(30 * pi / 180);
  const double corner = (3 * 5e3 - 3 * tangent * 1e3) / std::sqrt(9 + 12 * tangent * tangent);
  Stress s{20e3 + 15e3, 20e3 - 15e3, 20e3, 0};
  const double plastic_strain = return_to_yield<all_traits>(s, soil, yield_surface<all_traits>(soil, 5e3, 0));
  row("mean_stress_pa", 1e3, mean_of(s));
  row("root_j2_pa", corner, root_j2(s));
  const double sheared = (15e3 - corner) / soil.shear;
  row("plastic_strain", std::sqrt(sheared * sheared / 3 + 2.0 / 9 * std::pow(19e3 / soil.bulk, 2)), plastic_strain);
}

/// Simple shear with softening from 20 to 4 kPa. On the yield surface tau = c(e), so that G gamma = tau + sqrt(3) G e: the
/// plastic strain at a given shear strain is the root of G gamma = c(e) + sqrt(3) G e.
void softening_point(const Rows& row) {
  Material material{.density = 1, .youngs_modulus = 1e6, .poisson_ratio = 0.33, .peak_cohesion = 20e3, .residual_cohesion = 4e3};
  material.softening_threshold = 0.05;
  material.softening_shape = 8;
  const SoilConstants soil = soil_constants(material);
  const double total = 0.4;
  const auto strength = [&](double e) { return 4e3 + 16e3 * std::exp(-8 * std::max(0.0, e - 0.05)); };
  double low = 0;
  double high = 1;
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    (strength(middle) + std::sqrt(3.0) * soil.shear * middle < soil.shear * total ? low : high) = middle;
  }
  for (const int steps : {50, 100, 200, 400}) {
    Stress s;
    double plastic_strain = 0;
    for (int k = 0; k < steps; ++k) {
      s.xy += soil.shear * total / steps;
      plastic_strain += return_to_yield<all_traits>(s, soil, yield_surface<all_traits>(soil, 20e3, plastic_strain));
    }
    row("stress_xy_pa", strength(low), s.xy, total / steps);
    row("plastic_strain", low, plastic_strain, total / steps);
  }
}

// ---- shape functions ----------------------------------------------------------------------------------------------------------

/// Greatest error of sum N = 1, sum dN = 0 and sum N x_i = x over points in and half a cell beyond a grid of three cells.
void partition_of_unity(const Rows& row) {
  double values_off = 0;
  double slopes_off = 0;
  double place_off = 0;
  for (const double l : {0.0, 0.0625, 0.125, 0.25, 0.5})
    for (double x = -0.499; x < 3.5; x += 0.001) {
      const double first = std::floor(x - l);
      const AxisWeights weights = axis_weights(x, first, l, l > 0 ? 1 / (4 * l) : 0);
      const AxisValues values = shape_values(weights);
      const AxisValues slopes = shape_slopes(weights);
      values_off = std::max(values_off, std::abs(values.node[0] + values.node[1] + values.node[2] - 1));
      slopes_off = std::max(slopes_off, std::abs(slopes.node[0] + slopes.node[1] + slopes.node[2]));
      place_off = std::max(place_off, std::abs(values.node[1] + 2 * values.node[2] + first - x));
    }
  row("sum_of_values_less_1", 0, values_off);
  row("sum_of_slopes", 0, slopes_off);
  row("sum_of_places_less_x", 0, place_off);
}

// ---- elastic bodies -------------------------------------------------------------------------------------------------------------

/// A bar at a wall, drawn by a heavy plate at its other end under gravity along x that grows slowly: in the bar, the stress is
/// the weight of the plate and of the bar beyond. nu = 0, so that it is the same over the section.
void uniform_traction(const Rows& row) {
  const Division division{.cell = 0.1};
  Model model = empty_model(3, 0.8, division, {elastic_soil(1000, 1e7, 0), elastic_soil(20000, 1e7, 0)});
  add_rectangle(model, {0, 0.2}, {2, 0.4}, 0);
  add_rectangle(model, {2, 0.2}, {0.4, 0.4}, 1);
  model.gravity = {{1, 0}, GravityProtocol::ramp, 10, {}};
  model.time.end = 10;
  const Outcome outcome = simulate(model);
  double worst = 0;
  double sum = 0;
  double exact_sum = 0;
  for (std::size_t p = 0; p < model.points.count(); ++p) {
    if (model.points.x[p] < 0.2 || model.points.x[p] > 1.8) continue;
    const double exact = 20000 * 0.4 + 1000 * (2 - model.points.x[p]);
    worst = std::max(worst, std::abs(outcome.points.xx[p] - exact) / exact);
    sum += outcome.points.xx[p];
    exact_sum += exact;
  }
  row("mean_stress_ratio", 1, sum / exact_sum);
  row("worst_point", 0, worst);
}

/// Times at which a modal velocity changes sign, linear between steps.
class ZeroCrossings {
 public:
  void see(double time, double value) {
    if (last_value_ * value < 0) times.push_back(last_time_ + (time - last_time_) * last_value_ / (last_value_ - value));
    last_time_ = time;
    last_value_ = value;
  }
  std::vector<double> times;

 private:
  double last_time_ = 0;
  double last_value_ = 0;
};

/// A bar with one end at a wall that swings in its first mode: period 4 L sqrt(rho / E) at nu = 0. The movement is so small
/// that no point leaves its cell; step and cell shrink together.
void elastic_bar(const Rows& row) {
  const double length = 1;
  const double speed = 100;
  for (const int cells : {8, 16, 32, 64}) {
    const Division division{.cell = length / cells};
    Model model = empty_model(1.25 * length, 4 * division.cell, division, {elastic_soil(1000, 1000 * speed * speed, 0)});
    add_rectangle(model, {0, division.cell}, {length, 2 * division.cell});
    model.gravity.acceleration = {0, 0};
    model.time.end = 9.5 * length / speed;
    const auto shape = [&](double x) { return std::sin(pi * x / (2 * length)); };
    for (std::size_t p = 0; p < model.points.count(); ++p) model.points.velocity[2 * p] = 1e-4 * speed * shape(model.points.x[p]);
    const auto x = model.points.x;
    ZeroCrossings zeros;
    simulate(model, [&](const Moment& moment) {
      const Points points = moment.points();
      double modal = 0;
      for (std::size_t p = 0; p < x.size(); ++p) modal += points.velocity[2 * p] * shape(x[p]);
      zeros.see(moment.time, modal);
    });
    row("period_s", 4 * length / speed, zeros.times.at(4) - zeros.times.at(0) > 0 ? (zeros.times[4] - zeros.times[0]) / 2 : 0,
        division.cell);
  }
}

/// A column between smooth walls under gravity that grows slowly: vertical stress rho g (H - y), settlement of the top
/// rho g H^2 / (2 M).
void gravity_column(const Rows& row) {
  const double height = 2;
  const Material soil = elastic_soil(2000, 1e8, 0.3);
  const double g = 9.81;
  for (const int cells : {5, 10, 20, 40}) {
    const Division division{.cell = height / cells};
    Model model = empty_model(2 * division.cell, height + 2 * division.cell, division, {soil});
    add_rectangle(model, {0, 0}, {2 * division.cell, height});
    model.boundaries.right = Wall::roller;
    model.gravity = {{0, -g}, GravityProtocol::ramp, 1, {}};
    model.time.end = 1;
    const Outcome outcome = simulate(model);
    double square = 0;
    double settled = 0;
    for (std::size_t p = 0; p < model.points.count(); ++p) {
      square += std::pow(outcome.points.yy[p] + soil.density * g * (height - model.points.y[p]), 2);
      if (model.points.y[p] > height - division.cell / 2) settled += (model.points.y[p] - outcome.points.y[p]) / 4;
    }
    row("rms_stress_error_part", 0, std::sqrt(square / static_cast<double>(model.points.count())) / (soil.density * g * height),
        division.cell);
    row("settlement_m", soil.density * g * height * height / (2 * constrained_modulus(soil)), settled, division.cell);
  }
}

// ---- bodies in motion -------------------------------------------------------------------------------------------------------------

/// Thrown and falling: the explicit step falls g t (t + dt) / 2, the exact fall with the step's own error.
void free_fall(const Rows& row) {
  for (const double fraction : {0.4, 0.2, 0.1}) {
    Model model = empty_model(8, 8, {.cell = 0.2}, {elastic_soil(2000, 1e6, 0.3)});
    add_rectangle(model, {3, 5}, {0.8, 0.6});
    for (std::size_t p = 0; p < model.points.count(); ++p) model.points.velocity[2 * p] = 1;
    model.time.end = 0.5;
    model.time.step = fraction * 0.01;
    const Outcome outcome = simulate(model);
    double fallen = 0;
    double apart = 0;
    for (std::size_t p = 0; p < model.points.count(); ++p) {
      fallen += (model.points.y[p] - outcome.points.y[p]) / static_cast<double>(model.points.count());
      apart = std::max(apart, std::abs(outcome.points.x[p] - model.points.x[p] - outcome.time));
    }
    row("fall_m", 0.5 * 9.81 * outcome.time * outcome.time, fallen, *model.time.step);
    if (fraction == 0.1) row("worst_shape_change_m", 0, apart);
  }
}

/// A free block that turns by one radian keeps its energy. Lumped nodes at its rim move with the points beside them, not with the rim,
/// which strains the rim: the loss falls with the cell.
void rigid_rotation(const Rows& row) {
  const double side = 3.2;
  for (const int cells : {8, 16, 32, 64}) {
    const Division division{.cell = side / cells};
    Model model = empty_model(2 * side, 2 * side, division, {elastic_soil(2000, 1e6, 0.3)});
    add_rectangle(model, {side / 2, side / 2}, {side, side});
    model.gravity.acceleration = {0, 0};
    const double omega = 0.5;
    for (std::size_t p = 0; p < model.points.count(); ++p) {
      model.points.velocity[2 * p] = -omega * (model.points.y[p] - side);
      model.points.velocity[2 * p + 1] = omega * (model.points.x[p] - side);
    }
    model.time.end = 1 / omega;
    const double before = kinetic_energy_of(model.points);
    const Outcome outcome = simulate(model);
    row("energy_kept", 1, kinetic_energy_of(outcome.points) / before, division.cell);
    double sum_x = 0;
    double sum_y = 0;
    for (std::size_t p = 0; p < model.points.count(); ++p) {
      sum_x += (outcome.points.x[p] - side) * (model.points.x[p] - side) + (outcome.points.y[p] - side) * (model.points.y[p] - side);
      sum_y += (outcome.points.y[p] - side) * (model.points.x[p] - side) - (outcome.points.x[p] - side) * (model.points.y[p] - side);
    }
    row("turned_rad", omega * outcome.time, std::atan2(sum_y, sum_x), division.cell);
  }
}

/// A beam of 4 x 1 m held at a wall.
Model cantilever(double cell, double youngs_modulus, double poisson_ratio = 0.3) {
  Model model = empty_model(5, 7, {.cell = cell}, {elastic_soil(1050, youngs_modulus, poisson_ratio)});
  add_rectangle(model, {0, 5}, {4, 1});
  model.boundaries.left = Wall::stick;
  model.gravity.acceleration = {0, -9.8};
  return model;
}

/// How far the lower right corner of the beam has sunk: of the point nearest to it, and half a point on along both axes.
double corner_sinks(const Model& model, const Points& now) {
  const auto rows = static_cast<std::size_t>(std::lround(1 / model.point_spacing_y));
  const std::size_t corner = now.count() - rows;
  const auto sunk = [&](std::size_t p) { return model.points.y[p] - now.y[p]; };
  return sunk(corner) + (sunk(corner) - sunk(corner + 1)) / 2 + (sunk(corner) - sunk(corner - rows)) / 2;
}

/// A stiff beam under gravity that grows slowly. Reference: an explicit finite-element solution of the same law (square
/// elements of 2 x 2 Gauss points, 8 to 64 along the beam, extrapolated); Timoshenko's beam, whose clamp leaves the section
/// free to contract, sinks 2.6 % more.
void stiff_cantilever(const Rows& row) {
  for (const double cell : {0.5, 0.25, 0.125}) {
    Model model = cantilever(cell, 1e8);
    model.gravity.protocol = GravityProtocol::ramp;
    model.gravity.ramp_time = model.time.end = 3;  // ten periods
    const Outcome outcome = simulate(model);
    row("tip_sinks_m", 0.03755, corner_sinks(model, outcome.points), cell);
  }
}

/// The same, nearly incompressible, with B-bar. Reference: a static, linear finite-element solution (square elements with one
/// volume change each, 8 to 64 across the beam).
void wet_cantilever(const Rows& row) {
  const auto rows = [&](const char* quantity, double poisson_ratio, double exact) {
    for (const double cell : {0.25, 0.125}) {
      Model model = cantilever(cell, 1e8, poisson_ratio);
      model.method.anti_locking = AntiLocking::b_bar;
      model.gravity.protocol = GravityProtocol::ramp;
      model.gravity.ramp_time = model.time.end = 3;  // ten periods
      row(quantity, exact, corner_sinks(model, simulate(model).points), cell);
    }
  };
  rows("tip_sinks_m_nu_0.49", 0.49, 0.03152);
  rows("tip_sinks_m_nu_0.499", 0.499, 0.03110);
}

/// A soft one, let go: lowest place of its lower corner and when (finite elements and CPDI: 3.25 to 3.28 m, 1.06 to 1.12 s).
void soft_cantilever(const Rows& row) {
  for (const double cell : {0.5, 0.25}) {
    Model model = cantilever(cell, 1e6);
    model.time.end = 1.2;
    double deepest = 0;
    double when = 0;
    simulate(model, [&](const Moment& moment) {
      const double sunk = corner_sinks(model, moment.points());
      if (sunk <= deepest) return;
      deepest = sunk;
      when = moment.time;
    });
    row("tip_sinks_m", 3.265, deepest, cell);
    row("after_s", 1.09, when, cell);
  }
}

// ---- the program ------------------------------------------------------------------------------------------------------------------

const std::map<std::string, void (*)(const Rows&)> cases = {
    {"shear_point", shear_point},         {"tension_point", tension_point},           {"corner_point", corner_point},
    {"softening_point", softening_point}, {"partition_of_unity", partition_of_unity}, {"uniform_traction", uniform_traction},
    {"elastic_bar", elastic_bar},         {"gravity_column", gravity_column},         {"free_fall", free_fall},
    {"rigid_rotation", rigid_rotation},   {"stiff_cantilever", stiff_cantilever},     {"soft_cantilever", soft_cantilever},
    {"wet_cantilever", wet_cantilever},
};

}  // namespace
}  // namespace slidezone

int main(int argc, char** argv) {
  using namespace slidezone;
  std::cout << std::setprecision(12) << "case\tquantity\tsize\texact\tcomputed\n";
  for (int i = 1; i < argc; ++i) {
    const auto found = cases.find(argv[i]);
    if (found == cases.end()) {
      std::cerr << "verification: no case \"" << argv[i] << "\"; there are:";
      for (const auto& [name, run] : cases) std::cerr << ' ' << name;
      std::cerr << '\n';
      return 64;
    }
    found->second(Rows(found->first));
  }
}
