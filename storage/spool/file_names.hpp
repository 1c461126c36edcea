#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace weft::storage {

inline constexpr std::size_t kFileDigits = 16;
/// Returns "<16 hex digits><ending>", the name of a spool's file.
std::string numbered(std::uint64_t order, std::string_view ending);
/// Returns the number of such a name; none: it is another one's.
std::optional<std::uint64_t> number_of(std::string_view name, std::string_view ending);

inline constexpr std::string_view kBatchEnding = ".batch";
inline constexpr std::string_view kStagedEnding = ".batch.new";  ///< written, and not yet decided upon
inline constexpr std::string_view kReplacementFile = "replace";

}  // namespace weft::storage
