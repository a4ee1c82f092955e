#include "realization/explanation.hpp"

#include <cmath>

#include "core/text.hpp"
#include "io/table.hpp"
#include "mpm/strips.hpp"

namespace slidezone {

static std::string name_of(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx512:
      return "AVX-512";
    case InstructionSet::avx512_in_halves:
      return "AVX-512 in halves";
    case InstructionSet::avx2:
      return "AVX2";
    case InstructionSet::baseline:
      break;
  }
  return "baseline x86-64";
}

static std::string name_of(UpdateOrder order) {
  switch (order) {
    case UpdateOrder::musl:
      return "MUSL";
    case UpdateOrder::usl:
      return "USL";
    case UpdateOrder::usf:
      break;
  }
  return "USF";
}

static std::string name_of(BaseContact contact) {
  switch (contact) {
    case BaseContact::bilateral:
      return "bilateral";
    case BaseContact::unilateral:
      return "unilateral";
    case BaseContact::stick:
      return "stick";
    case BaseContact::two_body:
      break;
  }
  return "two-body";
}

std::string explanation(const Model& model, bool has_sample, const Provenance& provenance) {
  const Kernel kernel = kernel_for(model);
  const bool is_two_body = model.boundaries.base == BaseContact::two_body;
  const double step = time_step(model);
  const double steps = std::ceil(model.time.end / step - 1e-9);
  Table table({"part", "use", "because"});
  const auto part = [&](const std::string& name, const std::string& use, const std::string& because) {
    table.add_row({name, use, because});
  };
  const auto feature = [&](const std::string& name, bool is_used, const std::string& with, const std::string& without) {
    part(name, is_used ? "yes" : "no", is_used ? with : without);
  };

  part("material points", std::to_string(model.points.count()), "of the initial lattice inside the slope");
  part("grid", std::to_string(model.grid.cells_x) + " x " + std::to_string(model.grid.cells_y),
       "of which each step visits the columns that points reach, up to some nodes above");
  part("time step", format_brief(step, 6) + " s", format_brief(step / step_limit(model), 3) + " of the stability limit");
  part("steps", format_brief(steps, 15),
       std::string("at most; ") + (model.time.rest ? "the rest rule may end the run before" : "there is no rest rule"));
  part("threads", model.points.count() < Strips::least_points ? "1" : std::to_string(model.threads),
       model.points.count() < Strips::least_points ? "fewer than " + std::to_string(Strips::least_points) + " points" : "as asked for");
  part("instruction set", name_of(kernel.set), "the best that this processor has");
  const bool is_single = model.method.precision == Precision::single_precision;
  part("precision", is_single ? "single" : "double",
       is_single ? "floats, but for positions and sums over the run" : "floats would save some of the time; see README");
  part("update order", name_of(model.method.update_order),
       model.method.update_order == UpdateOrder::musl ? "momentum is mapped twice a step" : "without MUSL's second map");
  feature("GIMP domains", model.method.shape_functions == ShapeFunctions::gimp, "shape functions reach three nodes an axis",
          "linear shape functions");
  feature("friction, dilation, tension cut-off", kernel.traits.has_cone, "some soil has one",
          "no soil has any: shear stress against cohesion alone");
  feature("softening", kernel.traits.has_softening, "some soil loses strength as it yields", "every soil is perfectly plastic");
  feature("nonlocal softening", model.nonlocal_softening.has_value(), "the scene gives its length",
          "softening follows each point's own strain");
  feature("soil looked up for each point", kernel.traits.has_layers,
          model.point_soils.empty() ? "there are several soils" : "parameters beside the cohesion vary from point to point",
          "one soil: its constants stay in registers");
  feature("strength of each point", has_sample, "from the field sample", "each soil has one strength");
  feature("B-bar", model.method.anti_locking == AntiLocking::b_bar, "the scene asks for it", "the scene does not ask for it");
  feature("damping", model.method.damping_rate > 0, "the scene gives its rate", "the scene gives no rate");
  part("base contact", name_of(model.boundaries.base),
       is_two_body ? "normals from mass gradients at the base" : "on the nodes of the base alone, without normals");
  feature("friction on the base", model.boundaries.has_friction(), "Coulomb",
          model.boundaries.base == BaseContact::stick ? "nothing slides on a stick base" : "its coefficient is 0");
  return to_tsv(table, provenance);
}

}  // namespace slidezone
