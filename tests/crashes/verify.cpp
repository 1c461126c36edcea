#include "tests/crashes/verify.hpp"

#include "core/network/codec.hpp"
#include "storage/sqlite/sqlite_store.hpp"
#include "tests/storage/job_steps.hpp"

namespace weft::crashes {
namespace {

using namespace storage;

class Verifier {
 public:
  Verifier(const RoundPlan& plan, Promised& promised) : plan_(plan), promised_(promised) {}

  std::vector<std::string> run() {
    auto store = open_sqlite(plan_.directory);
    if (!store) return {store.error().message};
    auto stored = (*store)->open();
    if (!stored) return {stored.error().message};
    losses_ = stored->quarantined;
    check_everything(**store);
    check_revisions(**store, *stored);
    for (std::uint32_t producer = 0; producer < kProducers; ++producer) check_batches(**store, *stored, producer);
    check_edits(**store);
    return std::move(losses_);
  }

 private:
  void lost(std::string what) { losses_.push_back(std::move(what)); }

  void check_everything(MapStore& store) {
    const auto job = store.check();
    const auto progress = job ? finish(**job) : Result<JobProgress>(fail(job.error()));
    if (!progress) return lost("check: " + progress.error().message);
    losses_.insert(losses_.end(), progress->findings.begin(), progress->findings.end());
  }

  void check_revisions(const MapStore& store, const Stored& stored) {
    const std::uint64_t newest = stored.snapshot.revision().value;
    if (newest < promised_.revision) {
      lost("revision " + std::to_string(promised_.revision) + " was acknowledged, the newest is " +
           std::to_string(newest));
    }
    const std::uint64_t floor = store.size().floor.value;
    if (floor < promised_.floor) lost("the floor fell to " + std::to_string(floor));
    promised_.floor = floor;
    const auto log = store.log({}, 1'000'000);
    if (!log) return lost("log: " + log.error().message);
    std::uint64_t expected = newest;
    for (const RevisionNote& note : *log) {
      if (note.revision.value != expected) return lost("revision " + std::to_string(expected) + " has no note");
      kinds_[expected--] = note.kind;
    }
    if (expected + 1 != std::max<std::uint64_t>(floor, newest == 0 ? 0 : 1) && newest > 0) {
      lost("the log ends at " + std::to_string(expected + 1));
    }
  }

  void check_batches(const MapStore& store, const Stored& stored, std::uint32_t producer) {
    const ExperienceId id = experience_of(producer);
    const auto found = stored.durable_through.find(id);
    const std::uint64_t durable = found == stored.durable_through.end() ? 0 : found->second;
    const std::uint64_t acknowledged = promised_.durable_through[producer];
    if (durable < acknowledged || durable > acknowledged + 1) {
      lost("producer " + std::to_string(producer) + ": durable through " + std::to_string(durable) +
           ", acknowledged was " + std::to_string(acknowledged));
    }
    const Experience* const experience = stored.snapshot.experience(id);
    if (durable > 0 && (experience == nullptr || experience->extent != durable * kPlaces)) {
      lost("producer " + std::to_string(producer) + ": " +
           std::to_string(experience == nullptr ? 0 : experience->extent) + " places for " + std::to_string(durable) +
           " batches");
    }
    for (std::uint64_t sequence = 1; sequence <= durable; ++sequence) {
      check_batch(store, stored.snapshot, delivery_of(plan_.seed, producer, sequence));
    }
    promised_.durable_through[producer] = durable;
  }

  void check_batch(const MapStore& store, const Snapshot& snapshot, const sample::Delivery& delivery) {
    const Batch& batch = delivery.batch;
    const std::string name = "batch " + std::to_string(batch.sequence) + " of " + to_string(batch.experience);
    if (store.batch_hash(batch.experience, batch.sequence) != hash(batch)) lost(name + " is lost or changed");
    for (std::size_t at = 0; at < batch.places.size(); ++at) {
      const Place* const place = snapshot.place(batch.places[at].id);
      if (place == nullptr) continue;  // taken out or rolled back
      if (!(*place == batch.places[at])) lost("place " + to_string(batch.places[at].id) + " is changed");
      const auto bytes = store.content(batch.places[at].content.hash);
      if (!bytes || *bytes != delivery.contents[at]) {
        lost(name + ": content " + to_string(batch.places[at].content.hash) +
             (bytes ? " has other bytes" : ": " + bytes.error().message));
      }
    }
  }

  void check_edits(const MapStore& store) {
    const char* const names[] = {"out", "back", "rollback", "label"};
    for (const auto& [revision, edit] : promised_.edits) {
      if (revision < store.size().floor.value) continue;
      const auto kind = kinds_.find(revision);
      if (kind != kinds_.end() && kind->second == names[static_cast<std::size_t>(edit)]) continue;
      lost("edit of revision " + std::to_string(revision) + " is lost");
    }
  }

  const RoundPlan& plan_;
  Promised& promised_;
  std::map<std::uint64_t, std::string> kinds_;
  std::vector<std::string> losses_;
};

std::vector<std::string> verify_snapshot(const RoundPlan& plan, const Promised& promised) {
  if (!std::filesystem::exists(plan.snapshot)) {
    return promised.has_snapshot ? std::vector<std::string>{"the finished snapshot is not there"}
                                 : std::vector<std::string>{};
  }
  const std::filesystem::path directory = plan.snapshot.string() + ".opened";
  std::filesystem::create_directories(directory);
  std::filesystem::rename(plan.snapshot, directory / "map.sqlite");
  std::vector<std::string> losses;
  {
    auto store = open_sqlite(directory);
    auto stored = store ? (*store)->open() : Result<Stored>(fail(store.error()));
    const auto job = stored ? (*store)->check() : Result<std::unique_ptr<StoreJob>>(fail(stored.error()));
    const auto progress = job ? finish(**job) : Result<JobProgress>(fail(job.error()));
    if (!progress) losses.push_back(progress.error().message);
    if (progress) losses = progress->findings;
    if (stored && promised.has_snapshot && stored->snapshot.revision().value < promised.snapshot_revision) {
      losses.push_back("it is of revision " + std::to_string(stored->snapshot.revision().value) + ", not of " +
                       std::to_string(promised.snapshot_revision));
    }
  }
  std::filesystem::remove_all(directory);
  for (std::string& loss : losses) loss = "snapshot: " + loss;
  return losses;
}

}  // namespace

std::vector<std::string> verify(const RoundPlan& plan, Promised& promised) {
  std::vector<std::string> losses = Verifier(plan, promised).run();
  const std::vector<std::string> more = verify_snapshot(plan, promised);
  losses.insert(losses.end(), more.begin(), more.end());
  return losses;
}

}  // namespace weft::crashes
