#pragma once
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/result.hpp"
#include "core/time.hpp"

namespace weft::process {

inline constexpr Duration kBetweenBeats = std::chrono::seconds(1);  ///< at most, of a main loop that turns
inline constexpr Duration kHungAfter = std::chrono::seconds(10);    ///< without a beat a process counts as hung
inline constexpr std::size_t kHealthBytes = 512;  ///< of every record, so that it is overwritten in place

/// Describes how a process was when its main loop turned last, in its own words (docs/formats/small-files.md).
struct Health {
  std::string program;       ///< without spaces
  std::int64_t process = 0;  ///< id, as the process itself sees it
  SteadyTime beat{};         ///< when its main loop turned last; of one that starts: when it said what it does
  bool is_starting = false;
  std::string trouble;  ///< why it does not do its work, or what it does to start; empty: it works
};

/// Returns the record, kHealthBytes long; a trouble that does not fit is cut.
std::string health_text(const Health& health);
/// Reads a record. corrupt: it is none; says what was there.
Result<Health> parse_health(std::string_view text);

/// Tells whether a process is healthy, and why, in words for one line.
struct Verdict {
  bool healthy = false;
  std::string why;
};

/// Judges the record of a process that lives, at a moment of this machine's monotonic clock.
Verdict judge(const Health& health, SteadyTime now);

}  // namespace weft::process
