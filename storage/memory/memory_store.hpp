#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "storage/content_coder.hpp"
#include "storage/map_store.hpp"
#include "storage/memory/disk_faults.hpp"
#include "storage/plan.hpp"

namespace weft::storage {

/// Stands in for a disk, in memory; outlives the stores that are opened on it, so that a restarted server finds it
/// again. It is a value: a copy is a backup.
struct MemoryDisk {
  struct Seal {
    ExperienceId experience;
    std::string reason;
  };
  /// Holds a content coded as the engines on disk do it, so that the simulation's agents get what real ones get.
  struct Content {
    msg::ContentKind kind = msg::ContentKind::content;
    Coding coding = Coding::raw;
    std::uint64_t size = 0;  ///< of the content itself
    std::shared_ptr<const Bytes> bytes;
  };

  DiskFaults faults;
  std::uint64_t commits = 0;  ///< that were kept, each a synchronised write of a store on disk

  Epoch epoch;
  Revision revision;
  std::map<ContentHash, Content> contents;
  std::uint64_t content_bytes = 0;
  struct Step {
    Revision revision;
    std::variant<Batch, Seal, PutPlaces, PutLabel, PutApart, PutRule, PutRegistration, TakeOut, BringBack> change;
  };
  std::vector<Step> history;           ///< in order of commit
  std::vector<RevisionNote> notes;     ///< of revision 1, 2, ...
  std::map<Revision, Revision> bases;  ///< of rollbacks
  std::map<BatchKey, ContentHash> batch_hashes;
  std::map<ExperienceId, ExperienceFacts> experiences;
  Revision floor;                                        ///< the oldest that is kept
  std::map<ExperienceId, std::vector<Stretch>> deleted;  ///< by compactions
  std::map<EdgeId, std::uint32_t> edges;                 ///< rows a pair
  std::map<GoalId, Goal> goals;
  std::map<GoalId, Route> routes;
  std::map<RobotId, PutOccupancy> occupancies;
  std::map<RobotId, std::string> robots;
  std::map<RobotId, std::string> holds;
  std::map<std::string, PutAwaitedLabel> awaited_labels;
  std::map<RunPiece, std::vector<Pass>> passes;
  std::vector<msg::Event> events;
  std::map<std::string, std::shared_ptr<const Bytes>> preparations;  ///< by methods
};

/// Returns the places that the step knows anew; null: none.
const std::vector<Place>* known_anew(const MemoryDisk::Step& step);

/// Makes a MapStore for tests and the simulation: as strict as the engines on disk, with faults on demand. A commit
/// costs what it adds.
std::unique_ptr<MapStore> make_memory_store(std::shared_ptr<MemoryDisk> disk);

}  // namespace weft::storage
