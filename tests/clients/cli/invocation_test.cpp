#include "clients/cli/invocation.hpp"

#include <gtest/gtest.h>

namespace weft::cli {
namespace {

std::variant<Invocation, NotRun> parsed(const std::vector<std::string>& arguments,
                                        const Environment& environment = {}) {
  std::vector<const char*> argv = {"weft"};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  return parse(static_cast<int>(argv.size()), argv.data(), environment);
}

Invocation good(const std::vector<std::string>& arguments, const Environment& environment = {}) {
  const auto result = parsed(arguments, environment);
  const auto* const not_run = std::get_if<NotRun>(&result);
  EXPECT_EQ(not_run, nullptr) << (not_run == nullptr ? "" : not_run->text);
  return not_run == nullptr ? std::get<Invocation>(result) : Invocation{};
}

using Command = Invocation::Command;

TEST(Invocation, WhatIsCalibratedIsPassedOnAsItStands) {
  const Invocation invocation = good({"calibrate", "camera", "DIR", "--json", "--square-mm", "25"});
  EXPECT_EQ(invocation.passed, (std::vector<std::string>{"camera", "DIR", "--json", "--square-mm", "25"}));
}

TEST(Invocation, EachCommandIsUnderstood) {
  const std::vector<std::pair<std::vector<std::string>, Command>> all = {
      {{"robots"}, Command::robots},
      {{"teach", "r1", "start", "--as", "loop", "--along", "f"}, Command::teach_start},
      {{"teach", "r1", "stop"}, Command::teach_stop},
      {{"teach", "r1", "report", "--draw", "a.svg"}, Command::teach_report},
      {{"localise", "r1", "--at", "dock"}, Command::localise},
      {{"robot", "counts", "r1"}, Command::robot_counts},
      {{"map", "info"}, Command::map_info},
      {{"map", "draw", "a.png"}, Command::map_draw},
      {{"map", "label", "00000000000000a1:3", "dock"}, Command::map_label},
      {{"map", "label", "here", "--robot", "r1", "dock"}, Command::map_label},
      {{"map", "export", "a.json"}, Command::map_export},
      {{"goal", "send", "--to", "dock", "--robot", "r1"}, Command::goal_send},
      {{"goal", "list"}, Command::goal_list},
      {{"goal", "show", "ab"}, Command::goal_show},
      {{"goal", "watch", "ab"}, Command::goal_watch},
      {{"goal", "cancel", "ab"}, Command::goal_cancel},
      {{"goal", "hand-over", "ab"}, Command::goal_hand_over},
      {{"goal", "why", "ab"}, Command::goal_why},
      {{"stop", "r1"}, Command::stop},
      {{"stop", "--all"}, Command::stop},
      {{"resume", "--all"}, Command::resume},
      {{"robot", "clear", "r1"}, Command::robot_clear},
      {{"robot", "clear", "r1", "--yes"}, Command::robot_clear},
      {{"rule", "add", "x", "--kind", "closed", "--place", "00000000000000a1:3..5"}, Command::rule_add},
      {{"rule", "list"}, Command::rule_list},
      {{"rule", "refresh", "x"}, Command::rule_refresh},
      {{"rule", "refresh", "--all", "--dry-run"}, Command::rule_refresh},
      {{"rule", "remove", "x"}, Command::rule_remove},
      {{"edge", "close", "00000000000000a1:3", "00000000000000a1:4", "--both"}, Command::edge_close},
      {{"edge", "open", "00000000000000a1:3", "00000000000000a1:4"}, Command::edge_open},
      {{"hold", "r1"}, Command::hold},
      {{"unhold", "r1"}, Command::unhold},
      {{"doctor"}, Command::doctor},
      {{"doctor", "--json"}, Command::doctor},
      {{"doctor", "--fleet"}, Command::doctor_fleet},
      {{"doctor", "network"}, Command::doctor_network},
      {{"calibrate", "camera", "--help"}, Command::calibrate},
  };
  for (const auto& [arguments, command] : all) EXPECT_EQ(good(arguments).command, command) << arguments.front();
}

TEST(Invocation, KindsOfRulesAreReadWithTheirValues) {
  const auto kind = [](const std::string& text) {
    return good({"rule", "add", "x", "--kind", text, "--label", "dock", "--within", "2.5"}).rule;
  };
  EXPECT_EQ(kind("speed=0.3").kind, RuleKind::speed);
  EXPECT_EQ(kind("speed=0.3").value, 0.3);
  EXPECT_EQ(kind("capacity=2").value, 2.0);
  EXPECT_EQ(kind("parking").within_m, 2.5);
  EXPECT_EQ(kind("parking").label, "dock");
  for (const auto* const text : {"shut", "speed", "speed=", "speed=fast", "closed=1", "speed=0.3m"}) {
    const auto result = parsed({"rule", "add", "x", "--kind", text, "--label", "dock"});
    const auto* const not_run = std::get_if<NotRun>(&result);
    ASSERT_NE(not_run, nullptr) << text;
    EXPECT_NE(not_run->text.find(std::string("--kind ") + text), std::string::npos) << not_run->text;
  }
  EXPECT_EQ(good({"goal", "send", "--to", "dock", "--priority", "7", "--no-return"}).priority, 7U);
  EXPECT_TRUE(std::holds_alternative<NotRun>(parsed({"goal", "send", "--to", "dock", "--priority", "10"})));
}

TEST(Invocation, FieldsArriveWhereTheyBelong) {
  const Invocation teach = good({"--timeout", "7", "teach", "r1", "start", "--as", "loop", "--json"});
  EXPECT_EQ(teach.robot, "r1");
  EXPECT_EQ(teach.name, "loop");
  EXPECT_TRUE(teach.json);
  EXPECT_EQ(teach.timeout_s, 7.0);
  const Invocation label = good({"map", "label", "here", "--robot", "r2", "dock"});
  EXPECT_EQ(label.place, "here");
  EXPECT_EQ(label.robot, "r2");
  EXPECT_EQ(label.name, "dock");
  EXPECT_TRUE(good({"map", "draw", "a.png", "--robots"}).draws_robots);
  EXPECT_FALSE(good({"map", "draw", "a.png"}).draws_robots);
  EXPECT_FALSE(good({"map", "draw", "a.png"}).draws_mosaic);
  const Invocation mosaic = good({"map", "draw", "--mosaic", "a.png", "--plan", "hall"});
  EXPECT_TRUE(mosaic.draws_mosaic);
  EXPECT_EQ(mosaic.file, "a.png");
  EXPECT_EQ(mosaic.plan, "hall");
  const Invocation clouds = good({"map", "draw", "--clouds", "a.png", "--no-plan"});
  EXPECT_TRUE(clouds.draws_clouds);
  EXPECT_EQ(clouds.command, Invocation::Command::map_draw);
}

TEST(Invocation, GlobalFlagsStandAnywhereAndTheEnvironmentFillsIn) {
  const Invocation after = good({"robots", "--server", "a", "--server", "b:3", "--dds", "fastdds", "--domain", "5"});
  EXPECT_EQ(after.servers, (std::vector<std::string>{"a", "b:3"}));
  EXPECT_EQ(after.vendor, "fastdds");
  EXPECT_EQ(after.domain, 5U);
  const Invocation filled = good({"robots"}, {.server = "x,y:2", .vendor = "fastdds"});
  EXPECT_EQ(filled.servers, (std::vector<std::string>{"x", "y:2"}));
  EXPECT_EQ(filled.vendor, "fastdds");
  EXPECT_EQ(good({"--server", "z", "robots"}, {.server = "x"}).servers, std::vector<std::string>{"z"});
  EXPECT_EQ(good({"robots"}).servers, std::vector<std::string>{"127.0.0.1"});
  const Environment site = {"x", "", "eth0", "200"};
  EXPECT_EQ(good({"robots"}, site).listen, "eth0");
  EXPECT_EQ(good({"robots"}, site).domain, 200U);
  EXPECT_EQ(good({"robots", "--listen", "wlan0", "--domain", "0"}, site).listen, "wlan0");
  EXPECT_EQ(good({"robots", "--listen", "wlan0", "--domain", "0"}, site).domain, 0U);
}

TEST(Invocation, DomainOfTheEnvironmentHasTheBoundsOfTheFlag) {
  for (const char* const wrong : {"201", "-1", "1x", "x", " 1"}) {
    const auto result = parsed({"robots"}, {.domain = wrong});
    ASSERT_TRUE(std::holds_alternative<NotRun>(result)) << wrong;
    EXPECT_EQ(std::get<NotRun>(result).exit_code, 2);
    EXPECT_NE(std::get<NotRun>(result).text.find("WEFT_DOMAIN is '" + std::string(wrong) + "'"), std::string::npos);
    EXPECT_EQ(good({"robots", "--domain", "7"}, {.domain = wrong}).domain, 7U);
  }
}

TEST(Invocation, MistakesAreUsageAndSayWhich) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{"map", "draw", "a.png", "--mosaic", "--robots"}, "--robots"},
      {{"map", "draw", "a.png", "--mosaic", "--floor-plan", "hall.yaml"}, "--floor-plan"},
      {{"map", "draw", "a.png", "--plan", "hall"}, "--mosaic"},
      {{"map", "draw", "a.png", "--no-plan"}, "--clouds"},
      {{"map", "draw", "a.png", "--mosaic", "--clouds"}, "--clouds"},
      {{}, "subcommand"},
      {{"robotz"}, "robotz"},
      {{"robots", "--colour"}, "--colour"},
      {{"teach", "r1"}, "subcommand"},
      {{"teach", "r1", "pause"}, "pause"},
      {{"map", "label", "here", "dock"}, "--robot"},
      {{"map", "label", "00000000000000a1:3", "--robot", "r1", "dock"}, "--robot"},
      {{"goal", "send"}, "--to"},
      {{"goal", "watch"}, "ID"},
      {{"stop"}, "--all"},
      {{"stop", "r1", "--all"}, "--all"},
      {{"robots", "--dds", "rti"}, "rti"},
      {{"robots", "--domain", "201"}, "201"},
      {{"robots", "--timeout", "0"}, "--timeout"},
      {{"robot", "clear"}, "ROBOT"},
  };
  for (const auto& [arguments, word] : wrong) {
    const auto result = parsed(arguments);
    const auto* const not_run = std::get_if<NotRun>(&result);
    ASSERT_NE(not_run, nullptr) << word;
    EXPECT_EQ(not_run->exit_code, 2) << word;
    EXPECT_NE(not_run->text.find(word), std::string::npos) << not_run->text;
  }
}

