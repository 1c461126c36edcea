#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agents/bodies/body.hpp"
#include "agents/navigation/navigator.hpp"
#include "core/protocol/messages.hpp"
#include "core/random.hpp"
#include "core/result.hpp"
#include "core/time.hpp"
#include "storage/spool.hpp"

namespace weft::agents {

struct AgentConfig {
  RobotId self;
  std::uint64_t incarnation = 0;
  std::string name;  ///< as check_name wants it
  std::string software;
  std::string vendor;
  std::string body;
  bool can_be_taught_along = false;
  std::vector<msg::Camera> cameras;
  double footprint_radius_m = 0.4;  ///< (0, 5]; what others keep clear of around the places that it holds
  std::uint32_t window_hops = 25;
  std::uint32_t window_cap = 2000;
  std::uint64_t content_cache_bytes = 256ULL << 20U;
  std::uint64_t bytes_per_second = 4ULL << 20U;  ///< budget for bulk in each direction
};

/// Describes a fix that the agent made, for files of record (deploy/demo, tests/judge).
struct FixRecord {
  std::uint64_t frame = 0;
  Fix fix;
};

/// Describes a batch that the server has on disk.
struct AckRecord {
  ExperienceId experience;
  std::uint64_t sequence = 0;
  std::uint32_t first = 0;   ///< index of its first place
  std::uint32_t places = 0;  ///< how many; a batch that only seals has none
};

struct AgentOutput {
  Twist command;  ///< in force from now on, whichever call it came from
  std::vector<msg::Message> send;
  std::optional<ExposureWish> exposes;               ///< for the body
  std::optional<std::vector<SitePoint>> hand_start;  ///< the body's hand is to drive this
  bool hand_stop = false;
  std::vector<FixRecord> fixes;
  std::vector<AckRecord> acks;     ///< newly acknowledged
  std::vector<std::string> notes;  ///< for the log: what changed and why
};

/// Holds how an agent is, in numbers, at one moment.
struct AgentFigures {
  msg::RobotState state;  ///< without a header
  Epoch epoch;            ///< of its server; 0: none was heard
  std::size_t window_places = 0;
  std::map<std::string, std::uint64_t> counters;
};

/// Describes one robot's agent without its edges: session with the server, spool, window and contents, mission. No
/// clock, thread or socket. `step` runs on the body's samples, `handle` and `tick` on the process's steady clock.
class Agent {
 public:
  virtual ~Agent() = default;
  virtual AgentOutput handle(const msg::Message& message, SteadyTime now, WallTime wall) = 0;
  virtual AgentOutput tick(SteadyTime now) = 0;
  virtual std::optional<SteadyTime> next_tick() const = 0;
  /// Takes note that the process was away for so long until now. To be called before what has come in meanwhile is
  /// handled: no wait for the server's answer or for a view counts that time.
  virtual void was_away(Duration away, SteadyTime now) = 0;
  virtual AgentOutput step(const Sample& sample, SteadyTime now) = 0;
  /// Takes note that the body broke down (its error): stands, says so, refuses goals.
  virtual AgentOutput body_failed(const Error& error, SteadyTime now) = 0;
  /// Says its last word, as the process is being ended, so that nobody waits for it.
  virtual AgentOutput leave(SteadyTime now) = 0;
  /// Takes note of whether a hand's request could be carried out.
  virtual AgentOutput hand_answered(const Result<void>& answer, SteadyTime now) = 0;

  /// Returns the window that the agent holds; like the two below for invariants and records.
  virtual const Window& window() const = 0;
  virtual std::optional<Route> route() const = 0;
  virtual std::optional<Estimate> estimate() const = 0;
  /// Returns how often messages were refused or ignored, and the navigator's fixes and refusals, by name.
  virtual std::map<std::string, std::uint64_t> counters() const = 0;
  /// Returns what driving has shown of the robot beside where it is (its camera's mount); empty: nothing yet.
  virtual std::vector<Diagnostic> diagnostics() const { return {}; }
  /// Returns why the agent cannot do a part of its work, for health probes; empty: it can.
  virtual std::string trouble() const { return {}; }
  /// Returns how the agent is, for whoever watches it.
  virtual AgentFigures figures(SteadyTime /*now*/) const { return {}; }
};

/// Starts an agent: reads the spool and sends again what is pending. invalid: a setting breaks its bound; errors of
/// the spool are passed on.
Result<std::unique_ptr<Agent>> start(const AgentConfig& config, std::unique_ptr<Navigator> navigator,
                                     storage::Spool& spool, Random random, SteadyTime now);

}  // namespace weft::agents
