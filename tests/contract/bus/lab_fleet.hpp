#pragma once
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>

#include "tests/contract/bus/contract.hpp"
#include "tests/contract/bus/lab.hpp"

namespace weft::contract {

inline const PeerId kRobotId = peer_id(2);

/// Holds a server and a robot on two machines of a lab, each test once for each pairing of vendors. Skips, with the
/// reason, where the system has no network namespaces for us.
class LabTest : public testing::TestWithParam<Pairing> {
 protected:
  void SetUp() override;
  void TearDown() override;

  std::unique_ptr<bus::Link> start_server(const std::string& listen = Lab::kServer) const;
  std::unique_ptr<bus::Link> start_robot(const std::string& listen = Lab::kRobot,
                                         const std::string& server = Lab::kServer) const;
  /// Sets what the robot's machine takes the name `lab-server` for, from now on.
  void name_server(const std::string& ipv4) const;

  std::unique_ptr<Lab> lab;

 private:
  std::string hosts_;  ///< stands in for the robot's /etc/hosts
};

/// Turns until it holds, or three minutes are over: false.
bool until(const std::function<bool()>& holds);
/// Returns whether the link hears a hello of the peer.
bool hears(bus::Link& link, const PeerId& peer);
/// Returns whether the robot gets an order that the server repeats.
bool is_answered(bus::Link& server, bus::Link& robot);

std::vector<Pairing> pairings_over_dds();

#define WEFT_ON_EACH_DDS_PAIRING(suite)                                         \
  INSTANTIATE_TEST_SUITE_P(Each, suite, testing::ValuesIn(pairings_over_dds()), \
                           [](const auto& of) { return of.param.name; })

}  // namespace weft::contract
