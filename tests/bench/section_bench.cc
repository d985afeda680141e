#include "tests/bench/section_bench.h"

#include <map>

#include "absl/strings/str_cat.h"
#include "benchmark/benchmark.h"

namespace celt::bench {
namespace {

/// Enough for a few milliseconds, and for lanes to be full most of the time.
constexpr int kIterates = 20;

void Iterate(benchmark::State& state, const Tool& tool, Derivative derivative, int orbits) {
  const auto map = MakeMap(tool);
  const auto starts = Starts(orbits);
  for (auto _ : state) {
    map->AdvanceAll(starts, {.iterates = kIterates, .derivative = derivative},
                    [](int, const Image& image) {
                      benchmark::DoNotOptimize(image.point);
                      return true;
                    });
  }
  state.SetItemsProcessed(state.iterations() * orbits * kIterates);
  const Errors& errors = ErrorsOfTool(tool);
  const bool alone = derivative == Derivative::kNone;
  state.counters["map_error"] = alone ? errors.alone : errors.map;
  if (!alone) state.counters["jacobian_error"] = errors.jacobian;
}

void Register(const Tool& tool, Derivative derivative, int orbits) {
  benchmark::RegisterBenchmark(SectionBenchName(tool, derivative, orbits).c_str(), Iterate, tool,
                               derivative, orbits);
}

}  // namespace

std::string SectionBenchName(const Tool& tool, Derivative derivative, int orbits) {
  return absl::StrCat(tool.name, "/", tool.tolerance,
                      derivative == Derivative::kNone ? "/map/" : "/jacobian/", orbits);
}

const Errors& ErrorsOfTool(const Tool& tool) {
  static std::map<std::pair<std::string, double>, Errors> known;
  const auto [entry, is_new] = known.try_emplace({tool.name, tool.tolerance});
  if (is_new) entry->second = ErrorsOf(*MakeMap(tool));
  return entry->second;
}

void RegisterSectionBenches() {
  for (const Tool& tool : Tools()) {
    const bool lanes = tool.name == "fast";
    for (const Derivative derivative : {Derivative::kNone, Derivative::kJacobian}) {
      for (const int orbits : {1, 8, 64, 4096}) {
        if (orbits == 1 || lanes) Register(tool, derivative, orbits);
      }
    }
  }
}

}  // namespace celt::bench
