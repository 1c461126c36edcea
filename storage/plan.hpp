#pragma once
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "storage/map_store.hpp"

/// What every engine decides in the same way: whether a transaction fits what is stored, and which of its changes are
/// new. Pure: the engine looks up `Needs`, hands over `Facts`, and writes what the `Plan` calls fresh.
namespace weft::storage {

using BatchKey = std::pair<ExperienceId, std::uint64_t>;

/// What must be known about the store to judge a transaction, besides its revision.
struct Needs {
  std::set<ExperienceId> experiences;
  std::set<BatchKey> batches;
  std::set<ContentHash> contents;
};
Needs needs_of(const Transaction& transaction);

struct ExperienceFacts {
  std::uint64_t durable_through = 0;
  std::uint64_t places = 0;
};

/// What is stored of what was needed; absent means not stored.
struct Facts {
  Revision revision;
  std::map<ExperienceId, ExperienceFacts> experiences;
  std::map<BatchKey, ContentHash> batches;
  std::set<ContentHash> contents;  ///< without quarantined ones
};

struct Plan {
  std::vector<bool> fresh;                              ///< one a change; false: already there, nothing to write
  bool changes_network = false;                         ///< one revision on
  std::map<ExperienceId, ExperienceFacts> experiences;  ///< after the transaction
};

/// invalid: a content's bytes are not its hash's, a batch has sequence 0 or places that are not of its experience.
/// conflict: a batch out of order or repeated with another hash, places that do not continue the experience, a
/// content that is neither stored nor in the transaction, a label or seal of something that is not stored.
Result<Plan> make_plan(const Transaction& transaction, const Facts& facts);

/// The note of the revision that the transaction makes after `newest`: its own, or one made from its changes.
RevisionNote note_of(const Transaction& transaction, Revision newest);

}  // namespace weft::storage
