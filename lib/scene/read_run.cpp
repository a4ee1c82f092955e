#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/text.hpp"
#include "scene/read_tables.hpp"

namespace slidezone {

static const Range fraction{.low = 0, .high = 1, .is_low_excluded = true};
static const Range below_vertical{.low = 0, .high = std::numbers::pi / 2, .is_high_excluded = true};
static const Range proper_fraction{.low = 0, .high = 1, .is_low_excluded = true, .is_high_excluded = true};

/// What words of the file stand for, in the order in which messages list them.
template <class Value>
using Words = std::vector<std::pair<std::string, Value>>;

static const Words<BaseContact> contacts = {{"bilateral", BaseContact::bilateral},
                                            {"unilateral", BaseContact::unilateral},
                                            {"stick", BaseContact::stick},
                                            {"two-body", BaseContact::two_body}};
static const Words<Wall> walls = {{"roller", Wall::roller}, {"stick", Wall::stick}, {"open", Wall::open}, {"symmetry", Wall::symmetry}};
static const Words<GravityProtocol> protocols = {
    {"sudden", GravityProtocol::sudden}, {"ramp", GravityProtocol::ramp}, {"k0", GravityProtocol::k0}};
static const Words<UpdateOrder> update_orders = {{"MUSL", UpdateOrder::musl}, {"USL", UpdateOrder::usl}, {"USF", UpdateOrder::usf}};
static const Words<ShapeFunctions> shape_functions = {{"GIMP", ShapeFunctions::gimp}, {"linear", ShapeFunctions::linear}};
static const Words<Precision> precisions = {{"double", Precision::double_precision}, {"single", Precision::single_precision}};
static const Words<AntiLocking> anti_lockings = {{"none", AntiLocking::none}, {"B-bar", AntiLocking::b_bar}};

/// The value that the key's word stands for; an absent key leaves `absent`.
template <class Value>
static Value choice_or(const TomlTable& table, const std::string& key, const Words<Value>& words, Value absent) {
  if (!table.has(key)) return absent;
  std::vector<std::string> names;
  for (const auto& [name, value] : words) names.push_back(name);
  const std::string chosen = table.choice(key, names);
  return std::find_if(words.begin(), words.end(), [&](const auto& word) { return word.first == chosen; })->second;
}

void read_base(const TomlTable& table, Boundaries& boundaries) {
  table.check_keys({"contact", "friction"});
  boundaries.base = choice_or(table, "contact", contacts, boundaries.base);
  if (boundaries.base != BaseContact::stick)
    boundaries.base_friction = table.number("friction", not_negative);
  else if (table.has("friction"))
    table.fail("friction", "has no place where the contact is \"stick\", which never slides");
}

void read_walls(const TomlTable& table, Boundaries& boundaries) {
  table.check_keys({"left", "right"});
  boundaries.left = choice_or(table, "left", walls, boundaries.left);
  boundaries.right = choice_or(table, "right", walls, boundaries.right);
}

Gravity read_gravity(const TomlTable& table) {
  table.check_keys({"acceleration", "tilt", "protocol", "ramp_time", "k0"});
  Gravity gravity;
  const double acceleration = table.quantity_or("acceleration", "m s-2", positive, -gravity.acceleration.y);
  const double tilt = table.quantity_or("tilt", "rad", below_vertical, 0);
  gravity.acceleration = {acceleration * std::sin(tilt), -acceleration * std::cos(tilt)};
  gravity.protocol = choice_or(table, "protocol", protocols, gravity.protocol);
  if (gravity.protocol == GravityProtocol::ramp)
    gravity.ramp_time = table.quantity_or("ramp_time", "s", positive, gravity.ramp_time);
  else if (table.has("ramp_time"))
    table.fail("ramp_time", "has a meaning only with protocol = \"ramp\"");
  if (table.has("k0") && gravity.protocol != GravityProtocol::k0) table.fail("k0", "has a meaning only with protocol = \"k0\"");
  if (table.has("k0")) gravity.k0 = table.number("k0", not_negative);
  return gravity;
}

Vec2 read_initial_velocity(const TomlTable& table) {
  table.check_keys({"velocity"});
  if (table.has("velocity") && !table.is_list("velocity"))
    table.fail("velocity", "wants its components along x and y like [\"5 m/s\", \"0 m/s\"]");
  return table.quantity_pair("velocity", "m s-1", any_number);
}

static RestRule read_rest(const TomlTable& table, double end) {
  table.check_keys({"energy_fraction", "strain_fraction", "hold"});
  RestRule rest;
  rest.energy_fraction = table.number_or("energy_fraction", proper_fraction, rest.energy_fraction);
  rest.strain_fraction = table.number_or("strain_fraction", proper_fraction, rest.strain_fraction);
  rest.hold = table.quantity_or("hold", "s", positive, rest.hold);
  if (rest.hold >= end)
    table.fail("hold", "wants less than the whole run of " + format_brief(end) + " s, found " + format_brief(rest.hold) + " s");
  return rest;
}

TimeStepping read_time(const TomlTable& table, const Gravity& gravity) {
  table.check_keys({"end", "step", "step_fraction", "rest"});
  TimeStepping time;
  time.end = table.quantity("end", "s", positive);
  if (gravity.protocol == GravityProtocol::ramp && time.end < gravity.ramp_time)
    table.fail("end", "wants at least the " + format_brief(gravity.ramp_time) + " s over which gravity grows, found " +
                          format_brief(time.end) + " s");
  if (table.has("step")) time.step = table.quantity("step", "s", positive);
  if (time.step > time.end)
    table.fail("step", "wants at most the end, " + format_brief(time.end) + " s, found " + format_brief(*time.step) + " s");
  if (time.step && table.has("step_fraction")) table.fail("step_fraction", "cannot stand beside 'step'; give either");
  time.step_fraction = table.number_or("step_fraction", fraction, time.step_fraction);
  if (table.has("rest")) time.rest = read_rest(table.table("rest"), time.end);
  return time;
}

Scheme read_method(const TomlTable& table) {
  table.check_keys({"update_order", "shape_functions", "anti_locking", "damping_rate", "precision"});
  Scheme method;
  method.update_order = choice_or(table, "update_order", update_orders, method.update_order);
  method.shape_functions = choice_or(table, "shape_functions", shape_functions, method.shape_functions);
  method.anti_locking = choice_or(table, "anti_locking", anti_lockings, method.anti_locking);
  method.damping_rate = table.quantity_or("damping_rate", "s-1", not_negative, method.damping_rate);
  method.precision = choice_or(table, "precision", precisions, method.precision);
  if (method.anti_locking == AntiLocking::b_bar && method.update_order == UpdateOrder::usf)
    table.fail("anti_locking", "\"B-bar\" averages over cells at the end of a step; take update_order = \"MUSL\" or \"USL\"");
  if (method.shape_functions == ShapeFunctions::linear && method.update_order == UpdateOrder::usl)
    table.fail("shape_functions",
               "\"linear\" leaves nodes at the rim next to no mass, and with update_order = \"USL\" no step is stable; "
               "take \"MUSL\" or \"USF\", or \"GIMP\"");
  return method;
}

NonlocalSoftening read_nonlocal_softening(const TomlTable& table, const std::vector<Layer>& layers) {
  table.check_keys({"length", "factor"});
  NonlocalSoftening softening;
  softening.length = table.quantity("length", "m", positive);
  softening.factor = table.number_or("factor", {.low = 1, .high = 10}, softening.factor);
  const auto softens = [](const Layer& layer) { return layer.material.softening_shape > 0; };
  if (!layers.empty() && std::none_of(layers.begin(), layers.end(), softens))
    table.fail("length", "has no use: no soil of the scene softens; give one a softening_shape or leave [nonlocal_softening] out");
  return softening;
}

Output read_output(const TomlTable& table) {
  table.check_keys({"influence_drop", "slid_displacement"});
  Output output;
  output.influence_drop = table.quantity_or("influence_drop", "m", positive, output.influence_drop);
  output.slid_displacement = table.quantity_or("slid_displacement", "m", positive, output.slid_displacement);
  return output;
}

Study read_study(const TomlTable& table) {
  table.check_keys({"seed", "realizations", "design", "block_size", "modes"});
  constexpr std::uint64_t largest = std::numeric_limits<std::int64_t>::max();  // what TOML can write
  Study study;
  study.seed = table.whole_or("seed", 0, largest, study.seed);
  study.realizations = table.whole_or("realizations", 1, largest, study.realizations);
  StudyDesign& design = study.design;
  if (table.has("design")) design.design = *design_named(table.choice("design", design_names()));
  for (const char* key : {"block_size", "modes"})
    if (table.has(key) && design.design != Design::latin_hypercube) table.fail(key, "has a meaning only with design = \"Latin hypercube\"");
  design.block_size = table.whole_or("block_size", 2, 10000, design.block_size);
  design.modes = table.whole_or("modes", 1, 1000, design.modes);
  return study;
}

}  // namespace slidezone
