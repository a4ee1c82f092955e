// Compiled three times, with SLIDEZONE_SWEEPS naming the function for each instruction set; see CMakeLists.txt.
#include "mpm/sweeps.hpp"

#include "mpm/block_stress.hpp"
#include "mpm/block_transfer.hpp"
#include "mpm/block_weights.hpp"

namespace slidezone {
namespace {

enum class Map { yes, no };

template <class Act>
[[gnu::always_inline]] inline void for_each_block(const SweepData& data, Act act) {
  for (std::size_t first = 0; first < data.point_count; first += block_size) {
    const std::size_t left = data.point_count - first;
    act(Block{first, left < block_size ? static_cast<int>(left) : block_size});
  }
}

NodeBox joined(const NodeBox& a, const NodeBox& b) {
  return {a.first_column < b.first_column ? a.first_column : b.first_column, a.last_column > b.last_column ? a.last_column : b.last_column,
          a.first_row < b.first_row ? a.first_row : b.first_row, a.last_row > b.last_row ? a.last_row : b.last_row};
}

template <SoilTraits traits, Map map>
SweepReport sweep_a(const SweepData& data) {
  SweepReport report;
  report.box = {data.storage.columns, 0, data.storage.rows, 0};
  for_each_block(data, [&](Block block) {
    BlockWeights weights;
    BlockGradients gradients;
    weigh(data, block, weights);
    gather_gradients(data, block, weights, gradients);
    const StressUpdate stress = update_stress<traits>(data, block, gradients);
    move(data, block);
    const Reached reached = weigh(data, block, weights);
    if constexpr (map == Map::yes) map_to_nodes(data, block, weights);
    report.box = joined(report.box, reached.box);
    report.internal_work += stress.internal_work;
    report.is_broken |= reached.is_lost || stress.is_broken;
  });
  return report;
}

void sweep_b(const SweepData& data) {
  for_each_block(data, [&](Block block) {
    BlockWeights weights;
    weigh(data, block, weights);
    gather_and_map_block(data, block, weights);
  });
}

template <SoilTraits traits>
Sweeps sweeps_for() {
  return {sweep_a<traits, Map::yes>, sweep_a<traits, Map::no>, sweep_b};
}

template <bool has_cone, bool has_softening>
Sweeps sweeps_for(bool has_layers) {
  return has_layers ? sweeps_for<SoilTraits{has_cone, has_softening, true}>() : sweeps_for<SoilTraits{has_cone, has_softening, false}>();
}

}  // namespace

Sweeps SLIDEZONE_SWEEPS(SoilTraits traits);

Sweeps SLIDEZONE_SWEEPS(SoilTraits traits) {
  if (traits.has_cone) return traits.has_softening ? sweeps_for<true, true>(traits.has_layers) : sweeps_for<true, false>(traits.has_layers);
  return traits.has_softening ? sweeps_for<false, true>(traits.has_layers) : sweeps_for<false, false>(traits.has_layers);
}

}  // namespace slidezone
