#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "clients/cli/commands.hpp"
#include "core/protocol/messages.hpp"
#include "idl/bus/inprocess/net.hpp"
#include "idl/bus/link.hpp"
#include "server/service.hpp"
#include "storage/memory/memory_store.hpp"

namespace weft::cli::test {

/// Returns where these tests write.
std::filesystem::path folder();

/// Plays a robot that says what the test wants and does everything it is told.
struct Puppet {
  RobotId id;
  std::string name;
  msg::RobotState state;
  std::vector<msg::AgentCommand> told;
  bool answers = true;
  std::function<void(const msg::AgentCommand&, msg::AgentReply&)> how = [](const auto&, auto&) {};

  std::unique_ptr<bus::Link> link;
  std::uint64_t sequence = 0;
  SteadyTime speak_at{};
  std::optional<Route> route;
  msg::RoutePhase phase = msg::RoutePhase::driving;
};

/// Holds what a command said.
struct Said {
  Exit exit = Exit::done;
  std::string out;
  std::string err;
  nlohmann::json json() const { return nlohmann::json::parse(out); }
};

/// Holds a real server with a map of two stitched loops, puppets for robots, and an operator, on one virtual clock.
class Fleet {
 public:
  Fleet();
  /// Runs one command line; the server and the robots live on while it waits.
  Said weft(const std::vector<std::string>& arguments);
  void run(Duration duration);
  Puppet& add_robot(const std::string& name, const std::string& software = "0.1.0");
  void restart_server();
  void set_faults(const bus::Faults& faults) { net_.set_faults(faults); }

  ExperienceId first{0xA1};
  ExperienceId second{0xB2};
  bool server_lives = true;
  std::vector<std::unique_ptr<Puppet>> puppets;
  std::shared_ptr<storage::MemoryDisk> disk;
  std::unique_ptr<server::Service> service;
  SteadyTime now{};
  std::map<msg::Query::Kind, std::size_t> asked;             ///< queries that the server took, by kind
  std::function<bool()> interrupted = [] { return false; };  ///< the operator ends the command

 private:
  void turn(Duration step);
  void serve();
  void play(Puppet& puppet);
  server::Now both() const;
  template <class M>
  void say(Puppet& puppet, M message);

  bus::InProcessNet net_;
  std::unique_ptr<storage::MapStore> store_;
  std::unique_ptr<bus::Link> server_link_;
  std::uint64_t starts_ = 0;
  std::uint8_t operators_ = 0;
};

/// Returns the map that the fleet begins with: loops of 20 and 14 metres that share one side, and a label on each.
std::vector<Batch> two_loops(ExperienceId first, ExperienceId second, const RobotId& r1, const RobotId& r2);
ContentHash content_hash();
Bytes content_bytes();

}  // namespace weft::cli::test
