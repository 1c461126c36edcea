#include "storage/memory/memory_store.hpp"

#include <algorithm>

#include "storage/lineage.hpp"
#include "storage/memory/memory_jobs.hpp"
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
  for (const EdgeId& stitch : needs.stitches) {
    if (disk.edges.contains(stitch)) facts.stitches.insert(stitch);
  }
  for (const ExperienceId& id : needs.moved_in) {
    const auto found = disk.deleted.find(id);
    if (found != disk.deleted.end()) facts.deleted.insert(*found);
  }
  facts.revision = disk.revision;
  facts.floor = disk.floor;
  return facts;
}

/// Writes one change that the plan calls fresh. Cannot fail.
class Writer {
 public:
  Writer(MemoryDisk& disk, ContentCoder& coder) : disk_(disk), coder_(coder) {}

  void operator()(const PutContent& put) const {
    Coded coded = coder_.encode(put.bytes);
    if (coded.coding == Coding::raw) coded.bytes = put.bytes;
    disk_.contents[put.hash] = {put.kind, coded.coding, put.bytes.size(),
                                std::make_shared<const Bytes>(std::move(coded.bytes))};
    disk_.content_bytes += put.bytes.size();
  }
  void operator()(const AppendBatch& append) const {
    remember(append.batch);
    for (const Edge& edge : append.batch.edges) ++disk_.edges[edge.id];
    disk_.batch_hashes[{append.batch.experience, append.batch.sequence}] = append.hash;
  }
  void operator()(const PutPlaces& put) const { remember(put); }
  void operator()(const PutLabel& put) const { remember(put); }
  void operator()(const PutApart& put) const { remember(PutApart{ordered(put.apart), put.holds}); }
  void operator()(const PutRule& put) const { remember(put); }
  void operator()(const PutRegistration& put) const { remember(put); }
  void operator()(const SealExperience& seal) const { remember(MemoryDisk::Seal{seal.experience, seal.reason}); }
  void operator()(const TakeOut& out) const { remember(out); }
  void operator()(const BringBack& back) const { remember(back); }
  void operator()(const RollBack& back) const { disk_.bases[{disk_.revision.value + 1}] = back.to; }
  void operator()(const PutGoal& put) const { disk_.goals[put.goal.id] = put.goal; }
  void operator()(const PutRoute& put) const { disk_.routes[put.route.goal] = put.route; }
  void operator()(const PutOccupancy& put) const {
    if (put.held.places.empty()) {
      disk_.occupancies.erase(put.robot);
    } else {
      disk_.occupancies[put.robot] = put;
    }
  }
  void operator()(const PutRobot& put) const { disk_.robots[put.robot] = put.name; }
  void operator()(const PutHold& put) const {
    if (put.who.empty()) {
      disk_.holds.erase(put.robot);
    } else {
      disk_.holds[put.robot] = put.who;
    }
  }
  void operator()(const PutAwaitedLabel& put) const {
    if (put.place.experience) {
      disk_.awaited_labels[put.label] = put;
    } else {
      disk_.awaited_labels.erase(put.label);
    }
  }
  void operator()(const PutPasses& put) const { disk_.passes[put.piece] = put.passes; }
  void operator()(const PutEvent& put) const { disk_.events.push_back(put.event); }
  void operator()(const PutPreparation& put) const {
    disk_.preparations[put.methods] = std::make_shared<const Bytes>(put.bytes);
  }

 private:
  template <class Change>
  void remember(const Change& change) const {
    disk_.history.push_back({{disk_.revision.value + 1}, change});
  }
  MemoryDisk& disk_;
  ContentCoder& coder_;
};

/// Collects heads first, because a later batch or seal may close an experience.
class Replay {
 public:
  Replay(NetworkBuilder& builder, const Lineage& lineage) : builder_(builder), lineage_(lineage) {}

