#include <gtest/gtest.h>

#include "tests/clients/cli/fleet.hpp"

/// Lays down rules for pieces of the map, and takes them away, as operators ask.
namespace weft::cli::test {
namespace {

bool says(const std::string& text, const std::string& what) {
  return text.find(what) != std::string::npos;
}

TEST(RuleCommands, ARuleIsListedLoggedComparedAndUndone) {
  Fleet fleet;
  EXPECT_TRUE(says(fleet.weft({"rule", "list"}).out, "no rules"));
  const std::uint64_t before = fleet.weft({"map", "info", "--json"}).json()["revision"];
  const std::string stretch = to_string(fleet.first) + ":1..4";
  const std::vector<std::string> add = {"rule", "add", "slow", "--kind", "speed=0.3", "--place", stretch};
  std::vector<std::string> dry = add;
  dry.emplace_back("--dry-run");
  EXPECT_TRUE(says(fleet.weft(dry).out, "nothing was changed"));
  const Said said = fleet.weft(add);
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  const auto rows = fleet.weft({"rule", "list", "--json"}).json()["rules"];
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0]["name"], "slow");
  EXPECT_EQ(rows[0]["kind"], "speed");
  EXPECT_EQ(rows[0]["value"], 0.3);
  EXPECT_EQ(rows[0]["places"], nlohmann::json::array({stretch}));
  EXPECT_GE(rows[0]["place_count"], 4);
  EXPECT_TRUE(rows[0]["problem"].is_null());
  EXPECT_TRUE(says(fleet.weft({"rule", "list"}).out, "0.3 m/s"));
  EXPECT_EQ(fleet.weft({"map", "log", "--json", "--most", "1"}).json()["revisions"][0]["kind"], "rule");
  const std::string from = std::to_string(before);
  EXPECT_EQ(fleet.weft({"map", "diff", from, "--json"}).json()["rules"]["came"], nlohmann::json::array({"slow"}));
  EXPECT_EQ(fleet.weft({"map", "undo", "--revision", std::to_string(before + 1)}).exit, Exit::done);
  EXPECT_TRUE(says(fleet.weft({"rule", "list"}).out, "no rules"));
}

TEST(RuleCommands, AnEdgeIsClosedAndOpened) {
  Fleet fleet;
  const std::string a = to_string(fleet.first) + ":1";
  const std::string b = to_string(fleet.first) + ":2";
  EXPECT_EQ(fleet.weft({"edge", "close", a, b}).exit, Exit::done);
  EXPECT_EQ(fleet.weft({"edge", "close", a, b, "--both"}).exit, Exit::done);
  const auto rows = fleet.weft({"rule", "list", "--json"}).json()["rules"];
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0]["kind"], "closed");
  EXPECT_EQ(rows[0]["one_direction"], true);
  EXPECT_EQ(rows[1]["places"].size(), 2U);
  EXPECT_EQ(fleet.weft({"edge", "open", a, b}).exit, Exit::done);
  EXPECT_EQ(fleet.weft({"edge", "open", a, b, "--both"}).exit, Exit::done);
  const Said again = fleet.weft({"edge", "open", a, b});
  EXPECT_EQ(again.exit, Exit::refused);
  EXPECT_TRUE(says(again.err, "the map has no rule edge-")) << again.err;
}

TEST(RuleCommands, WhatCannotBeMeantIsRefusedHere) {
  Fleet fleet;
  EXPECT_TRUE(says(fleet.weft({"rule", "add", "x", "--kind", "closed"}).err, "holds nowhere"));
  EXPECT_TRUE(
      says(fleet.weft({"rule", "add", "x", "--kind", "closed", "--place", "dock"}).err, "'dock' is no stretch"));
  for (const std::vector<std::string>& directed :
       {std::vector<std::string>{"one_way"}, std::vector<std::string>{"closed", "--one-direction"}}) {
    std::vector<std::string> add = {"rule", "add", "x", "--polygon", "0,0;9,0;9,9", "--kind"};
    add.insert(add.end(), directed.begin(), directed.end());
    EXPECT_TRUE(says(fleet.weft(add).err, "rule x: --polygon has no direction")) << directed[0];
  }
  EXPECT_TRUE(says(fleet.weft({"edge", "close", "dock", "gate"}).err, "'dock' is no place"));
  const std::string a = to_string(fleet.first) + ":1";
  EXPECT_TRUE(says(fleet.weft({"edge", "close", a, a}).err, "leads to itself"));
  EXPECT_TRUE(says(fleet.weft({"rule", "add", "x", "--kind", "closed", "--label", "none"}).err, "no label none"));
}

TEST(RuleCommands, ARobotIsHeldAndLetGo) {
  Fleet fleet;
  fleet.add_robot("r1");
  fleet.run(std::chrono::seconds(2));
  EXPECT_TRUE(says(fleet.weft({"hold", "r1"}).out, "weft unhold r1"));
  EXPECT_TRUE(fleet.weft({"robots", "--json"}).json()["robots"][0]["held"].is_string());
  EXPECT_TRUE(says(fleet.weft({"robots"}).out, "held by"));
  EXPECT_EQ(fleet.weft({"unhold", "r1"}).exit, Exit::done);
  EXPECT_TRUE(fleet.weft({"robots", "--json"}).json()["robots"][0]["held"].is_null());
}

}  // namespace
}  // namespace weft::cli::test
