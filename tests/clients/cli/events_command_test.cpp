#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <sstream>
#include <utility>

#include "tests/clients/cli/one_robot.hpp"

/// Tests `weft events`.
namespace weft::cli::test {
namespace {
using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::Not;

std::vector<nlohmann::json> lines_of(const Said& said) {
  std::vector<nlohmann::json> documents;
  std::istringstream in(said.out);
  for (std::string line; std::getline(in, line);) documents.push_back(nlohmann::json::parse(line));
  return documents;
}

TEST(EventsCommand, ShowsOneALineNewestLast) {
  OneRobot fleet;
  const Said said = fleet.weft({"events", "--json"});
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  const auto events = lines_of(said);
  ASSERT_GE(events.size(), 2U);
  EXPECT_EQ(events.front()["kind"], "server.started");
  EXPECT_EQ(events.front()["number"], 1);
  EXPECT_TRUE(
      std::ranges::is_sorted(events, {}, [](const auto& event) { return event["number"].template get<int>(); }));
  const auto last = lines_of(fleet.weft({"events", "--last", "1", "--json"}));
  ASSERT_EQ(last.size(), 1U);
  EXPECT_EQ(last.front(), events.back());
  EXPECT_THAT(fleet.weft({"events"}).out, HasSubstr("  server.started: epoch "));
}

TEST(EventsCommand, FiltersByRobotKindAndTime) {
  OneRobot fleet;
  fleet.add_robot("r2");
  fleet.run(2s);
  for (const auto& event : lines_of(fleet.weft({"events", "--robot", "r2", "--json"})))
    EXPECT_EQ(event["robot"], "r2");
  const auto of_robots = lines_of(fleet.weft({"events", "--kind", "robot", "--json"}));
  EXPECT_FALSE(of_robots.empty());
  for (const auto& event : of_robots) EXPECT_THAT(event["kind"].get<std::string>(), HasSubstr("robot."));
  EXPECT_TRUE(lines_of(fleet.weft({"events", "--since", "1s", "--json"})).empty());
  const std::size_t all = lines_of(fleet.weft({"events", "--json"})).size();
  EXPECT_EQ(lines_of(fleet.weft({"events", "--since", "1h", "--json"})).size(), all);
  const Said nobody = fleet.weft({"events", "--robot", "r9"});
  EXPECT_EQ(nobody.exit, Exit::refused);
  EXPECT_THAT(nobody.err, HasSubstr("no robot r9"));
  EXPECT_EQ(fleet.weft({"events", "--since", "yesterday"}).exit, Exit::usage);
  EXPECT_EQ(fleet.weft({"events", "--last", "1001"}).exit, Exit::usage);
  EXPECT_EQ(fleet.weft({"events", "--kind", "robot lost"}).exit, Exit::usage);
  EXPECT_EQ(fleet.weft({"events", "--last", "5", "--since", "1h"}).exit, Exit::usage);
}

TEST(EventsCommand, FollowsUntilInterruptedAndTellsNoEventTwice) {
  OneRobot fleet;
  const SteadyTime begun = fleet.now;
  int turns = 0;
  fleet.interrupted = [&] {
    if (++turns == 10) fleet.r1.state.mode = msg::RobotMode::lost;
    return fleet.now > begun + 20s;
  };
  const Said said = fleet.weft({"events", "--follow", "--json"});
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  const auto events = lines_of(said);
  std::set<int> numbers;
  for (const auto& event : events) EXPECT_TRUE(numbers.insert(event["number"].get<int>()).second) << event;
  EXPECT_TRUE(std::ranges::any_of(events, [](const auto& event) { return event["kind"] == "robot.lost"; }))
      << said.out;
  fleet.interrupted = [] { return false; };
  EXPECT_EQ(lines_of(fleet.weft({"events", "--json"})).size(), events.size()) << "nothing is left out";
}

TEST(EventsCommand, FollowingTellsWhatTheStoreCouldNotKeep) {
  OneRobot fleet;
  const SteadyTime begun = fleet.now;
  bool is_full = false;
  fleet.interrupted = [&] {
    if (fleet.now > begun + 2s && !std::exchange(is_full, true)) {
      fleet.disk->faults.full = true;
      fleet.r1.state.mode = msg::RobotMode::lost;
    }
    return fleet.now > begun + 15s;
  };
  const Said said = fleet.weft({"events", "--follow"});
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_THAT(said.out, HasSubstr("store.stopped: "));
  EXPECT_THAT(said.out, HasSubstr("not kept)"));
}

TEST(EventsCommand, FollowsAServerThatComesBack) {
  OneRobot fleet;
  const SteadyTime begun = fleet.now;
  bool was_away = false;
  fleet.interrupted = [&] {
    if (fleet.now > begun + 2s && !std::exchange(was_away, true)) fleet.server_lives = false;
    if (!fleet.server_lives && fleet.now > begun + 30s) {
      fleet.restart_server();
      fleet.server_lives = true;
    }
    return fleet.now > begun + 60s;
  };
  const Said said = fleet.weft({"events", "--follow"});
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_THAT(said.err, HasSubstr("the server is silent; still following"));
  const std::size_t first = said.out.find("server.started");
  EXPECT_NE(said.out.find("server.started", first + 1), std::string::npos) << said.out;
}

}  // namespace
}  // namespace weft::cli::test