TEST(Invocation, NamesThatTheServerWouldRefuseNeverLeaveTheMachine) {
  const std::string longer(65, 'd');
  const std::vector<std::vector<std::string>> wrong = {{"map", "label", "00000000000000a1:3", longer},
                                                       {"goal", "send", "--to", longer},
                                                       {"stop", longer},
                                                       {"resume", "r 1"},
                                                       {"teach", "r1", "start", "--as", "loop one"},
                                                       {"teach", "J\xFCrgen", "stop"},
                                                       {"localise", "r1", "--at", "dock!"},
                                                       {"robot", "rename", "r1", "-"},
                                                       {"robot", "clear", longer},
                                                       {"map", "import", "a.g2o", "--as", "a/b"},
                                                       {"goal", "send", "--to", "dock", "--robot", longer}};
  for (const std::vector<std::string>& arguments : wrong) {
    const auto result = parsed(arguments);
    const auto* const not_run = std::get_if<NotRun>(&result);
    ASSERT_NE(not_run, nullptr) << arguments[0] << ' ' << arguments[1];
    EXPECT_EQ(not_run->exit_code, 2);
    EXPECT_NE(not_run->text.find("1 to 64 bytes of letters and digits of any script"), std::string::npos)
        << not_run->text;
    EXPECT_FALSE(not_run->json);
  }
}