  void take(const MemoryDisk::Step& step) {
    at_ = step.revision;
    is_in_ = lineage_.contains(at_.value);
    std::visit(*this, step.change);
  }
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
    for (const Place& place : batch.places) is_in_ ? builder_.add(place) : builder_.add_absent(place.id);
    for (const Edge& edge : batch.edges) is_in_ ? builder_.add(edge, at_) : builder_.add_absent(edge.id);
    know_anew(batch.learned);
  }
  void operator()(const PutPlaces& put) { know_anew(put.places); }
  void operator()(const MemoryDisk::Seal& seal) {
    NetworkBuilder::Head& head = heads_.at(seal.experience);
    head.sealed = true;
    head.seal_reason = seal.reason;
  }
  void operator()(const PutLabel& put) {
    if (is_in_) builder_.add_label(put.label, put.place);
  }
  void operator()(const PutApart& put) {
    if (is_in_) builder_.add_apart(put.apart, put.holds);
  }
  void operator()(const PutRule& put) {
    if (is_in_) builder_.add_rule(put.rule, put.holds);
  }
  void operator()(const PutRegistration& put) {
    if (is_in_) builder_.add_registration(put.registration, put.holds);
  }
  void operator()(const TakeOut& out) {
    if (is_in_) builder_.move(out.what, false, at_);
  }
  void operator()(const BringBack& back) {
    if (is_in_) builder_.move(back.what, true, at_);
  }
  void finish(const std::map<ExperienceId, ExperienceFacts>& facts) {
    for (auto& [id, head] : heads_) {
      head.places = facts.at(id).places;
      builder_.add(std::move(head));
    }
  }

 private:
  void know_anew(const std::vector<Place>& places) {
    if (!is_in_) return;
    for (const Place& place : places) builder_.add(place);
  }

  NetworkBuilder& builder_;
  const Lineage& lineage_;
  Revision at_;
  bool is_in_ = true;
  std::map<ExperienceId, NetworkBuilder::Head> heads_;
};

Snapshot replay(const MemoryDisk& disk, Revision revision, std::vector<std::string>& damage) {
  const Lineage lineage(revision, disk.bases);
  NetworkBuilder builder;
  for (const auto& [id, stretches] : disk.deleted) {
    for (const Stretch& stretch : stretches) builder.add_deleted(stretch);
  }
  Replay replay(builder, lineage);
  for (const MemoryDisk::Step& step : disk.history) replay.take(step);
  replay.finish(disk.experiences);
  Snapshot snapshot = builder.build(revision);
  damage = builder.take_damage();
  return snapshot;
}

/// Returns the places and stitches of one revision's batches.
Removal added_at(const MemoryDisk& disk, Revision revision) {
  Removal added;
  for (const MemoryDisk::Step& step : disk.history) {
    const auto* const batch = std::get_if<Batch>(&step.change);
    if (step.revision != revision || batch == nullptr) continue;
    if (!batch->places.empty()) {
      added.places.push_back({batch->experience, batch->places.front().id.index, batch->places.back().id.index});
    }
    for (const Edge& edge : batch->edges) {
      if (edge.origin == Origin::stitch) added.stitches.push_back(edge.id);
    }
  }
  return added;
}

void append(Removal& to, const Removal& more) {
  to.places.insert(to.places.end(), more.places.begin(), more.places.end());
  to.stitches.insert(to.stitches.end(), more.stitches.begin(), more.stitches.end());
}

class MemoryStore final : public MapStore {
 public:
  explicit MemoryStore(std::shared_ptr<MemoryDisk> disk) : disk_(std::move(disk)) {}

  Result<Stored> open() override {
    if (disk_->faults.full) return fail(*disk_->faults.strike("memory store, epoch"));
    epoch_ = {++disk_->epoch.value};
    Stored stored;
    stored.epoch = epoch_;
    stored.snapshot = replay(*disk_, disk_->revision, stored.quarantined);
    for (const auto& [id, facts] : disk_->experiences) stored.durable_through[id] = facts.durable_through;
    stored.goals = disk_->goals;
    stored.routes = disk_->routes;
    stored.occupancies = disk_->occupancies;
    stored.robots = disk_->robots;
    stored.holds = disk_->holds;
    stored.awaited_labels = disk_->awaited_labels;
    stored.passes = disk_->passes;
    return stored;
  }

