#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "agents/agent/agent.hpp"
#include "agents/agent/metrics/agent_metrics.hpp"
#include "agents/agent/process/records.hpp"
#include "agents/bodies/body.hpp"
#include "idl/bus/link.hpp"
#include "process/log.hpp"
#include "process/metrics/metrics_server.hpp"
#include "process/metrics/program_metrics.hpp"
#include "process/vitals.hpp"

namespace weft::agents {

/// Carries samples from the body and messages from the bus to the agent, and what it wants back, all in the caller's
/// thread. A step of the body is taken when the last one's sensor time has come at the given pace: a slow machine
/// makes a slow simulation, never a lost sample.
class Loop {
 public:
  struct Parts {
    Agent& agent;
    Body& body;
    bus::Link& link;
    Records* records = nullptr;  ///< null: none are kept
    process::Log& log;
    std::string server = {};                    ///< where it is looked for, in words
    process::Vitals* vitals = nullptr;          ///< null: nobody is shown that it turns
    process::MetricsServer* metrics = nullptr;  ///< null: none are served
    process::ProgramFigures figures = {};       ///< with what its metrics begin
  };
  /// Prepares a loop. `pace`: sensor seconds a second at most; 0: no bound.
  Loop(const Parts& parts, double pace);

  /// Runs until `stop` returns true. corrupt: the body gave damaged data; exhausted: records could not be written.
  /// Said at the end too, so that whoever started this hears of it.
  Result<void> until(const std::function<bool()>& stop);

 private:
  void take_messages();
  void catch_up();
  bool note_absence(Duration meant);
  void step();
  void schedule(SensorTime sample);
  void note(const AgentOutput& output);
  void perform(AgentOutput output);
  void expose(const ExposureWish& wish);
  void log_counters();
  void log_silence();
  void show_life();
  void publish_metrics(SteadyTime now, const std::string& trouble);
  std::string trouble() const;
  std::vector<process::LogField> goal() const;
  std::vector<process::LogField> goal_of_notes();

  Parts parts_;
  double pace_;
  Twist command_;
  std::uint64_t frame_ = 0;
  std::optional<Error> body_failure_;
  bool has_refused_exposure_ = false;  // is logged once
  std::optional<Error> damage_;
  struct Anchor {
    SteadyTime steady;
    SensorTime sensor;
  };
  std::optional<Anchor> anchor_;
  SteadyTime looked_;  // when the inbox was last looked at
  SteadyTime step_at_;
  SteadyTime counters_at_;
  SteadyTime silent_at_;  // when it is said that no server is heard
  SteadyTime heard_at_;   // when the server was last heard
  SteadyTime published_at_;
  DriveFigures drive_;
  std::map<std::string, std::uint64_t> counted_;
  std::string measured_;                        // as it was logged last
  std::vector<process::LogField> goal_before_;  // when the agent was last called
};

}  // namespace weft::agents
