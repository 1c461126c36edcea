#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/diagnostic.hpp"
#include "core/network/relation.hpp"
#include "core/protocol/peers.hpp"
#include "core/safety.hpp"

/// Holds what robots say of themselves.
namespace weft::msg {

struct Camera {
  std::string id;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::string calibration;
};

struct RobotDescription {
  Header header;
  std::string name;
  std::string body;                  ///< sim | replay | ...
  std::vector<std::string> methods;  ///< what it can drive
  double footprint_radius_m = 0.4;
  bool can_be_taught_along = false;  ///< a simulated body's hand follows a polyline
  std::vector<Camera> cameras;
  bool knows_limits = false;  ///< keeps to Route::limits; otherwise it is not released where a limit holds
};

enum class RobotMode : std::uint8_t {
  idle = 1,
  teaching = 2,
  driving = 3,
  waiting = 4,
  stopped = 5,
  lost = 6,
  faulted = 7,
  off = 8  ///< the agent's last word: its process was ended
};
const char* to_string(RobotMode mode);

struct RobotState {
  Header header;
  std::string name;
  RobotMode mode = RobotMode::idle;
  bool localised = false;
  PlaceId place;  ///< nearest known; none when not localised
  Relation place_from_robot;
  double blind_m = 0.0;  ///< driven since the last fix
  double speed_m_s = 0.0;
  std::uint64_t frame = 0;
  ExperienceId experience;  ///< being taught; none otherwise
  GoalId goal;
  RouteId route;
  std::uint32_t route_version = 0;
  Revision window_revision;
  Digest window_digest;
  std::uint64_t contents_missing = 0;   ///< of its window
  std::uint64_t memory_bytes = 0;       ///< of contents that it holds
  std::uint64_t memory_cap_bytes = 0;   ///< it never holds more
  std::vector<Diagnostic> diagnostics;  ///< what driving has shown of the robot: its camera's mount
  Safety safety = Safety::ok;           ///< as its base says
  std::uint32_t spool_batches = 0;      ///< taught or learned, and not acknowledged yet
  /// Says what its spool's disk has left; none: not known.
  std::optional<std::uint64_t> spool_free_bytes;
  std::string reason;             ///< why it stands, when it stands
  double server_unheard_s = 0.0;  ///< for so long nothing has come from the server
  double server_gap_s = 0.0;      ///< the longest such time that lasts or has ended within the last minute
  std::string spool_refuses;      ///< why its spool takes nothing at the moment; empty: it does
};

/// Tells what a robot's battery holds; of bodies that know it.
struct RobotPower {
  Header header;
  double share = 0.0;  ///< of full
  bool is_charging = false;
  std::optional<double> minutes;  ///< until it is empty, or full when it charges; none: not known
};

}  // namespace weft::msg
