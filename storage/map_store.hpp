#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "core/bytes.hpp"
#include "core/network/apart.hpp"
#include "core/network/change.hpp"
#include "core/network/goal.hpp"
#include "core/network/network.hpp"
#include "core/network/passes.hpp"
#include "core/network/registration.hpp"
#include "core/network/removal.hpp"
#include "core/network/rule.hpp"
#include "core/protocol/messages.hpp"
#include "core/result.hpp"
#include "storage/events.hpp"
#include "storage/maintenance.hpp"

namespace weft::storage {

struct PutContent {
  ContentHash hash;
  msg::ContentKind kind = msg::ContentKind::content;
  Bytes bytes;
};
struct AppendBatch {
  Batch batch;
  ContentHash hash;
};
/// Puts places that the map has, as they are known from now on; each replaces what was known of it.
struct PutPlaces {
  std::vector<Place> places;
};
/// Puts a label on a place. A place of no experience: the label goes.
struct PutLabel {
  std::string label;
  PlaceId place;
};
/// Notes that an operator vouches that two stretches are different floors, or no longer.
struct PutApart {
  Apart apart;
  bool holds = true;
};
/// Lays down a rule, in the place of an earlier rule of its name, or no longer: then only the name counts.
struct PutRule {
  Rule rule;
  bool holds = true;
};
/// Registers a floor plan, in the place of an earlier registration of its name, or no longer: then only the name
/// counts.
struct PutRegistration {
  Registration registration;
  bool holds = true;
};
struct SealExperience {
  ExperienceId experience;
  std::string reason;
};
/// Takes things out of the map; nothing is deleted.
struct TakeOut {
  Removal what;
};
/// Brings what was taken out into the map again.
struct BringBack {
  Removal what;
};
/// Restores the map as it was at a revision. What was taken for durable since stays stored, outside the map.
struct RollBack {
  Revision to;
};
struct PutGoal {
  Goal goal;
};
struct PutRoute {
  Route route;
};  ///< the latest route of its goal
/// Stores a stretch that a robot holds, so that a restarted server does not give it away. Empty places: freed.
struct PutOccupancy {
  RobotId robot;
  Route held;
  std::uint32_t from = 0;
  std::uint32_t to = 0;
};
struct PutRobot {
  RobotId robot;
  std::string name;
};
/// Notes the operator who holds the robot; empty: it is held no longer.
struct PutHold {
  RobotId robot;
  std::string who;
};
/// Notes that a place gets the label once its robot has handed it in, in place of what waited under that label. A
/// place of no experience: nothing waits under it any longer; then only the label counts. Makes no revision.
struct PutAwaitedLabel {
  std::string label;
  PlaceId place{};
  RobotId robot{};            ///< that has kept the place
  PeerId asker{};             ///< the client that is answered
  std::uint64_t request = 0;  ///< the number that it gave
  std::string who{};          ///< its name

