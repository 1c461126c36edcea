#include "tests/bench/topometric/aisle_store.hpp"

#include <cstdio>

#include "agents/methods/topometric/topometric.hpp"
#include "core/network/codec.hpp"
#include "core/random.hpp"
#include "storage/sqlite/sqlite_store.hpp"
#include "tests/bench/times.hpp"

namespace weft::bench {
namespace {

using namespace agents;

constexpr std::uint32_t kPlacesOfBatch = 20;

Bytes moved_a_little(TopometricContent content, Random& random) {
  constexpr double quantum_m = 1e-6 * cloud_quantum_um;
  for (Eigen::Vector3f& point : content.cloud.points)
    for (int axis = 0; axis < 3; ++axis) point[axis] += static_cast<float>(random.uniform(-quantum_m, quantum_m));
  return encode_topometric_content(content);
}

/// Makes one robot's run, a batch at a time.
class AisleRun {
 public:
  explicit AisleRun(const std::vector<RunPlace>& contents) : contents_(contents) {}

  storage::Transaction next() {
    storage::Transaction transaction;
    Batch batch;
    batch.experience = ExperienceId{1};
    batch.sequence = ++sequence_;
    batch.robot = RobotId{{1}};
    batch.name = "aisle";
    batch.method = std::string(Topometric::name);
    for (std::uint32_t i = 0; i < kPlacesOfBatch; ++i, ++places_) {
      Bytes bytes = moved_a_little(contents_[places_ % contents_.size()].content, random_);
      canonical_ += bytes.size();
      Place place;
      place.id = {batch.experience, places_};
      place.method = batch.method;
      place.content_format = Topometric::content_format;
      place.content = {hash_bytes(bytes), bytes.size()};
      place.robot = batch.robot;
      place.seen_at = SensorTime(std::chrono::milliseconds(1000 * places_));
      batch.places.push_back(place);
      if (places_ > 0) batch.edges.push_back(edge_to(place.id));
      const ContentHash hash = place.content.hash;
      transaction.changes.emplace_back(storage::PutContent{hash, msg::ContentKind::content, std::move(bytes)});
    }
    transaction.changes.emplace_back(storage::AppendBatch{batch, hash(batch)});
    return transaction;
  }
  std::uint32_t places() const { return places_; }
  std::size_t canonical() const { return canonical_; }

 private:
  static Edge edge_to(const PlaceId& place) {
    Edge edge;
    edge.id = {{place.experience, place.index - 1}, place};
    Metric3 half_a_metre;
    half_a_metre.a_from_b.translation = {0.5, 0.0, 0.0};
    half_a_metre.covariance = Matrix6d::Identity() * 1e-5;
    edge.a_from_b = half_a_metre;
    edge.method = std::string(Topometric::name);
    edge.drivable = Drivable::both;
    return edge;
  }

  const std::vector<RunPlace>& contents_;
  Random random_{7};
  std::uint64_t sequence_ = 0;
  std::uint32_t places_ = 0;
  std::size_t canonical_ = 0;
};

double megabytes_in(const std::filesystem::path& directory) {
  double bytes = 0.0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory))
    if (entry.is_regular_file()) bytes += static_cast<double>(entry.file_size());
  return 1e-6 * bytes;
}

}  // namespace

Result<void> write_aisle(const std::vector<RunPlace>& contents, std::size_t places,
                         const std::filesystem::path& directory) {
  if (contents.empty()) return fail(ErrorCode::invalid, "no contents to fill an aisle with");
  std::error_code ignored;
  std::filesystem::create_directories(directory, ignored);
  Result<std::unique_ptr<storage::MapStore>> store = storage::open_sqlite(directory);
  if (!store) return fail(store.error());
  if (const auto opened = (*store)->open(); !opened) return fail(opened.error());
  AisleRun run(contents);
  double commits_ms = 0.0;
  while (run.places() < places) {
    const storage::Transaction transaction = run.next();
    Result<void> committed;
    commits_ms += timed([&] {
                    const auto done = (*store)->commit(transaction);
                    if (!done) committed = fail(done.error());
                  }).processor_ms;
    if (!committed) return committed;
  }
  store->reset();
  const double count = run.places();
  std::printf(
      "%u places, %.0f m: %.1f MB as they were taught, %.1f MB in the store, %.1f kB a place; %.2f ms of the "
      "processor each\n",
      run.places(), 0.5 * count, 1e-6 * static_cast<double>(run.canonical()), megabytes_in(directory),
      1e3 * megabytes_in(directory) / count, commits_ms / count);
  return {};
}

}  // namespace weft::bench
