#pragma once
#include <optional>
#include <string>

#include "agents/agent/experience_ids.hpp"
#include "agents/agent/map_window.hpp"
#include "agents/agent/replies.hpp"
#include "agents/agent/spooler.hpp"
#include "agents/navigation/navigator.hpp"

namespace weft::agents {

/// Keeps a place that somebody wants to name where the robot stands, without its being taught.
class KeepPlaceMission {
 public:
  struct Uses {
    const AgentConfig& config;
    Navigator& navigator;
    MapWindow& map;
    Spooler& spooler;
    ExperienceIds& ids;
    Replies& replies;
  };
  explicit KeepPlaceMission(const Uses& uses) : uses_(uses) {}

  /// Answers with the place on which the robot stands, or else waits for a view that can be joined to the map.
  void start(const msg::AgentCommand& command, const CommandKey& key, bool is_lost, SteadyTime now);
  /// Tries with the newest view; if it does not do, the next one may, until the deadline.
  void on_view(SteadyTime now);
  void tick(SteadyTime now);

  bool is_active() const { return wanted_.has_value(); }
  std::optional<SteadyTime> next() const;
  void was_away(Duration away);

 private:
  struct Wanted {
    CommandKey asked_by;
    std::string name;
    SteadyTime deadline{};
    std::string refused = "no image came";  ///< by the last view
  };
  Result<void> hand_in(const TeachStart& start, const Kept& kept, const std::string& name, SteadyTime now);

  Uses uses_;
  std::optional<Wanted> wanted_;
};

}  // namespace weft::agents
