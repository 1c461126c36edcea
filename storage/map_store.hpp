#pragma once
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/bytes.hpp"
#include "core/network/change.hpp"
#include "core/network/goal.hpp"
#include "core/network/network.hpp"
#include "core/protocol/messages.hpp"
#include "core/result.hpp"

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
struct PutLabel {
  std::string label;
  PlaceId place;
};
struct SealExperience {
  ExperienceId experience;
  std::string reason;
};
struct PutGoal {
  Goal goal;
};
struct PutRoute {
  Route route;
};  ///< the latest route of its goal
/// A stretch that a robot holds; kept so that a restarted server does not give it away. Empty places: freed.
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
struct PutEvent {
  msg::Event event;
};

/// One atomic step. Batches, labels and seals change the network: together they make one revision.
struct Transaction {
  std::vector<std::variant<PutContent, AppendBatch, PutLabel, SealExperience, PutGoal, PutRoute, PutOccupancy,
                           PutRobot, PutEvent>>
      changes;
};

/// Everything a server needs to resume. Contents stay on disk.
struct Stored {
  Epoch epoch;  ///< of this opening: one more than the last
  Snapshot snapshot;
  std::map<ExperienceId, std::uint64_t> durable_through;
  std::map<GoalId, Goal> goals;
  std::map<GoalId, Route> routes;
  std::map<RobotId, PutOccupancy> occupancies;
  std::map<RobotId, std::string> robots;
  std::vector<std::string> quarantined;  ///< what was damaged and is not served, each named
};

struct Commit {
  Revision revision;
};

struct StoreSize {
  std::uint64_t contents = 0;
  std::uint64_t content_bytes = 0;
  std::uint64_t disk_free_bytes = 0;
};

/// The fleet's map on disk. One writer process; calls come from one thread.
/// Every engine passes tests/contract/map_store.
class MapStore {
 public:
  virtual ~MapStore() = default;
  /// Takes the next epoch and loads. Called once, first.
  virtual Result<Stored> open() = 0;
  /// Durable when it returns; on an error nothing of it is there.
  /// stale: another server has opened the store since. exhausted: disk full. conflict: batch sequence or hash,
  /// or a content that is neither stored nor in the transaction.
  virtual Result<Commit> commit(const Transaction& transaction) = 0;
  virtual bool has_content(const ContentHash& hash) const = 0;
  /// not_found; corrupt: quarantined, named.
  virtual Result<Bytes> content(const ContentHash& hash) const = 0;
  /// The hash with which that batch was committed; none if it was not.
  virtual std::optional<ContentHash> batch_hash(ExperienceId experience, std::uint64_t sequence) const = 0;
  /// Newest last, at most `limit`; filters that are none take everything.
  virtual Result<std::vector<msg::Event>> events(const GoalId& goal, const RobotId& robot,
                                                 std::size_t limit) const = 0;
  virtual StoreSize size() const = 0;
  virtual std::string engine() const = 0;
};

}  // namespace weft::storage
