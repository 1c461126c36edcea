#include <gtest/gtest.h>

#include <chrono>

#include "tests/clients/cli/one_robot.hpp"

/// Tests `weft doctor network` and `weft doctor --fleet` against a whole server.
namespace weft::cli::test {
namespace {
using namespace std::chrono_literals;

TEST(DoctorNetwork, MeasuresAGoodNetwork) {
  OneRobot fleet;
  const Said said = fleet.weft({"doctor", "network", "--json"});
  EXPECT_EQ(said.exit, Exit::done) << said.out << said.err;
  const auto network = said.json()["network"];
  EXPECT_EQ(network["small"]["loss"], 0.0);
  EXPECT_EQ(network["flow"]["returned"], network["flow"]["sent"]);
  EXPECT_TRUE(said.json()["good"]);
}

TEST(DoctorNetwork, NamesLoss) {
  OneRobot fleet;
  fleet.set_faults({.loss = 0.1});
  const Said said = fleet.weft({"doctor", "network"});
  EXPECT_EQ(said.exit, Exit::failed) << said.out << said.err;
  EXPECT_NE(said.out.find("PROBLEM  loss"), std::string::npos) << said.out;
}

TEST(DoctorNetwork, AServerThatIsGoneIsNotReached) {
  OneRobot fleet;
  fleet.server_lives = false;
  EXPECT_EQ(fleet.weft({"doctor", "network"}).exit, Exit::unreached);
}

TEST(DoctorFleet, ShowsEachRobotOnALine) {
  OneRobot fleet;
  fleet.r1.state.spool_free_bytes = 5ULL << 30U;
  fleet.run(1s);
  const Said said = fleet.weft({"doctor", "--fleet"});
  EXPECT_EQ(said.exit, Exit::done) << said.out << said.err;
  EXPECT_NE(said.out.find("5120 MiB free"), std::string::npos) << said.out;
  EXPECT_NE(said.out.find("floor"), std::string::npos) << said.out;
  const auto robot = fleet.weft({"doctor", "--fleet", "--json"}).json()["robots"][0];
  EXPECT_EQ(robot["name"], "r1");
  EXPECT_TRUE(robot["good"]);
  EXPECT_EQ(robot["disk"]["free_bytes"], 5ULL << 30U);
  EXPECT_TRUE(robot["disk"]["refuses"].is_null());
}

TEST(DoctorFleet, NamesARobotThatHearsNothing) {
  OneRobot fleet;
  fleet.r1.state.server_unheard_s = 20.0;
  fleet.run(20s);
  const Said said = fleet.weft({"doctor", "--fleet"});
  EXPECT_EQ(said.exit, Exit::failed);
  EXPECT_NE(said.out.find("deaf for 20 s"), std::string::npos) << said.out;
  EXPECT_NE(fleet.weft({"robots"}).out.find("hears nothing of the server"), std::string::npos);
  EXPECT_TRUE(fleet.weft({"robots", "--json"}).json()["robots"][0]["deaf"]);
}

TEST(DoctorFleet, NamesWhatIsWrongWithARobot) {
  OneRobot fleet;
  fleet.r1.state.spool_refuses = "the disk is full";
  fleet.add_robot("r9", "0.0.9");
  fleet.run(2s);
  const Said said = fleet.weft({"doctor", "--fleet"});
  EXPECT_EQ(said.exit, Exit::failed);
  EXPECT_NE(said.out.find("its spool takes nothing: the disk is full"), std::string::npos) << said.out;
  EXPECT_NE(said.out.find("its version is not the server's, 0.1.0"), std::string::npos) << said.out;
  const auto document = fleet.weft({"doctor", "--fleet", "--json"}).json();
  EXPECT_FALSE(document["good"]);
  EXPECT_EQ(document["robots"][0]["problems"].size(), 1U);
}

TEST(DoctorFleet, DoesNotGoWithTheNetwork) {
  OneRobot fleet;
  EXPECT_EQ(fleet.weft({"doctor", "--fleet", "network"}).exit, Exit::usage);
}

}  // namespace
}  // namespace weft::cli::test
