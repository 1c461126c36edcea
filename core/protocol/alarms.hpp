#pragma once
#include <chrono>
#include <cstdint>
#include <span>
#include <string>

#include "core/ids.hpp"
#include "core/time.hpp"

/// Holds what can be wrong with a fleet right now, and what people are told of it.
namespace weft::msg {

inline constexpr std::uint64_t kDiskLowBytes = 1ULL << 30U;  ///< free at the server: below that it is an alarm
inline constexpr double kClockOff_s = 1.0;                   ///< a robot's clock, ahead of the server's or behind
/// A robot that is heard has heard nothing for so long: less than the 5 s after which DDS gives up who is not heard,
/// and more than a greeting that is late.
inline constexpr double kDeaf_s = 3.5;
inline constexpr Duration kRefusedLately = std::chrono::minutes(10);  ///< a refused message is an alarm for so long

/// Says what is wrong. The numbers go on the wire.
enum class AlarmKind : std::uint8_t {
  silent = 1,
  lost = 2,
  faulted = 3,
  blocked = 4,
  safety_stop = 5,
  standstill = 6,
  twins = 7,
  spool = 8,
  clock = 9,
  store = 10,
  disk = 11,
  refused = 12,
  unjoined = 13,
  deaf = 14
};

/// Describes something that is wrong now.
struct Alarm {
  AlarmKind kind = AlarmKind::silent;
  RobotId robot;       ///< none: it is the server's
  std::string about;   ///< the robot's name, or "server"
  PlaceId place;       ///< where the robot is, as far as known; none: not known, or of no place
  WallTime since{};    ///< or since when the server knows of it
  std::string detail;  ///< what exactly: numbers, reasons, names
};

/// Holds what people are told of a kind of alarm, besides the detail.
struct AlarmText {
  AlarmKind kind;
  const char* name;   ///< one word, for scripts
  const char* cause;  ///< what it means, and where it mostly comes from
  const char* cure;   ///< what to do
};

/// Returns the texts of all kinds, in the order of their numbers. docs/operating.md repeats them.
std::span<const AlarmText> alarm_texts();
const AlarmText& text_of(AlarmKind kind);

}  // namespace weft::msg