  Result<Commit> commit(const Transaction& transaction) override {
    if (epoch_ != disk_->epoch) {
      return fail(ErrorCode::stale, "memory store: epoch " + std::to_string(epoch_.value) +
                                        " has ended, another server opened the store with epoch " +
                                        std::to_string(disk_->epoch.value));
    }
    const Facts known = facts_for(*disk_, needs_of(transaction));
    Result<Plan> plan = make_plan(transaction, known);
    if (!plan) return fail(plan.error());
    if (auto error = disk_->faults.strike("memory store")) return fail(std::move(*error));

    ++disk_->commits;
    const Writer write(*disk_, *coder_);
    for (std::size_t at = 0; at < transaction.changes.size(); ++at) {
      if (plan->fresh[at]) std::visit(write, transaction.changes[at]);
    }
    for (const auto& [id, facts] : plan->experiences) disk_->experiences[id] = facts;
    if (plan->changes_network) {
      disk_->notes.push_back(note_of(transaction, disk_->revision));
      ++disk_->revision.value;
    }
    return Commit{disk_->revision};
  }

  bool has_content(const ContentHash& hash) const override { return disk_->contents.contains(hash); }

  Result<Bytes> content(const ContentHash& hash) const override {
    const auto found = find(hash);
    if (!found) return fail(found.error());
    return coder_->decode((*found)->coding, *(*found)->bytes, (*found)->size);
  }

  Result<StoredContent> stored_content(const ContentHash& hash) const override {
    const auto found = find(hash);
    if (!found) return fail(found.error());
    return StoredContent{(*found)->coding, (*found)->size, *(*found)->bytes};
  }

  std::optional<ContentHash> batch_hash(ExperienceId experience, std::uint64_t sequence) const override {
    const auto found = disk_->batch_hashes.find({experience, sequence});
    if (found == disk_->batch_hashes.end()) return std::nullopt;
    return found->second;
  }

  Result<EventPage> events(const EventFilter& filter, std::size_t limit) const override {
    EventPage page;
    page.newest = disk_->events.size();
    page.oldest = disk_->events.empty() ? 0 : 1;
    for (std::size_t i = 0; i < disk_->events.size(); ++i) {
      msg::Event event = disk_->events[i];
      event.number = i + 1;
      if (fits(filter, event)) page.events.push_back(std::move(event));
    }
    const auto over = static_cast<std::ptrdiff_t>(page.events.size() - std::min(limit, page.events.size()));
    if (goes_forward(filter)) {
      page.events.erase(page.events.end() - over, page.events.end());
    } else {
      page.events.erase(page.events.begin(), page.events.begin() + over);
    }
    return page;
  }

  Result<Snapshot> snapshot_at(Revision revision, const Snapshot& /*near*/) const override {
    if (auto there = check_revision("map", revision); !there) return fail(there.error());
    std::vector<std::string> damage;
    return replay(*disk_, revision, damage);
  }

  Result<std::vector<RevisionNote>> log(Revision newest, std::size_t limit) const override {
    std::vector<RevisionNote> notes;
    const std::uint64_t from =
        newest.value == 0 ? disk_->notes.size() : std::min(newest.value, disk_->revision.value);
    if (auto kept = check_kept("log", {from}, disk_->floor); !kept) return fail(kept.error());
    const std::uint64_t oldest = std::max<std::uint64_t>(disk_->floor.value, 1);
    for (std::uint64_t at = from; at >= oldest && notes.size() < limit; --at) notes.push_back(disk_->notes[at - 1]);
    return notes;
  }

  Result<std::map<ExperienceId, WallTime>> begun() const override {
    std::map<ExperienceId, WallTime> begun;
    for (const MemoryDisk::Step& step : disk_->history) {
      const auto* const batch = std::get_if<Batch>(&step.change);
      if (batch == nullptr || batch->sequence != 1 || step.revision < disk_->floor) continue;
      const WallTime at = disk_->notes[step.revision.value - 1].at;
      if (at != WallTime{}) begun[batch->experience] = at;
    }
    return begun;
  }

