// How long a run of the material point method takes for each point and step: on the benchmark slope for each instruction
// set, for scenes from 10^4 to 10^6 points, and for each feature of the method. `make bench` runs it.
//
//   kernel pipelines/benchmark/scene.toml [--benchmark_filter=REGEX]
//
// Column ns_per_point_step is what counts: user time of the whole run (of threads together; Time is what one waits), and
// points_times_steps_per_s the same the other way round. The machine's clock and its other users move them by a quarter or, where another
// machine shares the core, by half; compare ratios within one run. least_ns, the fastest step's, is what comes nearest to a quiet core
// there. part_of_peak is the part of what the core could compute at most (peak.hpp, peak_Gflops), measured beside each run.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <iostream>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "bench/peak.hpp"
#include "core/error.hpp"
#include "realization/realization.hpp"

namespace slidezone {
namespace {

double user_seconds() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

/// Multiplications, additions, square roots, quotients and selections for a point in a step of the benchmark as its scene has it,
/// counted in the source, 3.3 points to a first node: places and weights 46, velocity gradient 55, stress 111, mapping of mass and
/// momentum 79, of force 69; velocities 92, second mapping of momentum 50; nodes 16. Other features get the same credit.
constexpr double operations_of_point = 520;

double peak_rate(const Model& model, InstructionSet set) {
  return model.method.precision == Precision::single_precision ? peak_rate<float>(set) : peak_rate<double>(set);
}

using Change = std::function<void(Model&)>;

/// The shortest time from one step to the next.
class FastestStep {
 public:
  void see() {
    const auto now = Clock::now();
    if (last_) least_ = std::min(least_, std::chrono::duration<double>(now - *last_).count());
    last_ = now;
  }
  double seconds() const { return least_; }

 private:
  using Clock = std::chrono::steady_clock;
  std::optional<Clock::time_point> last_;
  double least_ = std::numeric_limits<double>::infinity();
};

/// Runs the model once per iteration, up to `seconds` of simulated time.
void time_runs(benchmark::State& state, const Model& model, Kernel kernel) {
  double seconds = 0;
  double point_steps = 0;
  const double peak = peak_rate(model, kernel.set);
  FastestStep fastest;
  for (auto _ : state) {
    const double start = user_seconds();
    const Outcome outcome = simulate(
        model, [&](const auto&) { fastest.see(); }, kernel);
    const double used = user_seconds() - start;
    seconds += used;
    point_steps += static_cast<double>(outcome.steps) * static_cast<double>(model.points.count());
  }
  state.counters["points"] = static_cast<double>(model.points.count());
  state.counters["ns_per_point_step"] = 1e9 * seconds / point_steps;
  state.counters["least_ns"] = 1e9 * fastest.seconds() / static_cast<double>(model.points.count());
  state.counters["points_times_steps_per_s"] = point_steps / seconds;
  state.counters["peak_Gflops"] = 1e-9 * peak;
  state.counters["part_of_peak"] = operations_of_point * point_steps / seconds / peak;
}

void add(const std::string& name, const Model& model, Kernel kernel) {
  benchmark::RegisterBenchmark(name.c_str(), [model, kernel](benchmark::State& state) { time_runs(state, model, kernel); })
      ->UseRealTime()
      ->Iterations(1)
      ->Unit(benchmark::kSecond);
}

Model model_of(const Scene& scene) { return model_of(scene, material_points(scene), {}); }

/// The scene with cells refined `times`, for about 2e8 point steps, and 400 steps at least: what comes before the first step takes as
/// long as some steps, of which whole runs of this size have a hundred thousand.
Scene refined(Scene scene, int times) {
  GridShape& grid = scene.discretization.grid;
  grid = {grid.cell_x / times, grid.cell_y / times, grid.cells_x * times, grid.cells_y * times};
  scene.time.step = *scene.time.step / times;
  scene.time.end = *scene.time.step * std::max(400, 20000 / (times * times));
  return scene;
}

struct Feature {
  std::string name;
  Change change;
};

const std::vector<Feature> features = {
    {"as_in_the_scene", [](Model&) {}},
    {"perfectly_plastic",
     [](Model& model) {
       model.soils[0].residual_cohesion = model.soils[0].peak_cohesion;
       model.soils[0].softening_shape = 0;
     }},
    {"friction_that_softens",
     [](Model& model) {
       model.soils[0].peak_friction_angle = 0.1;
       model.soils[0].residual_friction_angle = 0.05;
     }},
    {"two_soils", [](Model& model) { model.soils.push_back(model.soils[0]); }},
    {"nonlocal_softening",
     [](Model& model) {
       model.nonlocal_softening = NonlocalSoftening{0.6, 2};
     }},
    {"single_precision", [](Model& model) { model.method.precision = Precision::single_precision; }},
    {"B_bar", [](Model& model) { model.method.anti_locking = AntiLocking::b_bar; }},
    {"USL", [](Model& model) { model.method.update_order = UpdateOrder::usl; }},
    {"USF", [](Model& model) { model.method.update_order = UpdateOrder::usf; }},
    {"linear_shape_functions", [](Model& model) { model.method.shape_functions = ShapeFunctions::linear; }},
    {"damping", [](Model& model) { model.method.damping_rate = 0.1; }},
    {"two_body_base", [](Model& model) { model.boundaries.base = BaseContact::two_body; }},
};

void add_all(const Scene& scene) {
  const Model whole = model_of(scene);
  const SoilTraits traits = soil_traits(whole);
  const std::vector<std::pair<std::string, InstructionSet>> sets = {{"baseline", InstructionSet::baseline},
                                                                    {"AVX2", InstructionSet::avx2},
                                                                    {"AVX-512_in_halves", InstructionSet::avx512_in_halves},
                                                                    {"AVX-512", InstructionSet::avx512}};
  Model single = whole;
  single.method.precision = Precision::single_precision;
  for (const auto& [name, set] : sets) {
    if (set > best_instruction_set()) continue;
    add("whole_run/" + name, whole, {set, traits});
    add("whole_run/" + name + "_single_precision", single, {set, traits});
  }
  add("whole_run/nothing_left_out", whole, Kernel{best_instruction_set(), {}});
  for (const int times : {1, 2, 4, 10}) {
    const Model model = model_of(refined(scene, times));
    add("size/" + std::to_string(model.points.count()) + "_points", model, {best_instruction_set(), traits});
  }
  for (const int threads : {1, 2}) {
    Model model = model_of(refined(scene, 4));
    model.threads = threads;
    add("threads/" + std::to_string(threads), model, {best_instruction_set(), traits});
  }
  for (const Feature& feature : features) {
    Model model = whole;
    model.time.end /= 10;
    feature.change(model);
    add("feature/" + feature.name, model, kernel_for(model));
  }
}

}  // namespace
}  // namespace slidezone

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (argc != 2) {
    std::cerr << "Example: kernel pipelines/benchmark/scene.toml --benchmark_filter=whole_run\n";
    return 64;
  }
  try {
    slidezone::add_all(slidezone::read_scene(argv[1], {.grid = true, .soil = true, .time = true}));
  } catch (const slidezone::Error& error) {
    std::cerr << "kernel: " << error.what() << "\n";
    return static_cast<int>(error.code());
  }
  benchmark::RunSpecifiedBenchmarks();
}
