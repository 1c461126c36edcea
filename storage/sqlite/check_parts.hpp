#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "storage/sqlite/parts.hpp"

namespace weft::storage::sqlite {

using Findings = std::vector<std::string>;

/// One table's part of a check.
class CheckPart {
 public:
  virtual ~CheckPart() = default;
  /// A bounded piece. True: there may be more.
  virtual Result<bool> step(Findings& findings) = 0;
  /// Rows so far; edges count by the places that they start from.
  virtual std::uint64_t done() const = 0;
};
using CheckParts = std::vector<std::unique_ptr<CheckPart>>;

/// Contents: bytes decode to their hash. Damaged ones are quarantined.
Result<void> add_content_checks(Parts& parts, CheckParts& to);
/// Places, edges, labels, and what was moved: checksums, and that what they name exists.
Result<void> add_map_checks(const Parts& parts, CheckParts& to);
/// Experiences, batches and revisions without a gap; goals, routes, occupancies, passes.
Result<void> add_record_checks(const Parts& parts, CheckParts& to);

}  // namespace weft::storage::sqlite
