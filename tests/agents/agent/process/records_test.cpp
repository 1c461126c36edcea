#include "agents/agent/process/records.hpp"

#include <gtest/gtest.h>

#include "tests/agents/agent/process/folder.hpp"

namespace weft::agents::test {
namespace {

TEST(AgentRecords, AreTheLinesThatTheJudgeReads) {
  const Folder folder;
  auto records = Records::open(folder.path(), "r1");
  ASSERT_TRUE(records.has_value());
  AgentOutput output;
  output.fixes.push_back({.frame = 12, .fix = {{{0xA1}, 3}, Metric2{Pose2{0.25, -0.5, 0.125}}, {}}});
  output.acks.push_back({.experience = {0xA1}, .sequence = 2, .first = 5, .places = 4});
  msg::RouteProgress progress;
  progress.route.bytes[0] = 1;
  progress.version = 2;
  progress.phase = msg::RoutePhase::driving;
  output.send.emplace_back(progress);
  output.send.emplace_back(progress);
  progress.phase = msg::RoutePhase::arrived;
  output.send.emplace_back(progress);
  records->note(output, 13);
  EXPECT_EQ(
      folder.read("fixes.jsonl"),
      R"({"robot":"r1","frame":12,"place":"00000000000000a1:3","place_from_robot":{"x":0.250000,"y":-0.500000,"heading":0.1250000}})"
      "\n");
  EXPECT_EQ(folder.read("acks.jsonl"),
            R"({"robot":"r1","experience":"00000000000000a1","sequence":2,"first":5,"places":4})"
            "\n");
  const std::string drives = folder.read("drives.jsonl");
  EXPECT_EQ(std::count(drives.begin(), drives.end(), '\n'), 2);
  EXPECT_NE(drives.find(R"("frame":13)"), std::string::npos);
  EXPECT_NE(drives.find(R"("phase":"arrived")"), std::string::npos);
}

TEST(AgentRecords, HaveEachOrderOnceAndItsPlacesOnceAVersion) {
  const Folder folder;
  auto records = Records::open(folder.path(), "r1");
  ASSERT_TRUE(records.has_value());
  Route route;
  route.id.bytes[0] = 1;
  route.version = 2;
  route.places = {{{0xA1}, 3}, {{0xA1}, 4}};
  records->note(route, 7);
  records->note(route, 8);
  route.released = 1;
  records->note(route, 9);
  records->note(std::nullopt, 12);
  const std::string id = to_string(route.id);
  const std::string none = to_string(RouteId{});
  const std::string goal = R"("goal":")" + to_string(GoalId{}) + "\"";
  EXPECT_EQ(folder.read("orders.jsonl"),
            R"({"robot":"r1","frame":7,)" + goal + R"(,"route":")" + id +
                R"(","version":2,"released":0,"places":["00000000000000a1:3","00000000000000a1:4"]})" + "\n" +
                R"({"robot":"r1","frame":9,)" + goal + R"(,"route":")" + id + R"(","version":2,"released":1})" +
                "\n" + R"({"robot":"r1","frame":12,)" + goal + R"(,"route":")" + none +
                R"(","version":0,"released":0})" + "\n");
}

TEST(AgentRecords, HaveEveryStateThatIsSent) {
  const Folder folder;
  auto records = Records::open(folder.path(), "r1");
  ASSERT_TRUE(records.has_value());
  AgentOutput output;
  msg::RobotState state;
  state.frame = 31;
  state.mode = msg::RobotMode::waiting;
  state.speed_m_s = 0.25;
  output.send.emplace_back(state);
  records->note(output, 31);
  EXPECT_EQ(folder.read("motion.jsonl"), R"({"robot":"r1","frame":31,"mode":"waiting","speed_m_s":0.2500,"route":")" +
                                             to_string(RouteId{}) + R"(","version":0,"at":0})" + "\n");
}

TEST(AgentRecords, WhatAFullDiskTakesIsCounted) {
  const Folder folder;
  std::filesystem::create_symlink("/dev/full", folder.path() / "fixes.jsonl");
  auto records = Records::open(folder.path(), "r1");
  ASSERT_TRUE(records.has_value());
  AgentOutput output;
  output.acks.push_back({.experience = {0xA1}, .sequence = 2, .first = 5, .places = 4});
  records->note(output, 12);
  EXPECT_EQ(records->lost(), 0U);
  output.fixes.push_back({.frame = 12, .fix = {{{0xA1}, 3}, Metric2{Pose2{0.25, -0.5, 0.125}}, {}}});
  records->note(output, 13);
  EXPECT_EQ(records->lost(), 1U);
}

}  // namespace
}  // namespace weft::agents::test
