#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "storage/sqlite/parts.hpp"

namespace weft::storage::sqlite {

using Findings = std::vector<std::string>;

/// Checks one table.
class CheckPart {
 public:
  virtual ~CheckPart() = default;
  /// Does a bounded piece. Returns true when there may be more.
  virtual Result<bool> step(Findings& findings) = 0;
  /// Returns the rows read so far; edges count by the places that they start from.
  virtual std::uint64_t done() const = 0;
};
using CheckParts = std::vector<std::unique_ptr<CheckPart>>;

/// Adds the checks of contents: bytes decode to their hash. Damaged ones are quarantined.
Result<void> add_content_checks(Parts& parts, CheckParts& to);
/// Adds the checks of places, edges, labels, and what was moved: checksums, and that what they name exists.
Result<void> add_map_checks(const Parts& parts, CheckParts& to);
/// Adds the checks of experiences, batches and revisions without a gap; of goals, routes, occupancies,
/// labels that are awaited, passes.
Result<void> add_record_checks(const Parts& parts, CheckParts& to);

}  // namespace weft::storage::sqlite
