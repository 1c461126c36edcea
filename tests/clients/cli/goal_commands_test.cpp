#include "clients/cli/json.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "tests/clients/cli/one_robot.hpp"

namespace weft::cli::test {
namespace {
using namespace std::chrono_literals;

TEST(GoalCommands, AGoalsLife) {
  OneRobot fleet;
  const Said sent = fleet.weft({"goal", "send", "--to", "packing", "--no-return", "--robot", "r1", "--json"});
  ASSERT_EQ(sent.exit, Exit::done) << sent.err;
  const std::string id = sent.json()["goal"];
  fleet.run(3s);
  auto goals = fleet.weft({"goal", "list", "--json"}).json()["goals"];
  ASSERT_EQ(goals.size(), 1U);
  EXPECT_EQ(goals[0]["id"], id);
  EXPECT_EQ(goals[0]["state"], "executing");
  EXPECT_EQ(goals[0]["robot"], "r1");
  EXPECT_EQ(goals[0]["route"][0], "00000000000000a1:4");
  EXPECT_EQ(goals[0]["route_at"], 0);
  EXPECT_GT(goals[0]["arrival"]["in_s"].get<double>(), 1.0);
  EXPECT_LT(goals[0]["arrival"]["soonest_s"], goals[0]["arrival"]["latest_s"]);
  EXPECT_NE(fleet.weft({"goal", "list"}).out.find("packing"), std::string::npos);
  EXPECT_NE(fleet.weft({"goal", "show", id.substr(0, 6)}).out.find("\narrives in "), std::string::npos);
  EXPECT_NE(fleet.weft({"goal", "show", id.substr(0, 6)}).out.find("executing"), std::string::npos);
  const Said why = fleet.weft({"goal", "why", id.substr(0, 6)});
  EXPECT_NE(why.out.find("r1 is driving"), std::string::npos) << why.out;
  EXPECT_NE(why.out.find("\narrives in "), std::string::npos) << why.out;
  EXPECT_NE(fleet.weft({"goal", "why", "r1"}).out.find("r1 is driving"), std::string::npos);
  fleet.r1.phase = msg::RoutePhase::arrived;
  const Said watched = fleet.weft({"goal", "watch", id, "--timeout", "30"});
  EXPECT_EQ(watched.exit, Exit::done) << watched.err;
  EXPECT_NE(watched.out.find("succeeded"), std::string::npos);
  const auto shown = fleet.weft({"goal", "show", id, "--json"}).json();
  EXPECT_EQ(shown["state"], "succeeded");
  EXPECT_TRUE(shown["arrival"].is_null());
  EXPECT_GT(shown["duration_s"].get<double>(), 1.0);
}

TEST(GoalCommands, AnArrivalIsToldWithItsBand) {
  EXPECT_EQ(to_text(msg::Arrival{{}, 130.4, 110.0, 179.6}), "arrives in 2 min 10 s (1 min 50 s to 3 min)");
  EXPECT_EQ(to_text(msg::Arrival{{}, 59.4, 0.0, 3725.0}), "arrives in 59 s (0 s to 1 h 2 min)");
}

TEST(GoalCommands, WatchingACancelledGoalFails) {
  OneRobot fleet;
  const std::string id = fleet.weft({"goal", "send", "--to", "packing", "--no-return", "--json"}).json()["goal"];
  fleet.run(1s);
  EXPECT_EQ(fleet.weft({"goal", "cancel", id.substr(0, 8)}).exit, Exit::done);
  EXPECT_EQ(fleet.weft({"goal", "watch", id}).exit, Exit::failed);
}

TEST(GoalCommands, WatchingLastsAcrossARestartOfTheServer) {
  OneRobot fleet;
  const std::string id = fleet.weft({"goal", "send", "--to", "packing", "--no-return", "--json"}).json()["goal"];
  fleet.run(2s);
  fleet.restart_server();
  fleet.r1.phase = msg::RoutePhase::arrived;
  EXPECT_EQ(fleet.weft({"goal", "watch", id, "--timeout", "60"}).exit, Exit::done);
}

TEST(GoalCommands, WatchTimesOutWithWhatToDo) {
  OneRobot fleet;
  const std::string id = fleet.weft({"goal", "send", "--to", "packing", "--no-return", "--json"}).json()["goal"];
  const Said said = fleet.weft({"goal", "watch", id, "--timeout", "3"});
  EXPECT_EQ(said.exit, Exit::timed_out);
  EXPECT_NE(said.err.find("goal why"), std::string::npos);
}

TEST(GoalCommands, WatchingWithJsonIsADocumentALine) {
  OneRobot fleet;
  const std::string id = fleet.weft({"goal", "send", "--to", "packing", "--no-return", "--json"}).json()["goal"];
  const Said early = fleet.weft({"goal", "watch", id, "--timeout", "3", "--json"});
  EXPECT_EQ(early.exit, Exit::timed_out);
  fleet.r1.phase = msg::RoutePhase::arrived;
  const Said said = fleet.weft({"goal", "watch", id, "--timeout", "30", "--json"});
  EXPECT_EQ(said.exit, Exit::done);
  const auto documents = [](const std::string& text) {
    std::vector<nlohmann::json> all;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) all.push_back(nlohmann::json::parse(line));
    return all;
  };
  EXPECT_EQ(documents(early.out).back()["error"]["code"], "timed_out");
  EXPECT_EQ(documents(said.out).front()["state"], "pending");
  EXPECT_EQ(documents(said.out).back()["state"], "succeeded");
  EXPECT_EQ(documents(said.out).back()["goal"], id);
}

TEST(GoalCommands, AGoalThatIsUnderWayAges) {
  OneRobot fleet;
  std::ignore = fleet.weft({"goal", "send", "--to", "packing", "--no-return"});
  fleet.run(30s);
  const auto goals = fleet.weft({"goal", "list", "--json"}).json()["goals"];
  EXPECT_GE(goals[0]["duration_s"].get<double>(), 30.0);
}

TEST(GoalCommands, WhyAGoalThatIsOverSaysNothingOfWaiting) {
  OneRobot fleet;
  const std::string id = fleet.weft({"goal", "send", "--to", "packing", "--no-return", "--json"}).json()["goal"];
  fleet.r1.phase = msg::RoutePhase::arrived;
  EXPECT_EQ(fleet.weft({"goal", "watch", id, "--timeout", "30"}).exit, Exit::done);
  const Said why = fleet.weft({"goal", "why", id});
  EXPECT_EQ(why.out.find("waits: arrived"), std::string::npos) << why.out;
}

/// Arranges a robot that stands where it is, and another one in its way.
struct BlockedRobot : OneRobot {
  BlockedRobot() : r2(add_robot("r2")) {
    r1.state.place = {first, 0};
    r1.phase = msg::RoutePhase::waiting;
    r2.state.localised = true;
    r2.state.place = {first, 4};
    r2.state.mode = msg::RobotMode::stopped;  // it makes no way
    run(1s);
    goal = weft({"goal", "send", "--to", "packing", "--no-return", "--robot", "r1", "--json"}).json()["goal"];
    run(4s);
  }
  Puppet& r2;
  std::string goal;
};

TEST(GoalCommands, WhyNamesTheChainThatARobotWaitsFor) {
  BlockedRobot fleet;
  const auto document = fleet.weft({"goal", "why", fleet.goal, "--json"}).json();
  ASSERT_EQ(document["waits"].size(), 1U) << document.dump(1);
  EXPECT_EQ(document["waits"][0]["robot"], "r1");
  EXPECT_EQ(document["waits"][0]["held_by"], nlohmann::json::array({"r2"}));
  EXPECT_TRUE(document["waits"][0]["needs"].is_string());
  EXPECT_TRUE(document["waits"][0]["since"].is_string());
  const Said said = fleet.weft({"goal", "why", "r1"});
  EXPECT_NE(said.out.find("s at "), std::string::npos) << said.out;
  EXPECT_NE(said.out.find(" for r2, to have "), std::string::npos) << said.out;
  EXPECT_NE(said.out.find("r2 is stopped"), std::string::npos) << said.out;
  EXPECT_EQ(fleet.weft({"goal", "why", "r2", "--json"}).json()["waits"].size(), 0U);
}

TEST(GoalCommands, WhyNamesWhatARobotFoundBlockedAndUntilWhenThatIsClosed) {
  OneRobot fleet;
  const std::string id =
      fleet.weft({"goal", "send", "--to", "packing", "--no-return", "--robot", "r1", "--json"}).json()["goal"];
  fleet.run(2s);
  fleet.r1.state.safety = Safety::blocked;
  fleet.run(31s);
  fleet.r1.state.safety = Safety::ok;
  fleet.run(4s);
  const std::string why = fleet.weft({"goal", "why", id}).out;
  EXPECT_NE(why.find("goal.blocked: r1 found the way blocked between 00000000000000a1:"), std::string::npos) << why;
  EXPECT_NE(why.find("; that is closed for this goal until 2023-11-14T22:"), std::string::npos) << why;
  const auto document = fleet.weft({"goal", "why", id, "--json"}).json();
  EXPECT_EQ(document["goal"]["state"], "executing");
}

TEST(GoalCommands, StandstillIsNamedByRobotsWhyAndDoctor) {
  BlockedRobot fleet;
  const std::string text = "r2 is stopped and in the way of r1";
  const Said robots = fleet.weft({"robots"});
  EXPECT_NE(robots.out.find("standstill: " + text), std::string::npos) << robots.out;
  EXPECT_NE(fleet.weft({"goal", "why", "r1"}).out.find("standstill: " + text), std::string::npos);
  const Said doctor = fleet.weft({"doctor"});
  EXPECT_EQ(doctor.exit, Exit::failed);
  EXPECT_NE(doctor.out.find(text), std::string::npos) << doctor.out;
}

TEST(GoalCommands, GoalToNowhereAndUnknownGoalsAreRefused) {
  OneRobot fleet;
  EXPECT_EQ(fleet.weft({"goal", "send", "--to", "nowhere"}).exit, Exit::refused);
  EXPECT_EQ(fleet.weft({"goal", "show", "abc"}).exit, Exit::refused);
  EXPECT_EQ(fleet.weft({"goal", "why", "abc"}).exit, Exit::refused);
}

}  // namespace
}  // namespace weft::cli::test
