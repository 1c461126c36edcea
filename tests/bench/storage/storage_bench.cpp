/// Measures the map store and plain SQLite: same bytes, same transactions. build/release/bench/storage_bench
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

#include "core/network/codec.hpp"
#include "core/random.hpp"
#include "storage/sqlite/database.hpp"
#include "storage/sqlite/sqlite_store.hpp"
#include "tests/storage/sample_map.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::storage {
namespace {

constexpr std::uint32_t kPlaces = 20;
constexpr std::size_t kContentBytes = 20'000;

std::unique_ptr<MapStore> open_store(const std::filesystem::path& directory, benchmark::State& state) {
  auto store = open_sqlite(directory);
  if (!store || !(*store)->open()) {
    state.SkipWithError("cannot open the store");
    return nullptr;
  }
  return std::move(*store);
}

void count_bytes(benchmark::State& state) {
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * kPlaces * kContentBytes);
}

void intake_store(benchmark::State& state) {
  const TemporaryDirectory directory;
  const auto store = open_store(directory.path(), state);
  if (!store) return;
  sample::Run run(1, 1);
  for (auto _ : state) {
    state.PauseTiming();
    const Transaction transaction = sample::transaction(run.next(kPlaces, kContentBytes));
    state.ResumeTiming();
    if (!store->commit(transaction)) state.SkipWithError("commit failed");
  }
  count_bytes(state);
}

/// Stores as anyone would write it first: a table of blobs, by key, WAL, synchronous = FULL.
class PlainStore {
 public:
  explicit PlainStore(const std::filesystem::path& directory)
      : database_(sqlite::Database::open(directory / "plain.sqlite", "").value()) {
    const auto made = database_.run(
        "PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; CREATE TABLE blobs (hash BLOB PRIMARY KEY, bytes "
        "BLOB)");
    insert_ = database_.prepare("INSERT INTO blobs VALUES (?, ?)").value();
    select_ = database_.prepare("SELECT bytes FROM blobs WHERE hash = ?").value();
    is_open_ = made.has_value();
  }
  bool insert(const Transaction& transaction) {
    auto write = sqlite::WriteTransaction::begin(database_);
    bool is_done = is_open_ && write;
    for (const auto& change : transaction.changes) {
      if (const auto* put = std::get_if<PutContent>(&change)) {
        sqlite::Query query(insert_);
        query << put->hash << ByteView(put->bytes);
        is_done = is_done && query.run();
      }
    }
    return is_done && write->commit();
  }
  Bytes read(const ContentHash& hash) {
    sqlite::Query query(select_);
    query << hash;
    if (!query.step().value_or(false)) return {};
    const ByteView bytes = query.blob(0);
    return {bytes.begin(), bytes.end()};
  }

 private:
  sqlite::Database database_;
  sqlite::Statement insert_;
  sqlite::Statement select_;
  bool is_open_ = false;
};

void intake_plain_sqlite(benchmark::State& state) {
  const TemporaryDirectory directory;
  PlainStore plain(directory.path());
  sample::Run run(1, 1);
  for (auto _ : state) {
    state.PauseTiming();
    const Transaction transaction = sample::transaction(run.next(kPlaces, kContentBytes));
    state.ResumeTiming();
    if (!plain.insert(transaction)) state.SkipWithError("insert failed");
  }
  count_bytes(state);
}

constexpr std::size_t kNeighbourhood = 50;

std::vector<Transaction> neighbourhood() {
  sample::Run run(1, 1);
  std::vector<Transaction> transactions;
  for (std::size_t at = 0; at < kNeighbourhood; ++at) {
    transactions.push_back(sample::transaction(run.next(1, kContentBytes)));
  }
  return transactions;
}

/// Measures what no store can be faster than that verifies the SHA-256 at every reading.
void hash_50(benchmark::State& state) {
  const auto transactions = neighbourhood();
  for (auto _ : state) {
    for (const Transaction& transaction : transactions) {
      benchmark::DoNotOptimize(hash_bytes(std::get<PutContent>(transaction.changes.front()).bytes));
    }
  }
}

/// Returns a neighbourhood whose bytes do not shrink when compressed, as those of the floor method.
std::vector<Transaction> dense_neighbourhood() {
  Random random(2);
  std::vector<Transaction> transactions(kNeighbourhood);
  for (Transaction& transaction : transactions) {
    Bytes bytes(kContentBytes);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.next());
    transaction.changes.emplace_back(PutContent{hash_bytes(bytes), msg::ContentKind::content, bytes});
  }
  return transactions;
}

