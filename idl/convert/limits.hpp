#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/protocol/messages.hpp"

/// Holds the bounds that from_idl puts on every message, besides those in core/protocol.
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

struct Bound {
  std::string_view what;
  std::uint64_t most;
};
/// Lists the bounds that docs/wire.md shows.
inline constexpr Bound kBounds[] = {
    {"data of a chunk, bytes", msg::kChunkBytes},
    {"load of an echo, bytes", msg::kEchoBytes},
    {"a content or cloud, bytes", msg::kContentBytes},
    {"places, edges and removals in one part of a patch", msg::kPatchEntities},
    {"labels in one part of a patch", kLabels},
    {"places in a batch", kBatchPlaces},
    {"edges in a batch", kBatchEdges},
    {"hashes in an acknowledgement or a request", kHashes},
    {"numbers of a signature of what is seen", msg::kSignatureNumbers},
    {"places proposed for a signature", msg::kRecognisedPlaces},
    {"places known already when others are asked for", msg::kRecognisedRank},
    {"stretches in a report on what was taught", msg::kReportRows},
    {"conditions in each of them", msg::kReportConditions},
    {"places of a route", kRoutePlaces},
    {"speed limits of a route", kRouteLimits},
    {"spans of a rule", kRuleSpans},
    {"corners of a rule's area", kMostCorners},
    {"registered plans of a map", kMostRegistrations},
    {"picks of a registered plan", kMostPicks},
    {"points of a line to teach along", kLinePoints},
    {"hops of a window", kHops},
    {"places of a window", kWindowCap},
    {"parts of a patch or an answer", kParts},
    {"robots, goals or routes in one part of an answer", kRows},
    {"events in one part of an answer", kEvents},
    {"events in a goal's history", kHistory},
    {"counters in an answer", kCounters},
    {"methods of a robot", kMethods},
    {"cameras of a robot", kCameras},
    {"diagnostics of a robot", kDiagnostics},
    {"names and labels, bytes", kNameLength},
    {"reasons and other sentences, bytes", kTextLength},
    {"a camera's calibration, bytes", kCalibrationLength},
    {"a header's signature, bytes", kSignatureBytes},
    {"answers in a server's hello", msg::kAnswers},
};

}  // namespace weft::convert
