#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/network/network.hpp"
#include "core/network/removal.hpp"
#include "core/result.hpp"
#include "storage/sqlite/database.hpp"

namespace weft::storage::sqlite {

/// Asks the tables single questions, for jobs. What is remembered between two questions is forgotten by `forget`,
/// which is due whenever others may have written.
class Lookup {
 public:
  static Result<Lookup> make(const Database& database);

  Result<bool> has_place(const PlaceId& id) const;
  /// Returns whether a place was deleted for good: docs/formats/store.md, deleted_places.
  Result<bool> is_deleted(const PlaceId& id);
  /// Returns the stretches of an experience that were deleted for good, in the order of places.
  Result<const std::vector<Stretch>*> deleted_of(ExperienceId id);
  Result<bool> has_edge(const EdgeId& id) const;
  /// Returns whether a content has a row. Quarantined ones are there too.
  Result<bool> has_content(const ContentHash& hash) const;
  struct ExperienceRow {
    std::uint64_t places = 0;
    std::uint64_t durable_through = 0;
  };
  Result<std::optional<ExperienceRow>> experience(ExperienceId id) const;
  /// Returns the last index that has a row.
  Result<std::optional<std::uint64_t>> last_place(ExperienceId id) const;
  Result<std::uint64_t> last_batch(ExperienceId id) const;

  void forget() { deleted_of_.reset(); }

 private:
  Statement place_, deleted_, edge_, content_, experience_, last_place_, last_batch_;
  std::optional<ExperienceId> deleted_of_;
  std::vector<Stretch> stretches_;
};

}  // namespace weft::storage::sqlite
