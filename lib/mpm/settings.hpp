// How a run is made: gravity, boundaries, time. Defaults are those of a scene that does not say otherwise.
#pragma once

#include <optional>

#include "core/vec2.hpp"

namespace slidezone {

/// What the base does to the nodes on it.
enum class BaseContact {
  bilateral,   // no normal motion, either way; Coulomb friction against sliding
  unilateral,  // no motion into the base, free to lift off; Coulomb friction while pressed
  stick,       // no motion at all
  two_body,    // Coulomb contact of two bodies, soil and a rigid base, with normals from their mass gradients (contact.hpp)
};

/// What a wall does to the nodes on it.
enum class Wall {
  roller,    // no motion through it, either way; the ground goes on behind it, so that a slide that reaches it is cut short
  stick,     // no motion at all; likewise
  open,      // material that reaches it leaves the domain and censors the run
  symmetry,  // a roller that stands for the mirror image of the soil, or for a smooth wall that the soil leans on: nothing is cut short
};

struct Boundaries {
  BaseContact base = BaseContact::bilateral;
  double base_friction = 0;  // coefficient, tan of the friction angle
  Wall left = Wall::roller;
  Wall right = Wall::open;

  /// Whether soil can rub on the base.
  bool has_friction() const { return base != BaseContact::stick && base_friction > 0; }
};

enum class GravityProtocol {
  sudden,  // full from the start, from a stress-free state
  ramp,    // grows linearly over ramp_time, from a stress-free state
  k0,      // full from the start, from geostatic stress: vertical by overburden, horizontal k0 times that
};

struct Gravity {
  Vec2 acceleration = {0, -9.81};  // m/s^2
  GravityProtocol protocol = GravityProtocol::ramp;
  double ramp_time = 2;      // s
  std::optional<double> k0;  // absent: nu / (1 - nu) of each soil
};

/// The run ends early once two things have stayed below a fraction of their peaks for `hold`: the kinetic energy on the grid, and
/// the growth of plastic strain, for a late block begins as a shear band that creeps while hardly anything moves.
struct RestRule {
  double energy_fraction = 0.01;
  double strain_fraction = 0.001;
  double hold = 1;  // s
};

struct TimeStepping {
  double end = 0;              // s
  std::optional<double> step;  // s; absent: step_fraction times the stability limit
  double step_fraction = 0.5;
  std::optional<RestRule> rest;  // absent: runs to the end
};

/// When in a step the stress follows the strain.
enum class UpdateOrder {
  musl,  // last, with velocities of the moved points mapped once more to the nodes (modified update stress last)
  usl,   // last, with the node velocities that moved the points
  usf,   // first, with node velocities before the forces act
};

enum class ShapeFunctions { gimp, linear };

/// How volume changes of nearly incompressible soil are kept from locking.
enum class AntiLocking {
  none,
  b_bar,  // one volume change and one mean stress for all points of a cell (block_dilation.hpp)
};

/// The numbers that points and nodes are computed with. Positions and sums over the run are doubles in either.
enum class Precision { double_precision, single_precision };

struct Scheme {
  UpdateOrder update_order = UpdateOrder::musl;
  ShapeFunctions shape_functions = ShapeFunctions::gimp;
  AntiLocking anti_locking = AntiLocking::none;
  double damping_rate = 0;  // 1/s: how fast point velocities tend to those of the grid; free of the step's length
  Precision precision = Precision::double_precision;
};

/// Softening by a strain averaged over neighbours (nonlocal_softening.hpp); without it softening is local and its results
/// depend on the size of the cells.
struct NonlocalSoftening {
  double length = 0;  // m, a parameter of the material
  double factor = 2;  // m of the over-nonlocal average; 1 is the plain average
};

}  // namespace slidezone