  Result<RevisionChanges> changes_of(Revision revision) const override {
    if (auto there = check_revision("changes", revision); !there) return fail(there.error());
    if (auto known = check_changes_kept(revision, disk_->floor); !known) return fail(known.error());
    if (revision.value == 0) return fail(ErrorCode::not_found, "the map has no revision 0");
    RevisionChanges changes;
    changes.note = disk_->notes[revision.value - 1];
    changes.added = added_at(*disk_, revision);
    for (const MemoryDisk::Step& step : disk_->history) {
      if (step.revision != revision) continue;
      if (const auto* out = std::get_if<TakeOut>(&step.change)) append(changes.taken_out, out->what);
      if (const auto* back = std::get_if<BringBack>(&step.change)) append(changes.brought_back, back->what);
      if (const auto* put = std::get_if<PutLabel>(&step.change)) changes.labels.insert(put->label);
      if (const auto* put = std::get_if<PutApart>(&step.change)) changes.aparts.insert(put->apart);
      if (const auto* put = std::get_if<PutRule>(&step.change)) changes.rules.insert(put->rule.name);
      if (const auto* put = std::get_if<PutRegistration>(&step.change)) {
        changes.registrations.insert(put->registration.plan);
      }
      const std::vector<Place>* const known = known_anew(step);
      if (known != nullptr) changes.known_anew.insert(changes.known_anew.end(), known->begin(), known->end());
    }
    return changes;
  }

  Result<Bytes> preparation(const std::string& methods) const override {
    const auto found = disk_->preparations.find(methods);
    if (found == disk_->preparations.end()) {
      return fail(ErrorCode::not_found, "preparation for " + methods + " is not stored");
    }
    return *found->second;
  }

  Result<std::unique_ptr<StoreJob>> check() override { return make_memory_check(*disk_); }
  Result<std::unique_ptr<StoreJob>> snapshot_to(const std::filesystem::path& file) override {
    return fail(ErrorCode::refused, "snapshot " + file.string() + ": the memory engine has no file to copy");
  }

  Result<std::unique_ptr<StoreJob>> verify(const std::filesystem::path& file, const Snapshot& /*live*/) override {
    return fail(ErrorCode::refused, "snapshot " + file.string() + ": the memory engine reads no file");
  }

  Result<std::unique_ptr<StoreJob>> compact(Revision before) override {
    if (before.value == 0 || before > disk_->revision) {
      return fail(ErrorCode::not_found, "compaction: the map has no revision " + std::to_string(before.value) +
                                            " to keep; its newest is " + std::to_string(disk_->revision.value));
    }
    if (auto kept = check_kept("compaction", before, disk_->floor); !kept) return fail(kept.error());
    return make_memory_compaction(*disk_, before);
  }
  Result<std::unique_ptr<StoreJob>> stats() override { return make_memory_stats(*disk_); }

  StoreSize size() const override {
    return {.contents = disk_->contents.size(),
            .content_bytes = disk_->content_bytes,
            .disk_free_bytes = disk_->faults.full ? 0 : std::uint64_t{1} << 40U,
            .floor = disk_->floor};
  }

  std::string engine() const override { return "memory"; }

 private:
  Result<const MemoryDisk::Content*> find(const ContentHash& hash) const {
    const auto found = disk_->contents.find(hash);
    if (found != disk_->contents.end()) return &found->second;
    return fail(ErrorCode::not_found, "content " + to_string(hash) + " is not stored");
  }

  Result<void> check_revision(const std::string& what, Revision revision) const {
    if (revision <= disk_->revision) return check_kept(what, revision, disk_->floor);
    return fail(ErrorCode::not_found, "the map has no revision " + std::to_string(revision.value) +
                                          "; its newest is " + std::to_string(disk_->revision.value));
  }

  std::shared_ptr<MemoryDisk> disk_;
  std::unique_ptr<ContentCoder> coder_ = std::make_unique<ContentCoder>();
  Epoch epoch_;
};

}  // namespace

const std::vector<Place>* known_anew(const MemoryDisk::Step& step) {
  if (const auto* const batch = std::get_if<Batch>(&step.change)) return &batch->learned;
  if (const auto* const put = std::get_if<PutPlaces>(&step.change)) return &put->places;
  return nullptr;
}

std::unique_ptr<MapStore> make_memory_store(std::shared_ptr<MemoryDisk> disk) {
  return std::make_unique<MemoryStore>(std::move(disk));
}

}  // namespace weft::storage
