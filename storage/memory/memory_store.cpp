#include "storage/memory/memory_store.hpp"

#include <algorithm>

#include "storage/network_builder.hpp"

namespace weft::storage {
namespace {

Facts facts_for(const MemoryDisk& disk, const Needs& needs) {
  Facts facts;
  for (const ExperienceId& id : needs.experiences) {
    const auto found = disk.experiences.find(id);
    if (found != disk.experiences.end()) facts.experiences.insert(*found);
  }
  for (const BatchKey& key : needs.batches) {
    const auto found = disk.batch_hashes.find(key);
    if (found != disk.batch_hashes.end()) facts.batches.insert(*found);
  }
  for (const ContentHash& hash : needs.contents) {
    if (disk.contents.contains(hash)) facts.contents.insert(hash);
  }
  return facts;
}

/// Writes one change that the plan calls fresh. Cannot fail.
class Writer {
 public:
  explicit Writer(MemoryDisk& disk) : disk_(disk) {}

  void operator()(const PutContent& put) {
    disk_.contents[put.hash] = {put.kind, std::make_shared<const Bytes>(put.bytes)};
    disk_.content_bytes += put.bytes.size();
  }
  void operator()(const AppendBatch& append) {
    disk_.history.emplace_back(append.batch);
    disk_.batch_hashes[{append.batch.experience, append.batch.sequence}] = append.hash;
  }
  void operator()(const PutLabel& put) { disk_.labels[put.label] = put.place; }
  void operator()(const SealExperience& seal) {
    disk_.history.emplace_back(MemoryDisk::Seal{seal.experience, seal.reason});
  }
  void operator()(const PutGoal& put) { disk_.goals[put.goal.id] = put.goal; }
  void operator()(const PutRoute& put) { disk_.routes[put.route.goal] = put.route; }
  void operator()(const PutOccupancy& put) {
    if (put.held.places.empty()) {
      disk_.occupancies.erase(put.robot);
    } else {
      disk_.occupancies[put.robot] = put;
    }
  }
  void operator()(const PutRobot& put) { disk_.robots[put.robot] = put.name; }
  void operator()(const PutEvent& put) { disk_.events.push_back(put.event); }

 private:
  MemoryDisk& disk_;
};

/// Collects heads first, because a later batch or seal may close an experience.
class Replay {
 public:
  explicit Replay(NetworkBuilder& builder) : builder_(builder) {}

  void operator()(const Batch& batch) {
    auto [at, is_new] = heads_.try_emplace(batch.experience);
    NetworkBuilder::Head& head = at->second;
    if (is_new) {
      head = {.id = batch.experience, .robot = batch.robot, .name = batch.name, .method = batch.method};
    }
    if (batch.seal) {
      head.sealed = true;
      head.seal_reason = batch.seal_reason;
    }
    head.places += batch.places.size();
    for (const Place& place : batch.places) builder_.add(place);
    for (const Edge& edge : batch.edges) builder_.add(edge);
  }
  void operator()(const MemoryDisk::Seal& seal) {
    NetworkBuilder::Head& head = heads_.at(seal.experience);
    head.sealed = true;
    head.seal_reason = seal.reason;
  }
  void finish() {
    for (auto& [id, head] : heads_) builder_.add(std::move(head));
  }

 private:
  NetworkBuilder& builder_;
  std::map<ExperienceId, NetworkBuilder::Head> heads_;
};

class MemoryStore final : public MapStore {
 public:
  explicit MemoryStore(std::shared_ptr<MemoryDisk> disk) : disk_(std::move(disk)) {}

  Result<Stored> open() override {
    if (disk_->faults.full) return fail(*disk_->faults.strike("memory store, epoch"));
    epoch_ = {++disk_->epoch.value};
    NetworkBuilder builder;
    Replay replay(builder);
    for (const auto& step : disk_->history) std::visit(replay, step);
    replay.finish();
    for (const auto& [label, place] : disk_->labels) builder.add_label(label, place);

    Stored stored;
    stored.epoch = epoch_;
    stored.snapshot = builder.build(disk_->revision);
    for (const auto& [id, facts] : disk_->experiences) stored.durable_through[id] = facts.durable_through;
    stored.goals = disk_->goals;
    stored.routes = disk_->routes;
    stored.occupancies = disk_->occupancies;
    stored.robots = disk_->robots;
    stored.quarantined = builder.take_damage();
    return stored;
  }

  Result<Commit> commit(const Transaction& transaction) override {
    if (epoch_ != disk_->epoch) {
      return fail(ErrorCode::stale, "memory store: epoch " + std::to_string(epoch_.value) +
                                        " has ended, another server opened the store with epoch " +
                                        std::to_string(disk_->epoch.value));
    }
    Result<Plan> plan = make_plan(transaction, facts_for(*disk_, needs_of(transaction)));
    if (!plan) return fail(plan.error());
    if (auto error = disk_->faults.strike("memory store")) return fail(std::move(*error));

    Writer write(*disk_);
    for (std::size_t at = 0; at < transaction.changes.size(); ++at) {
      if (plan->fresh[at]) std::visit(write, transaction.changes[at]);
    }
    for (const auto& [id, facts] : plan->experiences) disk_->experiences[id] = facts;
    if (plan->changes_network) ++disk_->revision.value;
    return Commit{disk_->revision};
  }

  bool has_content(const ContentHash& hash) const override { return disk_->contents.contains(hash); }

  Result<Bytes> content(const ContentHash& hash) const override {
    const auto found = disk_->contents.find(hash);
    if (found == disk_->contents.end()) {
      return fail(ErrorCode::not_found, "content " + to_string(hash) + " is not stored");
    }
    return *found->second.bytes;
  }

  std::optional<ContentHash> batch_hash(ExperienceId experience, std::uint64_t sequence) const override {
    const auto found = disk_->batch_hashes.find({experience, sequence});
    if (found == disk_->batch_hashes.end()) return std::nullopt;
    return found->second;
  }

  Result<std::vector<msg::Event>> events(const GoalId& goal, const RobotId& robot, std::size_t limit) const override {
    std::vector<msg::Event> found;
    for (auto at = disk_->events.rbegin(); at != disk_->events.rend() && found.size() < limit; ++at) {
      if ((!goal || at->goal == goal) && (!robot || at->robot == robot)) found.push_back(*at);
    }
    std::reverse(found.begin(), found.end());
    return found;
  }

  StoreSize size() const override {
    return {.contents = disk_->contents.size(),
            .content_bytes = disk_->content_bytes,
            .disk_free_bytes = disk_->faults.full ? 0 : std::uint64_t{1} << 40U};
  }

  std::string engine() const override { return "memory"; }

 private:
  std::shared_ptr<MemoryDisk> disk_;
  Epoch epoch_;
};

}  // namespace

std::unique_ptr<MapStore> make_memory_store(std::shared_ptr<MemoryDisk> disk) {
  return std::make_unique<MemoryStore>(std::move(disk));
}

}  // namespace weft::storage
