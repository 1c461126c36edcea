/// Measures the server on a large site: its start, its windows while robots teach, each beside what would do least.
/// build/release/bench/scale_bench STORE, a directory that `weft-evaluate generate-site` made; it is copied.
#include <benchmark/benchmark.h>

#include <array>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>

#include "server/service.hpp"
#include "server/traffic/layout.hpp"
#include "storage/sqlite/sqlite_store.hpp"
#include "tests/bench/scale/load.hpp"
#include "tests/bench/scale/plain.hpp"
#include "tests/storage/temporary_directory.hpp"
#include "tests/support/network_maker.hpp"

namespace weft::bench {
namespace {

double resident_mb() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1e3;
  }
  return 0.0;
}

struct Running {
  std::unique_ptr<storage::MapStore> store;
  std::unique_ptr<server::Service> service;
  double clock_s = 1000.0;
};

void starting(benchmark::State& state, const std::filesystem::path& directory, Running& running) {
  for (auto _ : state) {
    auto store = storage::open_sqlite(directory, {.empties_log_aside = true});
    if (!store) return state.SkipWithError(store.error().message.c_str());
    running.store = *std::move(store);
    server::ServiceConfig config;
    config.self.bytes[0] = 1;
    config.incarnation = 1;
    const server::Now now{.steady = SteadyTime(from_seconds(running.clock_s)), .wall = {}};
    auto service = server::start(config, *running.store, Random(1), now);
    if (!service) return state.SkipWithError(service.error().message.c_str());
    running.service = *std::move(service);
    if (running.service->tick(now).empty()) return state.SkipWithError("no hello");
  }
  state.counters["places"] = static_cast<double>(running.service->snapshot().place_count());
  state.counters["stitches"] = static_cast<double>(running.service->snapshot().stitch_count());
  state.counters["resident_mb"] = resident_mb();
}

void reading_rows(benchmark::State& state, const std::filesystem::path& directory) {
  for (auto _ : state) state.counters["row_MB"] = static_cast<double>(read_rows(directory)) / 1e6;
}

void plain_search(benchmark::State& state, const Running& running) {
  const Snapshot snapshot = running.service->snapshot();
  PlainGraph graph(snapshot);
  Random random(7);
  Times times;
  double places = 0.0;
  for (auto _ : state) {
    const PlaceId centre = support::pick_place(random, snapshot);
    times.measure([&] { places += static_cast<double>(graph.around(centre, 25, 2000).size()); });
  }
  times.report(state);
  state.counters["places"] = places / static_cast<double>(state.iterations());
}

/// Measures laying out all places, in the pieces that the server makes it in; and how near two places are.
void laying_out(benchmark::State& state, const Running& running) {
  const auto snapshot = std::make_shared<const Snapshot>(running.service->snapshot());
  const double before_mb = resident_mb();
  server::Layout layout;
  Times pieces;
  for (auto _ : state) {
    layout.lay(snapshot);
    while (layout.has_work()) pieces.measure([&] { layout.work(250); });
  }
  pieces.report(state, "piece_");
  state.counters["bytes_a_place"] = 1e6 * (resident_mb() - before_mb) / static_cast<double>(layout.laid());
  Random random(7);
  std::vector<server::Spot> spots;
  for (int i = 0; i < 1000; ++i) spots.push_back(*layout.spot(support::pick_place(random, *snapshot)));
  Times pairs;
  for (std::size_t i = 0; i + 1 < spots.size(); ++i) {
    const bool is_one_part = spots[i].part == spots[i + 1].part;
    if (is_one_part) pairs.measure([&] { benchmark::DoNotOptimize(layout.clearance_m(spots[i], spots[i + 1])); });
  }
  pairs.report(state, "pair_");
}

void windows(benchmark::State& state, const Running& running, bool with_digest) {
  const Snapshot snapshot = running.service->snapshot();
  Random random(7);
  Times times;
  double places = 0.0;
  for (auto _ : state) {
    WindowDefinition definition;
    definition.centre = support::pick_place(random, snapshot);
    times.measure([&] {
      const Window window = make_window(snapshot, definition);
      if (with_digest) benchmark::DoNotOptimize(digest(window));
      places += static_cast<double>(window.places.size());
    });
  }
  times.report(state);
  state.counters["places"] = places / static_cast<double>(state.iterations());
}

