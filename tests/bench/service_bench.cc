#include <array>
#include <chrono>
#include <filesystem>
#include <thread>
#include <vector>

#include "benchmark/benchmark.h"
#include "core/analysis/lyapunov.h"
#include "core/map/celtic_stone_system.h"
#include "server/jobs/scheduler.h"
#include "server/jobs/sqlite_store.h"
#include "server/plans/factory.h"
#include "server/plans/serialize.h"
#include "server/plans/spec.h"
#include "tests/bench/section_bench.h"

namespace celt::bench {
namespace {

constexpr int kOrbits = 16;
constexpr int kTransient = 100;
constexpr int kIterates = 100'000;

bool GoOn(std::int64_t) { return true; }

void Advance(const Map& map, std::vector<FramedOrbit> orbits, std::int64_t iterates) {
  benchmark::DoNotOptimize(AdvanceFrames(map, orbits, iterates, GoOn).ok());
}

/// A spectrum by the engine alone: the orbits of a job, in its groups of eight, without a stop.
void Bare(benchmark::State& state) {
  const auto map = CelticStoneSystem().MakeMap({}, {}).value();
  const auto orbits =
      DrawStarts(CelticStoneSystem().DefaultStart(), CelticStoneSystem().StartSpread(), kOrbits, 1);
  for (auto _ : state) {
    Advance(*map, {orbits.begin(), orbits.begin() + 8}, kTransient + kIterates / kOrbits);
    Advance(*map, {orbits.begin() + 8, orbits.end()}, kTransient + kIterates / kOrbits);
  }
  state.SetItemsProcessed(state.iterations() * (kIterates + kOrbits * kTransient));
}

/// The same as a job of the service, by one worker, with a store on disk.
void Job(benchmark::State& state) {
  const auto path = std::filesystem::temp_directory_path() / "celt_bench.db";
  for (const char* suffix : {"", "-wal", "-shm"}) std::filesystem::remove(path.string() + suffix);
  const auto store = *jobs::SqliteStore::Open(path);
  jobs::SchedulerOptions options;
  options.workers = 1;
  jobs::Scheduler scheduler(*store, plans::MakePlan, options);
  benchmark::DoNotOptimize(scheduler.Start().ok());
  v1::JobSpec spec;
  spec.mutable_lyapunov()->set_iterates(kIterates);
  spec.mutable_lyapunov()->set_transient(kTransient);
  for (auto _ : state) {
    const auto job = scheduler.Submit(
        {.specification = plans::Serialize(*plans::ResolveSpec(spec)), .fresh = true});
    while (!jobs::HasEnded(store->Get(job->id)->state)) {
      // Seldom: asking costs time too, and what is measured is that of the processor.
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }
  state.SetItemsProcessed(state.iterations() * (kIterates + kOrbits * kTransient));
}

/// Each thread has orbits of its own.
void Cores(benchmark::State& state) {
  const auto map = CelticStoneSystem().MakeMap({}, {}).value();
  const auto orbits =
      DrawStarts(CelticStoneSystem().DefaultStart(), CelticStoneSystem().StartSpread(), 8, 1);
  for (auto _ : state) Advance(*map, orbits, 1000);
  state.SetItemsProcessed(state.iterations() * 8 * 1000);
}

/// A corner of a chart over (energy, δ): 2,000 iterates a node, a map for each. Items are nodes.
void Chart(benchmark::State& state) {
  constexpr int kSide = 4;
  for (auto _ : state) {
    for (int node = 0; node < kSide * kSide; ++node) {
      const auto map = CelticStoneSystem().MakeMap(
          {{"energy", 752 + 0.1 * (node % kSide)}, {"delta", 0.485 + 1e-4 * (node / kSide)}}, {});
      Advance(
          **map,
          DrawStarts(CelticStoneSystem().DefaultStart(), CelticStoneSystem().StartSpread(), 8, 1),
          2000 / 8);
    }
  }
  state.SetItemsProcessed(state.iterations() * kSide * kSide);
}

}  // namespace

void RegisterServiceBenches() {
  benchmark::RegisterBenchmark("spectrum/bare", Bare)->MeasureProcessCPUTime();
  benchmark::RegisterBenchmark("spectrum/job", Job)->MeasureProcessCPUTime();
  for (const int threads : {1, 2})
    benchmark::RegisterBenchmark("cores", Cores)->Threads(threads)->UseRealTime();
  benchmark::RegisterBenchmark("chart", Chart);
}

}  // namespace celt::bench
