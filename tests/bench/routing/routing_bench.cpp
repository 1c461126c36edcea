/// Measures routes on a large site, prepared, right after changes, and by others' means, all in one run.
/// build/release/bench/routing_bench [PLACES, a million otherwise]
#include <benchmark/benchmark.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <iostream>

#include "core/network/routing/routing.hpp"
#include "tests/bench/routing/baseline.hpp"
#include "tests/bench/times.hpp"
#include "tests/support/network_maker.hpp"
#include "tests/support/site_network.hpp"

namespace weft::routing {
namespace {

using bench::Clock;
using bench::milliseconds;
using bench::Times;
const std::set<std::string> kMethods{"floor"};
constexpr int kChanges = 100;

struct Site {
  Snapshot snapshot;
  Preparation preparation;
  support::TruePoses truth;
  Snapshot changed;
  Preparation after_changes;
};

/// Makes the batch of a robot that drives behind an earlier run and stitches every second place to it.
Batch follow(Random& random, const Snapshot& snapshot, std::uint64_t number) {
  const support::BatchPlan plan{{number}, support::random_id<RobotId>(random), 1, 20, 0, "floor"};
  Batch batch = support::make_batch(random, snapshot, plan);
  const PlaceId first = support::pick_place(random, snapshot);
  for (std::uint32_t i = 0; i < plan.places; i += 2) {
    const PlaceId older{first.experience, first.index + i};
    if (snapshot.place(older) == nullptr) break;
    batch.edges.push_back(support::make_stitch(random, older, {plan.experience, i}, "floor"));
  }
  return batch;
}

void preparing(benchmark::State& state, Site& site) {
  for (auto _ : state) {
    Builder builder = Builder::to_prepare(site.snapshot, kMethods);
    double longest = 0.0;
    for (bool more = true; more;) {
      const auto begin = Clock::now();
      more = builder.step(2'000);
      longest = std::max(longest, milliseconds(Clock::now() - begin));
    }
    site.preparation = builder.take();
    state.counters["longest_step_ms"] = longest;
    state.counters["MB"] = static_cast<double>(size_bytes(site.preparation)) / 1e6;
    for (std::size_t level = 0; level < kLevels; ++level) {
      state.counters["cells_" + std::to_string(level)] = static_cast<double>(site.preparation.overlays[level].size());
    }
    for (std::size_t level = 0; level < kLevels; ++level) {
      std::size_t entries = 0;
      std::size_t costs = 0;
      for (const auto& overlay : site.preparation.overlays[level]) {
        entries += overlay->entries.size();
        costs += overlay->costs.size();
      }
      state.counters["entries_" + std::to_string(level)] = static_cast<double>(entries);
      state.counters["costs_" + std::to_string(level)] = static_cast<double>(costs);
    }
  }
}

void storing(benchmark::State& state, Site& site) {
  for (auto _ : state) {
    const Bytes bytes = encode(site.preparation);
    const auto begin = Clock::now();
    const Result<Preparation> again = decode(bytes, site.snapshot);
    if (!again) state.SkipWithError(again.error().message.c_str());
    state.counters["decode_ms"] = milliseconds(Clock::now() - begin);
    state.counters["MB"] = static_cast<double>(bytes.size()) / 1e6;
  }
}

void updating(benchmark::State& state, Site& site) {
  Random random(3);
  site.changed = site.snapshot;
  site.after_changes = site.preparation;
  std::uint64_t number = 1;
  Times times;
  for (auto _ : state) {
    site.changed = with(site.changed, follow(random, site.changed, number++));
    times.measure([&] { site.after_changes = update(site.after_changes, site.changed); });
  }
  times.report(state);
}

void routes(benchmark::State& state, const Preparation& preparation, const Snapshot& snapshot) {
  Random random(17);
  Times times;
  double places = 0.0;
  for (auto _ : state) {
    const PlaceId from = support::pick_place(random, snapshot);
    const PlaceId to = support::pick_place(random, snapshot);
    times.measure([&] {
      const Result<Path> path = shortest_path(preparation, snapshot, from, to, kMethods);
      if (path) places += static_cast<double>(path->places.size());
    });
  }
  times.report(state);
  state.counters["places"] = places / static_cast<double>(state.iterations());
}

void boost_astar(benchmark::State& state, const Site& site) {
  const BoostAstar astar(site.preparation, site.truth);
  Random random(17);
  Times times;
  for (auto _ : state) {
    const PlaceId from = support::pick_place(random, site.snapshot);
    const PlaceId to = support::pick_place(random, site.snapshot);
    double theirs = 0.0;
    times.measure([&] { theirs = astar.cost(from, to); });
    const Result<Path> ours = shortest_path(site.preparation, site.snapshot, from, to, kMethods);
    double cost = ours ? 0.0 : std::numeric_limits<double>::infinity();
    if (ours) {
      for (const Relation& relation : ours->relations) cost += norm(relation);
    }
    if (std::abs(cost - theirs) > 1e-6) state.SkipWithError("the costs differ");
  }
  times.report(state);
}

void plain_dijkstra(benchmark::State& state, const Site& site) {
  Random random(17);
  Times times;
  for (auto _ : state) {
    const PlaceId from = support::pick_place(random, site.snapshot);
    const PlaceId to = support::pick_place(random, site.snapshot);
    times.measure([&] { benchmark::DoNotOptimize(weft::shortest_path(site.snapshot, from, to, kMethods)); });
  }
  times.report(state);
}

int run(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  SitePlan plan{.places = 1'000'000};
  if (argc > 1) std::from_chars(argv[1], argv[1] + std::strlen(argv[1]), plan.places);
  if (const Result<void> good = check(plan); !good) {
    std::cerr << "routing_bench: " << good.error().message << '\n';
    return 2;
  }
  Site site;
  site.snapshot = support::make_site(plan, &site.truth);
  const auto once = [](auto* bench) { bench->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1); };
  once(benchmark::RegisterBenchmark("prepare", [&](benchmark::State& state) { preparing(state, site); }));
  once(benchmark::RegisterBenchmark("decode", [&](benchmark::State& state) { storing(state, site); }));
  benchmark::RegisterBenchmark("update_20_places", [&](benchmark::State& state) {
    updating(state, site);
  })->Iterations(kChanges);
  benchmark::RegisterBenchmark("routes", [&](benchmark::State& state) {
    routes(state, site.preparation, site.snapshot);
  })->Iterations(500);
  benchmark::RegisterBenchmark("routes_after_changes", [&](benchmark::State& state) {
    routes(state, site.after_changes, site.changed);
  })->Iterations(500);
  benchmark::RegisterBenchmark("routes_boost_astar", [&](benchmark::State& state) {
    boost_astar(state, site);
  })->Iterations(20);
  benchmark::RegisterBenchmark("routes_plain_dijkstra", [&](benchmark::State& state) {
    plain_dijkstra(state, site);
  })->Iterations(5);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

}  // namespace
}  // namespace weft::routing

int main(int argc, char** argv) {
  return weft::routing::run(argc, argv);
}
