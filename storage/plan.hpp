#pragma once
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "storage/map_store.hpp"

/// Decides what every engine decides in the same way: whether a transaction fits what is stored, and which of its
/// changes are new. Pure: the engine looks up `Needs`, hands over `Facts`, and writes what the `Plan` calls fresh.
namespace weft::storage {

using BatchKey = std::pair<ExperienceId, std::uint64_t>;

/// Lists the keys that must be looked up in the store to judge a transaction, besides its revision.
struct Needs {
  std::set<ExperienceId> experiences;
  std::set<BatchKey> batches;
  std::set<ContentHash> contents;
  std::set<ExperienceId> moved_in;  ///< what labels and removals name
  std::set<EdgeId> stitches;        ///< that go out or come back
};
Needs needs_of(const Transaction& transaction);

struct ExperienceFacts {
  std::uint64_t durable_through = 0;
  std::uint64_t places = 0;
};

/// Holds the facts that are stored of what was needed; absent means not stored.
struct Facts {
  Revision revision;
  std::map<ExperienceId, ExperienceFacts> experiences;
  std::map<BatchKey, ContentHash> batches;
  std::set<ContentHash> contents;  ///< without quarantined ones
  std::set<EdgeId> stitches;
  std::map<ExperienceId, std::vector<Stretch>> deleted;  ///< places that a compaction took for good
  Revision floor;                                        ///< the oldest revision that is kept
};

struct Plan {
  std::vector<bool> fresh;                              ///< one a change; false: already there, nothing to write
  bool changes_network = false;                         ///< one revision on
  std::map<ExperienceId, ExperienceFacts> experiences;  ///< after the transaction
};

/// Returns the plan for a transaction. invalid: a content's bytes are not its hash's, a batch has sequence 0 or
/// places that are not of its experience. conflict: a batch out of order or repeated with another hash, places that
/// do not continue the experience, a content that is neither stored nor in the transaction, a label, apart, rule,
/// registration, seal, removal or new knowledge of something that is not stored, or was deleted for good. not_found:
/// a rollback to an older revision than is kept.
Result<Plan> make_plan(const Transaction& transaction, const Facts& facts);

/// Checks that a map is kept. not_found: one of that revision cannot be seen any more; `what` asks for it.
Result<void> check_kept(const std::string& what, Revision revision, Revision floor);

/// Checks that a revision's changes are kept. not_found: the map before it, and so what it changed, is not known any
/// more.
Result<void> check_changes_kept(Revision revision, Revision floor);

/// Returns the note of the revision that the transaction makes after `newest`: its own, or one made from its changes.
RevisionNote note_of(const Transaction& transaction, Revision newest);

}  // namespace weft::storage
