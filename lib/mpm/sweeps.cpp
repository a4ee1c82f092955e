// Compiled for each instruction set and precision, with SLIDEZONE_SWEEPS naming the function and SLIDEZONE_REAL its numbers; see
// CMakeLists.txt.
#include "mpm/sweeps.hpp"

#include "mpm/block_dilation.hpp"
#include "mpm/block_gather.hpp"
#include "mpm/block_map.hpp"
#include "mpm/block_stress.hpp"
#include "mpm/block_weights.hpp"

namespace slidezone {
namespace {

template <class Real, class Act>
[[gnu::always_inline]] inline void for_each_block(const SweepData<Real>& data, Act act) {
  std::size_t first = 0;
  for (; first + block_size <= data.point_count; first += block_size) act(FullBlock{first});
  if (first < data.point_count) act(LastBlock{first, static_cast<int>(data.point_count - first)});
}

NodeBox joined(const NodeBox& a, const NodeBox& b) {
  return {a.first_column < b.first_column ? a.first_column : b.first_column, a.last_column > b.last_column ? a.last_column : b.last_column,
          a.first_row < b.first_row ? a.first_row : b.first_row, a.last_row > b.last_row ? a.last_row : b.last_row};
}

template <class Real>
SweepReport empty_report(const SweepData<Real>& data) {
  SweepReport report;
  report.box = {data.storage.columns, 0, data.storage.rows, 0};
  return report;
}

void join(SweepReport& report, const Reached& reached) {
  report.box = joined(report.box, reached.box);
  report.out_of_order += reached.out_of_order;
  report.is_broken |= reached.is_lost;
}

void join(SweepReport& report, const StressUpdate& update) {
  report.internal_work += update.internal_work;
  report.is_broken |= update.is_broken;
}

// ---- MUSL and USL -------------------------------------------------------------------------------------------------------

enum class Map { yes, no };

template <SoilTraits traits, Map map, class Real>
SweepReport update_and_map(const SweepData<Real>& data) {
  SweepReport report = empty_report(data);
  for_each_block(data, [&](auto block) {
    BlockWeights<Real> weights;
    BlockGradients<Real> gradients;
    weigh(data, block, weights);
    gather_gradients(data, block, weights, gradients);
    join(report, update_stress<traits>(data, block, gradients));
    move(data, block);
    join(report, place(data, block));
    if constexpr (map == Map::yes) {
      weigh(data, block, weights);
      map_all(data, block, weights, stress_of(data, block));
    }
  });
  return report;
}

template <class Real>
void gather_dilation(const SweepData<Real>& data) {
  for_each_block(data, [&](auto block) {
    BlockWeights<Real> weights;
    BlockGradients<Real> gradients;
    weigh(data, block, weights);
    gather_gradients(data, block, weights, gradients);
    sum_dilation(data, block, weights, gradients);
  });
}

template <SoilTraits traits, class Real>
SweepReport update_with_mean_dilation(const SweepData<Real>& data) {
  SweepReport report = empty_report(data);
  for_each_block(data, [&](auto block) {
    BlockGradients<Real> gradients;
    mean_gradients(data, block, gradients);
    join(report, update_stress<traits>(data, block, gradients));
    move(data, block);
    join(report, place(data, block));
    BlockWeights<Real> weights;
    weigh(data, block, weights);
    sum_pressure(data, block, weights);
  });
  return report;
}

template <class Real>
void map_with_mean_stress(const SweepData<Real>& data) {
  for_each_block(data, [&](auto block) {
    BlockWeights<Real> weights;
    MeanStress<Real> mean;
    weigh(data, block, weights);
    mean_stress(data, block, mean);
    map_all(data, block, weights, BlockStress<Real>{mean.xx, mean.yy, data.xy + block.first});
  });
}

// ---- USF ----------------------------------------------------------------------------------------------------------------

template <class Real>
SweepReport move_and_map_momentum(const SweepData<Real>& data) {
  SweepReport report = empty_report(data);
  for_each_block(data, [&](auto block) {
    BlockWeights<Real> weights;
    move(data, block);
    join(report, place(data, block));
    weigh(data, block, weights);
    map_mass_and_momentum(data, block, weights);
  });
  return report;
}

template <SoilTraits traits, class Real>
SweepReport update_and_map_force(const SweepData<Real>& data) {
  SweepReport report = empty_report(data);
  for_each_block(data, [&](auto block) {
    BlockWeights<Real> weights;
    BlockGradients<Real> gradients;
    join(report, place(data, block));
    weigh(data, block, weights);
    gather_gradients(data, block, weights, gradients);
    join(report, update_stress<traits>(data, block, gradients));
    map_force(data, block, weights, stress_of(data, block));
  });
  return report;
}

// ---- sweep B ------------------------------------------------------------------------------------------------------------

template <SecondMap second_map, Damping damping, class Real>
double gather(const SweepData<Real>& data) {
  double damped = 0;
  for_each_block(data, [&](auto block) {
    BlockWeights<Real> weights;
    weigh(data, block, weights);
    damped += follow_nodes<second_map, damping>(data, block, weights);
  });
  return damped;
}

template <SecondMap second_map, class Real>
double gather(const SweepData<Real>& data) {
  return data.grid_part > 0 ? gather<second_map, Damping::yes>(data) : gather<second_map, Damping::no>(data);
}

// ---- before the first step, and when points were sorted -------------------------------------------------------------------

template <class Real>
SweepReport place_all(const SweepData<Real>& data) {
  SweepReport report = empty_report(data);
  for_each_block(data, [&](auto block) { join(report, place(data, block)); });
  return report;
}

template <SoilTraits traits, class Real>
Sweeps<Real> sweeps_for() {
  return {.place = place_all<Real>,
          .update_and_map = update_and_map<traits, Map::yes, Real>,
          .update = update_and_map<traits, Map::no, Real>,
          .gather_dilation = gather_dilation<Real>,
          .update_with_mean_dilation = update_with_mean_dilation<traits, Real>,
          .map_with_mean_stress = map_with_mean_stress<Real>,
          .move_and_map_momentum = move_and_map_momentum<Real>,
          .update_and_map_force = update_and_map_force<traits, Real>,
          .gather_and_map = gather<SecondMap::yes, Real>,
          .gather = gather<SecondMap::no, Real>};
}

template <class Real, bool has_cone, bool has_softening>
Sweeps<Real> sweeps_for(bool has_layers) {
  return has_layers ? sweeps_for<SoilTraits{has_cone, has_softening, true}, Real>()
                    : sweeps_for<SoilTraits{has_cone, has_softening, false}, Real>();
}

template <class Real>
Sweeps<Real> sweeps_for(SoilTraits traits) {
  if (traits.has_cone)
    return traits.has_softening ? sweeps_for<Real, true, true>(traits.has_layers) : sweeps_for<Real, true, false>(traits.has_layers);
  return traits.has_softening ? sweeps_for<Real, false, true>(traits.has_layers) : sweeps_for<Real, false, false>(traits.has_layers);
}

}  // namespace

Sweeps<SLIDEZONE_REAL> SLIDEZONE_SWEEPS(SoilTraits traits);

Sweeps<SLIDEZONE_REAL> SLIDEZONE_SWEEPS(SoilTraits traits) { return sweeps_for<SLIDEZONE_REAL>(traits); }

}  // namespace slidezone