void under_load(benchmark::State& state, Running& running, double seconds) {
  Load load(*running.service, running.clock_s, {});
  for (auto _ : state) load.run(seconds);
  load.waits.report(state, "wait_");
  load.windows.report(state, "window_");
  load.batches.report(state, "batch_");
  load.ticks.report(state, "tick_");
  state.counters["batches"] = static_cast<double>(load.batches_joined);
  state.counters["resident_mb"] = resident_mb();
}

/// Measures how 20 more places are joined to a run of so many, stitched to another one at every second place.
void joining(benchmark::State& state, std::uint32_t places) {
  Random random(11);
  std::array<support::BatchPlan, 2> runs{{{{1}, support::random_id<RobotId>(random), 0, 500, 0, "floor"},
                                          {{2}, support::random_id<RobotId>(random), 0, 500, 0, "floor"}}};
  Snapshot snapshot;
  const auto next = [&](support::BatchPlan& run) {
    ++run.sequence;
    Batch batch = support::make_batch(random, snapshot, run);
    for (const Place& place : batch.places) {
      const PlaceId beside{runs[0].experience, place.id.index};
      if (run.experience == runs[0].experience || place.id.index % 2 == 1 || !snapshot.place(beside)) continue;
      batch.edges.push_back(support::make_stitch(random, beside, place.id, "floor"));
    }
    return batch;
  };
  for (std::uint32_t made = 0; made < places; made += 500) {
    for (support::BatchPlan& run : runs) snapshot = with(snapshot, next(run));
  }
  for (support::BatchPlan& run : runs) run.places = 20;
  Times times;
  Times copies;
  for (auto _ : state) {
    snapshot = with(snapshot, next(runs[0]));
    const Batch batch = next(runs[1]);
    times.measure([&] { snapshot = with(snapshot, batch); });
    const Experience& grown = *snapshot.experience(runs[1].experience);
    copies.measure([&] {
      benchmark::DoNotOptimize(std::vector<Place>(grown.places.begin(), grown.places.end()));
      benchmark::DoNotOptimize(std::vector<Edge>(grown.chain.begin(), grown.chain.end()));
    });
  }
  times.report(state);
  copies.report(state, "copy_of_the_run_");
}

int run(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (argc < 2) {
    std::cerr << "scale_bench STORE: a directory that weft-evaluate generate-site has made\n";
    return 2;
  }
  const storage::TemporaryDirectory copy;
  std::filesystem::copy(argv[1], copy.path(), std::filesystem::copy_options::recursive);
  Running running;
  const auto once = [](auto* bench) { bench->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1); };
  once(benchmark::RegisterBenchmark("start", [&](auto& state) { starting(state, copy.path(), running); }));
  once(benchmark::RegisterBenchmark("rows_by_plain_sqlite", [&](auto& state) { reading_rows(state, copy.path()); }));
  once(benchmark::RegisterBenchmark("layout", [&](auto& state) { laying_out(state, running); }));
  benchmark::RegisterBenchmark("search_in_plain_rows", [&](auto& state) {
    plain_search(state, running);
  })->Iterations(1000);
  benchmark::RegisterBenchmark("window", [&](auto& state) { windows(state, running, false); })->Iterations(1000);
  benchmark::RegisterBenchmark("window_and_digest", [&](auto& state) {
    windows(state, running, true);
  })->Iterations(1000);
  for (const std::uint32_t places : {3'000U, 30'000U}) {
    benchmark::RegisterBenchmark(("join_20_places_to_" + std::to_string(places)).c_str(), [places](auto& state) {
      joining(state, places);
    })->Iterations(100);
  }
  // Routes are being prepared at first.
  once(benchmark::RegisterBenchmark("under_load_at_first", [&](auto& state) { under_load(state, running, 20.0); }));
  once(benchmark::RegisterBenchmark("under_load", [&](auto& state) { under_load(state, running, 60.0); }));
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

}  // namespace
}  // namespace weft::bench

int main(int argc, char** argv) {
  try {
    return weft::bench::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "scale_bench: " << error.what() << '\n';
    return 1;
  }
}