TEST(Invocation, NamesOfAnyScriptAreUnderstood) {
  EXPECT_EQ(good({"goal", "send", "--to", "12-dock"}).name, "12-dock");
  EXPECT_EQ(good({"map", "label", "00000000000000a1:3", "s\xC3\xBCs"}).name, "s\xC3\xBCs");
  EXPECT_EQ(good({"localise", "r1", "--at", "00000000000000a1:3"}).place, "00000000000000a1:3");
  EXPECT_EQ(good({"robot", "forget", "0123456789abcdef0123456789abcdef"}).command, Command::robot_forget);
}

TEST(Invocation, AMistakeKnowsThatADocumentIsWanted) {
  const auto result = parsed({"robots", "--json", "--domain", "999"});
  ASSERT_TRUE(std::holds_alternative<NotRun>(result));
  EXPECT_TRUE(std::get<NotRun>(result).json);
}

TEST(Invocation, HelpAndVersionAreNoMistakes) {
  const auto help = parsed({"--help"});
  EXPECT_EQ(std::get<NotRun>(help).exit_code, 0);
  EXPECT_NE(std::get<NotRun>(help).text.find("goal"), std::string::npos);
  const auto version = parsed({"--version"}, {.libraries = ", with a bus"});
  EXPECT_EQ(std::get<NotRun>(version).exit_code, 0);
  EXPECT_NE(std::get<NotRun>(version).text.find(", with a bus"), std::string::npos);
}

TEST(Polyline, PointsWithCommentsAndCommas) {
  const auto points = parse_polyline("# a line\n1 2\n\n3.5,-4  # corner\n", "f");
  ASSERT_TRUE(points.has_value()) << points.error().message;
  ASSERT_EQ(points->size(), 2U);
  EXPECT_EQ((*points)[1].x, 3.5);
  EXPECT_EQ((*points)[1].y, -4.0);
}

TEST(Polyline, MistakesAreNamedByLine) {
  EXPECT_NE(parse_polyline("1 2\n3\n", "f").error().message.find("f:2"), std::string::npos);
  EXPECT_NE(parse_polyline("1 2 3\n", "f").error().message.find("f:1"), std::string::npos);
  EXPECT_NE(parse_polyline("1 nan\n2 2\n", "f").error().message.find("f:1"), std::string::npos);
  EXPECT_NE(parse_polyline("1 2\n", "f").error().message.find("fewer than two"), std::string::npos);
}

}  // namespace
}  // namespace weft::cli