  friend bool operator==(const PutAwaitedLabel&, const PutAwaitedLabel&) = default;
};
/// Stores the latest passes of a piece of a run, in the place of the earlier ones. At least one, up to kPassesKept.
/// Makes no revision.
struct PutPasses {
  RunPiece piece;
  std::vector<Pass> passes;
};
struct PutEvent {
  msg::Event event;
};
/// Stores what routing has worked out of the map for one set of methods; replaces the earlier one of the same
/// methods. Up to kLargestPreparation bytes. Makes no revision.
struct PutPreparation {
  std::string methods;
  Bytes bytes;
};
inline constexpr std::uint64_t kLargestPreparation = 512ULL << 20U;

using RevisionNote = msg::RevisionNote;

/// Describes one atomic step. Batches, labels, aparts, rules, registrations, seals and what goes out and comes back
/// change the network: together they make one revision, whose note is `note` or, when that has no kind, made from the
/// changes. A rollback is alone in its step.
struct Transaction {
  std::vector<std::variant<PutContent, AppendBatch, PutPlaces, PutLabel, PutApart, PutRule, PutRegistration,
                           SealExperience, TakeOut, BringBack, RollBack, PutGoal, PutRoute, PutOccupancy, PutRobot,
                           PutHold, PutEvent, PutPreparation, PutPasses, PutAwaitedLabel>>
      changes;
  RevisionNote note{};  ///< the store sets revision and base
};

/// Lists the changes of one revision, so that it can be undone.
struct RevisionChanges {
  RevisionNote note;
  Removal added;  ///< by batches
  Removal taken_out;
  Removal brought_back;
  std::vector<Place> known_anew;        ///< places that it had as they were learned
  std::set<std::string> labels;         ///< that it set, or took away
  std::set<Apart> aparts;               ///< that it vouched for, or did no longer
  std::set<std::string> rules;          ///< by name, that it laid down, or took away
  std::set<std::string> registrations;  ///< by their plans, the same
};

/// Holds everything a server needs to resume. Contents stay on disk.
struct Stored {
  Epoch epoch;  ///< of this opening: one more than the last
  Snapshot snapshot;
  std::map<ExperienceId, std::uint64_t> durable_through;
  std::map<GoalId, Goal> goals;
  std::map<GoalId, Route> routes;
  std::map<RobotId, PutOccupancy> occupancies;
  std::map<RobotId, std::string> robots;
  std::map<RobotId, std::string> holds;  ///< who holds the robot
  std::map<std::string, PutAwaitedLabel> awaited_labels;
  std::map<RunPiece, std::vector<Pass>> passes;
  std::vector<std::string> quarantined;  ///< what was damaged and is not served, each named
};

/// Holds a content as an engine keeps it, which is how it travels.
struct StoredContent {
  msg::Coding coding = msg::Coding::raw;
  std::uint64_t size = 0;  ///< of the content itself
  Bytes bytes;             ///< coded; what they decode to has the content's hash
};

struct Commit {
  Revision revision;
};

struct StoreSize {
  std::uint64_t contents = 0;
  std::uint64_t content_bytes = 0;
  std::uint64_t disk_free_bytes = 0;
  Revision floor;  ///< the oldest revision that is kept; 0: all are
};

/// Keeps the fleet's map on disk. One writer process; calls come from one thread.
/// Every engine passes tests/contract/map_store.
class MapStore {
 public:
  virtual ~MapStore() = default;
  /// Takes the next epoch and loads. Called once, first.
  virtual Result<Stored> open() = 0;
  /// Commits a transaction: durable when it returns; on an error nothing of it is there. stale: another server has
  /// opened the store since. exhausted: disk full. conflict: the batch has another sequence than is due or another
  /// hash than it was committed with, or the transaction names a content or place that is neither stored nor in it.
  virtual Result<Commit> commit(const Transaction& transaction) = 0;
  virtual bool has_content(const ContentHash& hash) const = 0;
  /// Returns a content expanded, its SHA-256 verified. not_found; corrupt: quarantined, named.
  virtual Result<Bytes> content(const ContentHash& hash) const = 0;
  /// Returns a content as it is kept. Damage on the disk is found by the engine's own checksum, much faster; who
  /// expands it verifies the SHA-256. Errors as `content`.
  virtual Result<StoredContent> stored_content(const ContentHash& hash) const = 0;
  /// Returns the hash with which that batch was committed; none if it was not.
  virtual std::optional<ContentHash> batch_hash(ExperienceId experience, std::uint64_t sequence) const = 0;
  /// Returns the newest `limit` events that fit, newest last; with a number or a time in the filter, the first that
  /// fit behind it.
  virtual Result<EventPage> events(const EventFilter& filter, std::size_t limit) const = 0;
  /// Returns the map as it was then. `near` is the map at another revision: what is the same in both is shared with
  /// it and not read, so that going a little back in a large map is cheap. An empty one: everything is read.
  /// not_found: no such revision, or older than what is kept (StoreSize::floor).
  virtual Result<Snapshot> snapshot_at(Revision revision, const Snapshot& near) const = 0;
  /// Returns the notes of revisions, newest first, from `newest` on (0: from the latest), at most `limit`, down to
  /// the oldest that is kept. not_found: `newest` is older than that.
  virtual Result<std::vector<RevisionNote>> log(Revision newest, std::size_t limit) const = 0;
  /// Returns when the first batch of each experience was committed, as far as that revision is kept and its time is
  /// known.
  virtual Result<std::map<ExperienceId, WallTime>> begun() const = 0;
  /// Returns what a revision changed. not_found: no such revision, or not later than the oldest that is kept.
  virtual Result<RevisionChanges> changes_of(Revision revision) const = 0;
  /// Returns the preparation for these methods. not_found: none was put. corrupt: damaged; it must be made anew.
  virtual Result<Bytes> preparation(const std::string& methods) const = 0;

  /// Reads everything that is stored, checksums and references, and names each damaged row or content. Damaged
  /// contents are quarantined, as `content` does. Memory is bounded.
  virtual Result<std::unique_ptr<StoreJob>> check() = 0;
  /// Copies the store, as it is when the job ends, to a file of its own; commits between the steps are carried along.
  /// conflict: the file exists. refused: the engine has no file. exhausted, unavailable: the disk; nothing is left
  /// there.
  virtual Result<std::unique_ptr<StoreJob>> snapshot_to(const std::filesystem::path& file) = 0;
  /// Restores a snapshot into a folder beside it, checks all of it, and compares it with `live`, the map of that
  /// revision; the folder goes with the job, whatever becomes of it. Findings: what is damaged, and what differs.
  /// unavailable: the file cannot be read, or the folder not be made; exhausted: the disk has no room for a second
  /// one.
  virtual Result<std::unique_ptr<StoreJob>> verify(const std::filesystem::path& file, const Snapshot& live) = 0;
  /// Deletes for good what is in the map of no revision from `before` on, and gives its space back. `before` becomes
  /// the oldest revision that can be seen and gone back to; of those after it everything can still be undone. What
  /// was taken of a robot once is not taken again. A job that stops half way can be begun again with the same
  /// `before`. not_found: no such revision, or older than what is kept. unavailable: another one is under way.
  virtual Result<std::unique_ptr<StoreJob>> compact(Revision before) = 0;
  /// Begins to count which things take how much space; the result is in the last progress's `space`.
  virtual Result<std::unique_ptr<StoreJob>> stats() = 0;
  virtual StoreSize size() const = 0;
  virtual std::string engine() const = 0;
};

}  // namespace weft::storage
