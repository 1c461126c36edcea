#include <chrono>

#include "tests/contract/bus/lab_fleet.hpp"

namespace weft::contract {
namespace {

struct LinkOf : LabTest {};

TEST_P(LinkOf, ARobotThatBeginsWithoutCarrierIsHeardOnceItHasOne) {
  ASSERT_TRUE(lab->run(Lab::At::server, "ip link set eth0 down"));  // the far end's: this one's carrier is gone
  const auto robot = start_robot();
  ASSERT_TRUE(robot->send(hello_of(kRobotId, msg::Role::agent)));
  ASSERT_TRUE(lab->run(Lab::At::server, "ip link set eth0 up"));
  const auto server = start_server();
  EXPECT_TRUE(hears(*server, kRobotId));
  EXPECT_TRUE(is_answered(*server, *robot));
}

TEST_P(LinkOf, AServerThatBeginsWithoutCarrierHearsOnceItHasOne) {
  ASSERT_TRUE(lab->run(Lab::At::robot, "ip link set eth0 down"));
  const auto server = start_server();
  ASSERT_TRUE(lab->run(Lab::At::robot, "ip link set eth0 up"));
  const auto robot = start_robot();
  ASSERT_TRUE(robot->send(hello_of(kRobotId, msg::Role::agent)));
  EXPECT_TRUE(hears(*server, kRobotId));
  EXPECT_TRUE(is_answered(*server, *robot));
}

TEST_P(LinkOf, ARobotWhoseAddressChangesIsHeardAgain) {
  const auto server = start_server();
  const auto robot = start_robot("eth0");
  ASSERT_TRUE(robot->send(hello_of(kRobotId, msg::Role::agent)));
  ASSERT_TRUE(hears(*server, kRobotId));
  ASSERT_TRUE(lab->run(Lab::At::robot, "ip addr del 10.9.0.2/24 dev eth0; ip addr add 10.9.0.77/24 dev eth0"));
  EXPECT_TRUE(is_answered(*server, *robot));
}

TEST_P(LinkOf, ARobotWhoseAddressIsGoneEndsWhenItIsTold) {
  const auto server = start_server();
  auto robot = start_robot();
  ASSERT_TRUE(robot->send(hello_of(kRobotId, msg::Role::agent)));
  ASSERT_TRUE(hears(*server, kRobotId));
  ASSERT_TRUE(lab->run(Lab::At::robot, "ip addr del 10.9.0.2/24 dev eth0"));
  const auto begin = std::chrono::steady_clock::now();
  robot.reset();  // waits for its process
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::minutes(1)) << "it hung";
}

TEST_P(LinkOf, AServerThatMovesUnderItsNameIsFoundAgain) {
  auto server = start_server();
  const auto robot = start_robot(Lab::kRobot, "lab-server");
  ASSERT_TRUE(robot->send(hello_of(kRobotId, msg::Role::agent)));
  ASSERT_TRUE(hears(*server, kRobotId));
  server.reset();
  ASSERT_TRUE(lab->run(Lab::At::server, "ip addr del 10.9.0.1/24 dev eth0; ip addr add 10.9.0.55/24 dev eth0"));
  name_server("10.9.0.55");
  server = start_server("10.9.0.55");
  EXPECT_TRUE(hears(*server, kRobotId)) << "what it said last is told to the new one";
  EXPECT_TRUE(is_answered(*server, *robot));
}

WEFT_ON_EACH_DDS_PAIRING(LinkOf);

}  // namespace
}  // namespace weft::contract
