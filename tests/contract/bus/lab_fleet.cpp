#include "tests/contract/bus/lab_fleet.hpp"

#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace weft::contract {
namespace {

std::unique_ptr<bus::Link> open_link(const RemoteBus::Options& options) {
  auto bus = RemoteBus::start(options);
  if (!bus) throw std::runtime_error(bus.error().message);
  return std::make_unique<bus::Link>(std::move(*bus));
}

}  // namespace

void LabTest::SetUp() {
  auto made = Lab::make();
  if (!made) GTEST_SKIP() << "SKIPPED: " << made.error().message;
  lab = std::move(*made);
  hosts_ = std::filesystem::temp_directory_path() / ("weft-lab-hosts-" + std::to_string(getpid()));
  name_server(Lab::kServer);
}

void LabTest::TearDown() {
  if (!hosts_.empty()) std::filesystem::remove(hosts_);
}

void LabTest::name_server(const std::string& ipv4) const {
  std::ofstream(hosts_) << "127.0.0.1 localhost\n" << ipv4 << " lab-server\n";
}

std::unique_ptr<bus::Link> LabTest::start_server(const std::string& listen) const {
  return open_link({.vendor = *GetParam().server,
                    .role = msg::Role::server,
                    .self = kServerId,
                    .listen = listen,
                    .network_of = lab->holder(Lab::At::server)});
}

std::unique_ptr<bus::Link> LabTest::start_robot(const std::string& listen, const std::string& server) const {
  return open_link({.vendor = *GetParam().peer,
                    .role = msg::Role::agent,
                    .self = kRobotId,
                    .listen = listen,
                    .server = server,
                    .network_of = lab->holder(Lab::At::robot),
                    .hosts = hosts_});
}

bool until(const std::function<bool()>& holds) {
  const auto limit = std::chrono::steady_clock::now() + std::chrono::minutes(3);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > limit) return false;
    usleep(2000);
  }
  return true;
}

bool hears(bus::Link& link, const PeerId& peer) {
  return until([&] {
    const std::optional<msg::Message> message = link.take();
    const auto* const hello = message ? std::get_if<msg::Hello>(&*message) : nullptr;
    return hello != nullptr && hello->peer == peer;
  });
}

bool is_answered(bus::Link& server, bus::Link& robot) {
  msg::AgentCommand order;
  order.header = header_of(kServerId);
  order.to = kRobotId;
  int turns = 0;
  return until([&] {
    // A server that greets is heard: silence alone would make the robot open its link anew.
    if (turns++ % 100 == 0) std::ignore = server.send(hello_of(kServerId, msg::Role::server));
    if (turns % 100 == 50) std::ignore = server.send(order);
    const std::optional<msg::Message> message = robot.take();
    return message && std::holds_alternative<msg::AgentCommand>(*message);
  });
}

std::vector<Pairing> pairings_over_dds() {
  std::vector<Pairing> those = pairings();
  std::erase_if(those, [](const Pairing& pairing) { return !pairing.server; });
  return those;
}

}  // namespace weft::contract
