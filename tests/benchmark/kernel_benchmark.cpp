// CPU time of each kernel by number of spheres, and per sphere: random packings, solid fraction .5, size ratio 1.5.
#include "pfv/flow/fluid_forces.hpp"
#include "pfv/flow/steady_flow.hpp"
#include "pfv/pores/triangulate.hpp"
#include "pfv/problem/generate.hpp"

#include <benchmark/benchmark.h>
#include <map>

using namespace pfv;

namespace {

/// What a kernel works on, made once for each size.
struct Made {
  explicit Made(int spheres)
      : packing(random_packing({.spheres = spheres, .solid_fraction = .5, .radius_ratio = 1.5, .seed = 1})),
        network(build_pore_network(packing, {}, clock)),
        throats(conductances(network, HydraulicRadius{}, MirrorWalls{}, 1)),
        system(assemble(network, throats, flow_along(Axis::z))) {}

  Clock clock;
  Packing packing;
  PoreNetwork network;
  Conductances throats;
  FlowSystem system;
};

Made& made(const benchmark::State& state) {
  static std::map<std::int64_t, Made> all;
  return all.try_emplace(state.range(0), static_cast<int>(state.range(0))).first->second;
}

void per_sphere(benchmark::State& state) {
  state.counters["per_sphere"] = benchmark::Counter(
      static_cast<double>(state.range(0)), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void triangulation(benchmark::State& state) {
  const Made& of = made(state);
  Clock clock;
  for (auto _ : state)
    benchmark::DoNotOptimize(triangulate(of.packing, {}, clock));
  per_sphere(state);
}

void geometry(benchmark::State& state) {
  Made& of = made(state);
  for (auto _ : state)
    follow(of.network, of.packing, of.clock);
  per_sphere(state);
}

void conductance(benchmark::State& state) {
  Made& of = made(state);
  for (auto _ : state)
    update(of.throats, of.network, HydraulicRadius{}, MirrorWalls{}, 1);
  per_sphere(state);
}

void assembly(benchmark::State& state) {
  const Made& of = made(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(assemble(of.network, of.throats, flow_along(Axis::z)));
  per_sphere(state);
}

void refreshing(benchmark::State& state) {
  Made& of = made(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(refresh(of.system, of.network, of.throats));
  per_sphere(state);
}

void factorisation(benchmark::State& state, const SolverChoice& choice) {
  const Made& of = made(state);
  const auto solver = make_solver(choice);
  solver->analyse(of.system.matrix);
  for (auto _ : state)
    solver->factor(of.system.matrix);
  per_sphere(state);
}

void solution(benchmark::State& state, const SolverChoice& choice) {
  const Made& of = made(state);
  const auto solver = make_solver(choice);
  solver->analyse(of.system.matrix);
  solver->factor(of.system.matrix);
  for (auto _ : state) {
    Eigen::VectorXd pressure = Eigen::VectorXd::Zero(of.system.right_side.size());
    solver->solve(of.system.right_side, pressure);
    benchmark::DoNotOptimize(pressure.data());
  }
  state.counters["iterations_of_solver"] = solver->report().iterations;
  per_sphere(state);
}

void small_and_large(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(200)->Arg(2'000)->Arg(20'000)->Arg(200'000)->Unit(benchmark::kMillisecond);
}
void small(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(200)->Arg(2'000)->Arg(20'000)->Unit(benchmark::kMillisecond);
}

BENCHMARK(triangulation)->Apply(small_and_large);
BENCHMARK(geometry)->Apply(small_and_large);
BENCHMARK(conductance)->Apply(small_and_large);
BENCHMARK(assembly)->Apply(small_and_large);
BENCHMARK(refreshing)->Apply(small_and_large);
BENCHMARK_CAPTURE(factorisation, cholmod, Cholmod{})->Apply(small);
BENCHMARK_CAPTURE(factorisation, amg, Amg{})->Apply(small_and_large);
BENCHMARK_CAPTURE(factorisation, multigrid, Multigrid{})->Apply(small_and_large);
BENCHMARK_CAPTURE(solution, gauss_seidel, GaussSeidel{})->Apply(small);
BENCHMARK_CAPTURE(solution, cholmod, Cholmod{})->Apply(small);
BENCHMARK_CAPTURE(solution, amg, Amg{})->Apply(small_and_large);
BENCHMARK_CAPTURE(solution, multigrid, Multigrid{})->Apply(small_and_large);

} // namespace

BENCHMARK_MAIN();
