#pragma once
#include <cstddef>
#include <cstdint>

/// The bounds that from_idl holds every message to, besides those of core/protocol/messages.hpp. docs/wire.md lists
/// them from here.
namespace weft::convert {

inline constexpr std::size_t kSignatureBytes = 64;
inline constexpr std::size_t kNameLength = 64;             ///< names, labels, methods, bodies, vendors, software
inline constexpr std::size_t kTextLength = 2048;           ///< reasons, causes and other sentences for people
inline constexpr std::size_t kCalibrationLength = 16'384;  ///< a camera's calibration as text
inline constexpr std::size_t kMethods = 16;
inline constexpr std::size_t kDiagnostics = 16;
inline constexpr std::size_t kCameras = 16;
inline constexpr std::size_t kHashes = 4096;  ///< missing contents, requested contents
inline constexpr std::size_t kRoutePlaces = 10'000;
inline constexpr std::size_t kLinePoints = 10'000;  ///< the polyline of a hand
inline constexpr std::size_t kLabels = 10'000;
inline constexpr std::size_t kRows = 1000;  ///< robots, goals, routes in one part of an answer
inline constexpr std::size_t kEvents = 10'000;
inline constexpr std::size_t kRemoved = 1000;  ///< stretches and stitches that one edit of the map names
inline constexpr std::size_t kFindings = 100;  ///< of a check, in one reply
inline constexpr std::size_t kFileLength = 1024;
inline constexpr double kWithin_m = 10.0;
inline constexpr double kWithin_rad = 3.15;
inline constexpr std::size_t kHistory = 1000;  ///< events of one goal
inline constexpr std::size_t kCounters = 1000;
inline constexpr std::uint32_t kParts = 100'000;
inline constexpr std::uint32_t kHops = 1'000'000;
inline constexpr std::uint32_t kWindowCap = 1'000'000;

}  // namespace weft::convert