/// Measures reading. `read(store, hash)` returns the content's own size, 0 when it cannot be read.
template <class Read>
void read_50(benchmark::State& state, const std::vector<Transaction>& transactions, Read read) {
  const TemporaryDirectory directory;
  const auto store = open_store(directory.path(), state);
  if (!store) return;
  for (const Transaction& transaction : transactions) benchmark::DoNotOptimize(store->commit(transaction));
  for (auto _ : state) {
    for (const Transaction& transaction : transactions) {
      if (read(*store, std::get<PutContent>(transaction.changes.front()).hash) != kContentBytes) {
        state.SkipWithError("read failed");
      }
    }
  }
}

std::uint64_t stored_size(const MapStore& store, const ContentHash& hash) {
  const auto content = store.stored_content(hash);
  return content ? content->size : 0;
}

/// Measures what the server does for an agent: the bytes as they are kept, checked by their sum.
void read_50_store(benchmark::State& state) {
  read_50(state, neighbourhood(), stored_size);
}
void read_50_store_dense(benchmark::State& state) {
  read_50(state, dense_neighbourhood(), stored_size);
}

/// Reads the bytes themselves, checked by their SHA-256.
void read_50_store_expanded(benchmark::State& state) {
  read_50(state, neighbourhood(), [](const MapStore& store, const ContentHash& hash) {
    const auto bytes = store.content(hash);
    return bytes ? bytes->size() : 0;
  });
}

void read_50_plain_sqlite(benchmark::State& state) {
  const TemporaryDirectory directory;
  PlainStore plain(directory.path());
  const auto transactions = neighbourhood();
  for (const Transaction& transaction : transactions) benchmark::DoNotOptimize(plain.insert(transaction));
  for (auto _ : state) {
    for (const Transaction& transaction : transactions) {
      const Bytes bytes = plain.read(std::get<PutContent>(transaction.changes.front()).hash);
      if (bytes.size() != kContentBytes) state.SkipWithError("read failed");
    }
  }
}

void fill_100k_places(MapStore& store, benchmark::State& state) {
  for (std::uint64_t experience = 1; experience <= 100; ++experience) {
    sample::Run run(experience, experience);
    if (!store.commit(sample::transaction(run.next(1000, 32)))) state.SkipWithError("commit failed");
  }
}

/// Measures the time in all, and of the longest step: what others wait at most.
template <class Begin>
void upkeep_100k_places(benchmark::State& state, Begin begin) {
  const TemporaryDirectory directory;
  const auto store = open_store(directory.path(), state);
  if (!store) return;
  fill_100k_places(*store, state);
  const Removal half{{{{7}, 0, 500}}, {}};
  if (!store->commit({{TakeOut{half}}, {}})) state.SkipWithError("commit failed");
  double longest_s = 0.0;
  std::uint64_t steps = 0;
  for (auto _ : state) {
    const auto job = begin(*store, directory.path() / ("snapshot-" + std::to_string(steps)));
    for (bool finished = !job; !finished; ++steps) {
      const auto began = std::chrono::steady_clock::now();
      const auto progress = (*job)->step();
      longest_s =
          std::max(longest_s, std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
      if (!progress) state.SkipWithError("a step failed");
      finished = !progress || progress->finished;
    }
  }
  state.counters["longest_step_ms"] = longest_s * 1000.0;
  state.counters["steps"] = static_cast<double>(steps);
}

void check_100k_places(benchmark::State& state) {
  upkeep_100k_places(state, [](MapStore& store, const auto&) { return store.check(); });
}
void snapshot_100k_places(benchmark::State& state) {
  upkeep_100k_places(state, [](MapStore& store, const auto& file) { return store.snapshot_to(file); });
}
void compact_100k_places(benchmark::State& state) {
  upkeep_100k_places(state, [](MapStore& store, const auto&) { return store.compact({101}); });
}
void stats_100k_places(benchmark::State& state) {
  upkeep_100k_places(state, [](MapStore& store, const auto&) { return store.stats(); });
}

void open_100k_places(benchmark::State& state) {
  const TemporaryDirectory directory;
  {
    const auto store = open_store(directory.path(), state);
    if (!store) return;
    fill_100k_places(*store, state);
  }
  for (auto _ : state) {
    auto store = open_sqlite(directory.path());
    const auto stored = (*store)->open();
    if (!stored || stored->snapshot.place_count() != 100'000) state.SkipWithError("places are missing");
  }
}

BENCHMARK(intake_plain_sqlite)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(300);
BENCHMARK(intake_store)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(300);
BENCHMARK(read_50_plain_sqlite)->Unit(benchmark::kMillisecond);
BENCHMARK(hash_50)->Unit(benchmark::kMillisecond);
BENCHMARK(read_50_store)->Unit(benchmark::kMillisecond);
BENCHMARK(read_50_store_dense)->Unit(benchmark::kMillisecond);
BENCHMARK(read_50_store_expanded)->Unit(benchmark::kMillisecond);
BENCHMARK(check_100k_places)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(snapshot_100k_places)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(compact_100k_places)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(stats_100k_places)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(open_100k_places)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace weft::storage
