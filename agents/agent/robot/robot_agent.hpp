#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agents/agent/agent.hpp"
#include "agents/agent/condition.hpp"
#include "agents/agent/diagnostic_watch.hpp"
#include "agents/agent/experience_ids.hpp"
#include "agents/agent/map_window.hpp"
#include "agents/agent/missions/follow_mission.hpp"
#include "agents/agent/missions/keep_place_mission.hpp"
#include "agents/agent/missions/localise_mission.hpp"
#include "agents/agent/missions/teach_mission.hpp"
#include "agents/agent/outbox.hpp"
#include "agents/agent/place_learning.hpp"
#include "agents/agent/power_reporter.hpp"
#include "agents/agent/recogniser.hpp"
#include "agents/agent/replies.hpp"
#include "agents/agent/session.hpp"
#include "agents/agent/spool_watch.hpp"
#include "agents/agent/spooler.hpp"
#include "agents/agent/standing.hpp"
#include "agents/agent/state_reporter.hpp"
#include "agents/agent/stop_memory.hpp"
#include "agents/agent/upload.hpp"

namespace weft::agents {

/// Puts the agent together from its parts and missions. Decides nothing itself: what comes in goes to the part that
/// it concerns, what one of them returns goes to the others, and after each call everything that is due goes out,
/// small before big.
class RobotAgent final : public Agent {
 public:
  /// Begins with a spooler that writes through `spool`.
  RobotAgent(const AgentConfig& config, std::unique_ptr<Navigator> navigator, std::unique_ptr<SpoolWatch> spool,
             Spooler spooler, Random random, SteadyTime now);

  AgentOutput handle(const msg::Message& message, SteadyTime now, WallTime wall) override;
  AgentOutput tick(SteadyTime now) override;
  std::optional<SteadyTime> next_tick() const override;
  void was_away(Duration away, SteadyTime now) override;
  AgentOutput step(const Sample& sample, SteadyTime now) override;
  AgentOutput body_failed(const Error& error, SteadyTime now) override;
  AgentOutput leave(SteadyTime now) override;
  AgentOutput hand_answered(const Result<void>& answer, SteadyTime now) override;

  const Window& window() const override { return map_.window(); }
  std::optional<Route> route() const override { return follow_.route(); }
  std::optional<Estimate> estimate() const override { return navigator_->estimate(); }
  Counters counters() const override;
  std::vector<Diagnostic> diagnostics() const override;
  std::string trouble() const override;
  AgentFigures figures(SteadyTime now) const override;

 private:
  // Messages (robot_agent_messages.cpp).
  bool admit(const msg::Header& header, const PeerId& to, SteadyTime now);
  void heard(Session::Heard heard, SteadyTime now);
  void on(const msg::Hello& hello, SteadyTime now);
  void on(const msg::BatchAck& ack, SteadyTime now);
  void on(const msg::Chunk& chunk, SteadyTime now);
  void on(const msg::ContentRequest& request, SteadyTime now);
  void on(const msg::WindowPatch& patch, SteadyTime now);
  void on(const msg::RouteOrder& order, SteadyTime now);
  void on(const msg::AgentCommand& command, SteadyTime now);
  void on(const msg::Recognised& answer, SteadyTime now);

  // Commands (robot_agent_commands.cpp).
  void teach_start(const msg::AgentCommand& command, const CommandKey& key, SteadyTime now);
  void keep_place(const msg::AgentCommand& command, const CommandKey& key, SteadyTime now);
  void localise(const msg::AgentCommand& command, const CommandKey& key, SteadyTime now);
  void stop(const CommandKey& key, SteadyTime now);
  void resume(const CommandKey& key, SteadyTime now);
  void report_teaching(const msg::AgentCommand& command, const CommandKey& key);
  void report_counts(const CommandKey& key);

  // Samples (robot_agent_step.cpp).
  void obey(Safety safety, bool has_fix, SteadyTime now);
  void learn(std::vector<LearnedPlace> learned_places, SensorTime seen_at);
  void count(const Navigated& navigated);
  void take_fix(const Fix& fix, SteadyTime now);
  void move_window(SteadyTime now);

  // Work without a message or a sample, and sending (robot_agent.cpp).
  void work(SteadyTime now);
  void search_if_due(SteadyTime now);
  void send_due(SteadyTime now);
  AgentOutput finish(SteadyTime now);
  bool may_drive() const { return !condition_.is_kept_standing() && !condition_.is_faulted() && !teach_.is_active(); }
  MapContext map_context() { return {*navigator_, follow_.route(), teach_.experience()}; }

  // Reports of its own state (robot_agent_state.cpp).
  Standing standing() const;
  msg::RobotState state(SteadyTime now) const;

  /// Says at which times what is said of the robot.
  struct Reports {
    StateReporter state;
    PowerReporter power;
  };

  /// Holds what writes on the robot's own disk, besides the spooler.
  struct Disk {
    std::unique_ptr<SpoolWatch> spool;
    StopMemory stops;
  };

  AgentConfig config_;
  std::unique_ptr<Navigator> navigator_;
  Disk disk_;
  Session session_;
  Outbox outbox_;
  Replies replies_;
  Spooler spooler_;
  Upload upload_;
  MapWindow map_;
  Recogniser recogniser_;
  ExperienceIds ids_;
  Condition condition_;
  PlaceLearning learning_;
  Reports reports_;
  DiagnosticWatches diagnostics_;
  Counters seen_;  ///< fixes, and refusals of the navigator by their reason

  TeachMission teach_;
  LocaliseMission localise_;
  FollowMission follow_;
  KeepPlaceMission keep_place_;
};

}  // namespace weft::agents
