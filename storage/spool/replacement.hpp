#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/bytes.hpp"
#include "core/result.hpp"

namespace weft::storage {

/// Says which of a spool's files take the place of which, by the numbers in their names.
struct Replacement {
  std::vector<std::uint64_t> removed;
  std::vector<std::uint64_t> added;
};

/// Returns "<16 hex digits><ending>", the name of a spool's file.
std::string numbered(std::uint64_t order, std::string_view ending);
/// Returns the number of such a name; none: it is another one's.
std::optional<std::uint64_t> number_of(std::string_view name, std::string_view ending);

inline constexpr std::string_view kBatchEnding = ".batch";
inline constexpr std::string_view kStagedEnding = ".batch.new";  ///< written, and not yet decided upon
inline constexpr std::string_view kReplacementFile = "replace";

/// Writes and reads the file that decides (docs/formats/spool.md). corrupt: no such file, or damaged; newer: of a
/// later format.
Bytes encode(const Replacement& replacement);
Result<Replacement> decode_replacement(ByteView bytes);

/// Gives staged files their names, removes those that they replace, then the file that decided; goes on where it was
/// interrupted. unavailable: the directory cannot be written.
Result<void> carry_out(const std::filesystem::path& directory, const Replacement& replacement);

}  // namespace weft::storage
