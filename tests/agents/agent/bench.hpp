#pragma once
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "agents/agent/experience_ids.hpp"
#include "agents/agent/map_window.hpp"
#include "agents/agent/recogniser.hpp"
#include "agents/agent/replies.hpp"
#include "agents/agent/run_refining.hpp"
#include "agents/agent/spooler.hpp"
#include "tests/agents/agent/rig.hpp"

namespace weft::agents::test {

/// Holds everything that missions and parts use, with no agent around it.
class Bench {
 public:
  Bench();

  CommandKey key(std::uint64_t number) const { return {Epoch{1}, number}; }
  MapContext context() { return {*navigator, route, taught}; }
  /// Passes requests to the server and its answers to the map, for five seconds.
  void fetch_map(bool with_contents = true);
  /// Hands over what was put out since the last call.
  AgentOutput take() { return outbox.take(Twist{}); }
  std::vector<msg::AgentReply> replied();
  /// Returns the only reply since the last call; reports a failure when there is another number of them.
  msg::AgentReply only_reply();

  SteadyTime now = SteadyTime{} + std::chrono::hours(1);
  AgentConfig config;
  std::shared_ptr<Script> script = std::make_shared<Script>();
  std::unique_ptr<Navigator> navigator = make_navigator(script);
  FakeServer server;
  Session session;
  Outbox outbox{session};
  Replies replies{outbox};
  std::shared_ptr<storage::SpoolDisk> disk = std::make_shared<storage::SpoolDisk>();
  std::unique_ptr<storage::Spool> spool = storage::make_memory_spool(disk);
  Spooler spooler;
  MapWindow map;
  RunRefining refining;
  Recogniser recogniser{1};
  ExperienceIds ids{Random(5)};
  std::optional<Route> route;
  std::optional<ExperienceId> taught;
};

}  // namespace weft::agents::test
