#include "clients/cli/commands.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <tuple>
#include <vector>

#include "tests/clients/cli/one_robot.hpp"

namespace weft::cli::test {
namespace {
using namespace std::chrono_literals;
using Kind = msg::AgentCommand::Kind;

std::string write(const std::string& name, const std::string& text) {
  const std::filesystem::path file = folder() / name;
  std::ofstream(file) << text;
  return file.string();
}

TEST(Commands, UnreachableServerIsSaidWithinTheTimeout) {
  Fleet fleet;
  fleet.server_lives = false;
  fleet.restart_server();  // nobody heard its last hello
  const SteadyTime before = fleet.now;
  const Said said = fleet.weft({"robots", "--timeout", "3"});
  EXPECT_EQ(said.exit, Exit::unreached);
  EXPECT_NE(said.err.find("weft-server"), std::string::npos);
  EXPECT_LE(fleet.now - before, 3200ms);
}

TEST(Commands, SilentServerTimesOut) {
  OneRobot fleet;
  fleet.r1.answers = false;
  const Said said = fleet.weft({"teach", "r1", "stop", "--timeout", "2", "--json"});
  EXPECT_EQ(said.exit, Exit::timed_out);
  EXPECT_EQ(said.json()["exit"], 5);
}

TEST(Commands, RobotsShowsWhatTheyDo) {
  OneRobot fleet;
  EXPECT_NE(fleet.weft({"robots"}).out.find("r1"), std::string::npos);
  const auto rows = fleet.weft({"robots", "--json"}).json()["robots"];
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0]["name"], "r1");
  EXPECT_EQ(rows[0]["mode"], "idle");
  EXPECT_EQ(rows[0]["place"], "00000000000000a1:4");
  EXPECT_EQ(rows[0]["vendor"], "inprocess");
  EXPECT_LT(rows[0]["silent_s"].get<double>(), 2.0);
}

TEST(Commands, RobotsComeInTheOrderOfTheirNamesAndASilentOneHasNoMode) {
  Fleet fleet;
  fleet.add_robot("r10");
  fleet.add_robot("a2");
  fleet.run(1s);
  fleet.puppets.front()->speak_at = SteadyTime::max();
  fleet.run(10s);
  const auto rows = fleet.weft({"robots", "--json"}).json()["robots"];
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0]["name"], "a2");
  EXPECT_EQ(rows[1]["heard"], false);
  const std::string table = fleet.weft({"robots"}).out;
  EXPECT_NE(table.find("silent"), std::string::npos) << table;
}

TEST(Commands, AMistakeIsADocumentToo) {
  std::ostringstream out;
  std::ostringstream err;
  EXPECT_EQ(report(NotRun{2, "weft: no such word \xFC; see weft --help\n", true}, {out, err}), 2);
  const auto document = nlohmann::json::parse(out.str());
  EXPECT_EQ(document["error"]["message"], "no such word \xEF\xBF\xBD; see weft --help");
  EXPECT_EQ(document["exit"], 2);
  EXPECT_FALSE(err.str().empty());
}

TEST(Commands, RefusalsAndErrorsAreDocumentsOfOneShape) {
  OneRobot fleet;
  for (const std::vector<std::string>& words : {std::vector<std::string>{"stop", "r9", "--json"},
                                                {"goal", "send", "--to", "nowhere", "--json"},
                                                {"goal", "show", "ffff", "--json"},
                                                {"robot", "forget", "r1", "--json"}}) {
    const Said said = fleet.weft(words);
    EXPECT_EQ(said.json()["exit"], static_cast<int>(said.exit)) << said.out;
    EXPECT_FALSE(said.json()["error"]["message"].get<std::string>().empty()) << said.out;
    EXPECT_EQ(said.exit, Exit::refused) << said.out;
  }
}

TEST(Commands, RobotCountsShowsTheMostFrequentFirst) {
  OneRobot fleet;
  EXPECT_NE(fleet.weft({"robot", "counts", "r1"}).out.find("nothing"), std::string::npos);
  fleet.r1.how = [](const msg::AgentCommand&, msg::AgentReply& reply) {
    reply.counts = {{"navigation: few_matches", 3}, {"navigation: fixes", 70}};
  };
  const Said said = fleet.weft({"robot", "counts", "r1"});
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_EQ(said.out, "TIMES  WHAT\n70     navigation: fixes\n3      navigation: few_matches\n");
  EXPECT_EQ(fleet.r1.told.back().kind, Kind::counts);
  EXPECT_EQ(fleet.weft({"robot", "counts", "r1", "--json"}).json()["counts"]["navigation: fixes"], 70);
  EXPECT_EQ(fleet.weft({"robot", "counts", "r9"}).exit, Exit::refused);
}

TEST(Commands, NoRobotsSaysHowToStartOne) {
  Fleet fleet;
  EXPECT_NE(fleet.weft({"robots"}).out.find("weft-agent"), std::string::npos);
}

TEST(Commands, TeachTakesTheLineAndTheName) {
  OneRobot fleet;
  fleet.r1.how = [](const msg::AgentCommand&, msg::AgentReply& reply) { reply.experience = ExperienceId{0xC3}; };
  const Said said =
      fleet.weft({"teach", "r1", "start", "--as", "loop", "--along", write("a.line", "1 2\n3 4\n"), "--json"});
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_EQ(said.json()["experience"], "00000000000000c3");
  ASSERT_EQ(fleet.r1.told.size(), 1U);
  EXPECT_EQ(fleet.r1.told[0].kind, Kind::teach_start);
  EXPECT_EQ(fleet.r1.told[0].name, "loop");
  ASSERT_EQ(fleet.r1.told[0].along.size(), 2U);
  EXPECT_EQ(fleet.r1.told[0].along[1].y, 4.0);
  EXPECT_EQ(fleet.weft({"teach", "r1", "stop"}).exit, Exit::done);
  EXPECT_EQ(fleet.r1.told.back().kind, Kind::teach_stop);
}

TEST(Commands, TeachAlongAMissingOrWrongFileIsUsage) {
  OneRobot fleet;
  EXPECT_EQ(fleet.weft({"teach", "r1", "start", "--along", "/nowhere/x"}).exit, Exit::usage);
  const Said said = fleet.weft({"teach", "r1", "start", "--along", write("b.line", "1 2\nx y\n")});
  EXPECT_EQ(said.exit, Exit::usage);
  EXPECT_NE(said.err.find("b.line:2"), std::string::npos);
  EXPECT_TRUE(fleet.r1.told.empty());
}

TEST(Commands, RefusalsCarryTheRobotsWords) {
  OneRobot fleet;
  fleet.r1.how = [](const msg::AgentCommand&, msg::AgentReply& reply) {
    reply.done = false;
    reply.reason = "r1 is being taught 'x': stop that first";
  };
  const Said said = fleet.weft({"teach", "r1", "start"});
  EXPECT_EQ(said.exit, Exit::refused);
  EXPECT_NE(said.err.find("stop that first"), std::string::npos);
}

TEST(Commands, UnknownRobotIsRefused) {
  OneRobot fleet;
  const Said said = fleet.weft({"localise", "r9"});
  EXPECT_EQ(said.exit, Exit::refused);
  EXPECT_NE(said.err.find("r9"), std::string::npos);
}

TEST(Commands, LocaliseSeedsByLabelAndByPlace) {
  OneRobot fleet;
  EXPECT_EQ(fleet.weft({"localise", "r1", "--at", "dock"}).exit, Exit::done);
  EXPECT_EQ(fleet.r1.told.back().seed, (PlaceId{fleet.first, 30}));
  EXPECT_EQ(fleet.weft({"localise", "r1", "--at", "00000000000000b2:7"}).exit, Exit::done);
  EXPECT_EQ(fleet.r1.told.back().seed, (PlaceId{fleet.second, 7}));
  EXPECT_EQ(fleet.weft({"localise", "r1"}).exit, Exit::done);
  EXPECT_FALSE(fleet.r1.told.back().seed.has_value());
  EXPECT_EQ(fleet.weft({"localise", "r1", "--at", "nowhere"}).exit, Exit::refused);
}

TEST(Commands, MapInfoCounts) {
  Fleet fleet;
  const auto info = fleet.weft({"map", "info", "--json"}).json();
  EXPECT_EQ(info["experiences"], 2);
  EXPECT_EQ(info["places"], fleet.service->snapshot().place_count());
  EXPECT_EQ(info["stitches"], fleet.service->snapshot().stitch_count());
  EXPECT_GT(info["stitches"], 5);
  EXPECT_NE(fleet.weft({"map", "info"}).out.find("places"), std::string::npos);
}

TEST(Commands, LabelsAPlace) {
  Fleet fleet;
  EXPECT_EQ(fleet.weft({"map", "label", "00000000000000b2:9", "gate"}).exit, Exit::done);
  EXPECT_EQ(fleet.service->snapshot().labels().at("gate"), (PlaceId{fleet.second, 9}));
  EXPECT_EQ(fleet.weft({"map", "label", "00000000000000b2:900", "gate"}).exit, Exit::refused);
  EXPECT_EQ(fleet.weft({"map", "label", "b2", "gate"}).exit, Exit::usage);
}

TEST(Commands, LabelsWhereARobotStands) {
  OneRobot fleet;
  const Said said = fleet.weft({"map", "label", "here", "--robot", "r1", "gate"});
  EXPECT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_EQ(fleet.service->snapshot().labels().at("gate"), (PlaceId{fleet.first, 4}));
}

TEST(Commands, ExportsWhatTheJudgeReads) {
  OneRobot fleet;
  const std::string file = (folder() / "network.json").string();
  ASSERT_EQ(fleet.weft({"map", "export", file}).exit, Exit::done);
  EXPECT_EQ(fleet.weft({"map", "export", "/nowhere/network.json"}).exit, Exit::failed);
  std::ifstream in(file);
  const nlohmann::json network = nlohmann::json::parse(in);
  EXPECT_EQ(network["places"].size(), fleet.service->snapshot().place_count());
  EXPECT_EQ(network["experiences"].size(), 2U);
  EXPECT_EQ(network["labels"]["dock"], "00000000000000a1:30");
  const auto& place = network["places"][5];
  EXPECT_EQ(place["id"], "00000000000000a1:5");
  EXPECT_EQ(place["robot"], "r1");
  EXPECT_EQ(place["frame"], 50);
  std::size_t stitches = 0;
  for (const auto& edge : network["edges"]) {
    if (edge["origin"] != "stitch") continue;
    ++stitches;
    EXPECT_EQ(edge["inliers"], 55);
    EXPECT_NEAR(edge["a_from_b"]["y"].get<double>(), 0.1, 1e-9);
  }
  EXPECT_EQ(stitches, fleet.service->snapshot().stitch_count());
}

TEST(Commands, DrawsAPicture) {
  OneRobot fleet;
  const std::string file = (folder() / "map.png").string();
  EXPECT_EQ(fleet.weft({"map", "draw", file}).exit, Exit::done);
  EXPECT_GT(std::filesystem::file_size(file), 5000U);
  EXPECT_EQ(fleet.weft({"map", "draw", "map.bmp"}).exit, Exit::usage);
}

TEST(Commands, MapDrawTellsRunsWithTheirColours) {
  OneRobot fleet;
  const auto document = fleet.weft({"map", "draw", (folder() / "map.png").string(), "--json"}).json();
  ASSERT_EQ(document["runs"].size(), 2U);
  EXPECT_EQ(document["runs"][0]["experience"], "00000000000000a1");
  EXPECT_EQ(document["runs"][0]["colour"], "#d65e00");
  EXPECT_TRUE(document["runs"][0]["name"].is_null());  // nobody has named it
  EXPECT_FALSE(document.contains("robots"));
}

TEST(Commands, MapDrawWithRobotsTellsWhoIsNotDrawn) {
  OneRobot fleet;
  fleet.add_robot("r2");
  fleet.run(1s);
  const std::string file = (folder() / "map.svg").string();
  const auto robots = fleet.weft({"map", "draw", file, "--robots", "--json"}).json()["robots"];
  EXPECT_EQ(robots["drawn"], nlohmann::json::array({"r1"}));
  ASSERT_EQ(robots["not_drawn"].size(), 1U);
  EXPECT_EQ(robots["not_drawn"][0]["name"], "r2");
  const Said said = fleet.weft({"map", "draw", file, "--robots"});
  EXPECT_EQ(said.exit, Exit::done);
  EXPECT_NE(said.out.find("not drawn: r2, it does not know where it is"), std::string::npos) << said.out;
}

TEST(Commands, MapDrawWithRobotsDrawsTheRouteThatOneHolds) {
  OneRobot fleet;
  Puppet& r2 = fleet.add_robot("r2");
  r2.state.place = {fleet.second, 40};
  r2.state.mode = msg::RobotMode::lost;
  Puppet& r3 = fleet.add_robot("r3");
  r3.state.localised = true;
  r3.state.place = {fleet.second, 25};
  fleet.run(1s);
  const std::string before = (folder() / "before.png").string();
  const std::string after = (folder() / "after.png").string();
  ASSERT_EQ(fleet.weft({"map", "draw", before, "--robots"}).exit, Exit::done);
  ASSERT_EQ(fleet.weft({"goal", "send", "--to", "packing", "--no-return", "--robot", "r1"}).exit, Exit::done);
  fleet.run(3s);
  r3.speak_at = SteadyTime::max();
  fleet.run(10s);
  const auto robots = fleet.weft({"map", "draw", after, "--robots", "--json"}).json()["robots"];
  EXPECT_EQ(robots["drawn"], nlohmann::json::array({"r1", "r2", "r3"}));
  EXPECT_NE(std::filesystem::file_size(before), std::filesystem::file_size(after));
}

TEST(Commands, RobotsAreNotDrawnOnAnOldMap) {
  Fleet fleet;
  const Said said = fleet.weft({"map", "draw", (folder() / "map.svg").string(), "--robots", "--at", "1"});
  EXPECT_EQ(said.exit, Exit::usage);
  EXPECT_NE(said.err.find("--robots"), std::string::npos) << said.err;
}

TEST(Commands, AGoalsLife) {
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

TEST(Commands, AnArrivalIsToldWithItsBand) {
  EXPECT_EQ(to_text(msg::Arrival{{}, 130.4, 110.0, 179.6}), "arrives in 2 min 10 s (1 min 50 s to 3 min)");
  EXPECT_EQ(to_text(msg::Arrival{{}, 59.4, 0.0, 3725.0}), "arrives in 59 s (0 s to 1 h 2 min)");
}

TEST(Commands, WatchingACancelledGoalFails) {
  OneRobot fleet;
  const std::string id = fleet.weft({"goal", "send", "--to", "packing", "--no-return", "--json"}).json()["goal"];
  fleet.run(1s);
  EXPECT_EQ(fleet.weft({"goal", "cancel", id.substr(0, 8)}).exit, Exit::done);
  EXPECT_EQ(fleet.weft({"goal", "watch", id}).exit, Exit::failed);
}

TEST(Commands, WatchingLastsAcrossARestartOfTheServer) {
  OneRobot fleet;
  const std::string id = fleet.weft({"goal", "send", "--to", "packing", "--no-return", "--json"}).json()["goal"];
  fleet.run(2s);
  fleet.restart_server();
  fleet.r1.phase = msg::RoutePhase::arrived;
  EXPECT_EQ(fleet.weft({"goal", "watch", id, "--timeout", "60"}).exit, Exit::done);
}

TEST(Commands, WatchTimesOutWithWhatToDo) {
  OneRobot fleet;
  const std::string id = fleet.weft({"goal", "send", "--to", "packing", "--no-return", "--json"}).json()["goal"];
  const Said said = fleet.weft({"goal", "watch", id, "--timeout", "3"});
  EXPECT_EQ(said.exit, Exit::timed_out);
  EXPECT_NE(said.err.find("goal why"), std::string::npos);
}

TEST(Commands, WatchingWithJsonIsADocumentALine) {
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

TEST(Commands, AGoalThatIsUnderWayAges) {
  OneRobot fleet;
  std::ignore = fleet.weft({"goal", "send", "--to", "packing", "--no-return"});
  fleet.run(30s);
  const auto goals = fleet.weft({"goal", "list", "--json"}).json()["goals"];
  EXPECT_GE(goals[0]["duration_s"].get<double>(), 30.0);
}

TEST(Commands, WhyAGoalThatIsOverSaysNothingOfWaiting) {
  OneRobot fleet;
  const std::string id = fleet.weft({"goal", "send", "--to", "packing", "--no-return", "--json"}).json()["goal"];
  fleet.r1.phase = msg::RoutePhase::arrived;
  EXPECT_EQ(fleet.weft({"goal", "watch", id, "--timeout", "30"}).exit, Exit::done);
  const Said why = fleet.weft({"goal", "why", id});
  EXPECT_EQ(why.out.find("waits: arrived"), std::string::npos) << why.out;
}

/// Its robot stands where it is, and another one in its way.
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

TEST(Commands, WhyNamesTheChainThatARobotWaitsFor) {
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

TEST(Commands, StandstillIsNamedByRobotsWhyAndDoctor) {
  BlockedRobot fleet;
  const std::string text = "r2 is stopped and in the way of r1";
  const Said robots = fleet.weft({"robots"});
  EXPECT_NE(robots.out.find("standstill: " + text), std::string::npos) << robots.out;
  EXPECT_NE(fleet.weft({"goal", "why", "r1"}).out.find("standstill: " + text), std::string::npos);
  const Said doctor = fleet.weft({"doctor"});
  EXPECT_EQ(doctor.exit, Exit::failed);
  EXPECT_NE(doctor.out.find(text), std::string::npos) << doctor.out;
}

TEST(Commands, GoalToNowhereAndUnknownGoalsAreRefused) {
  OneRobot fleet;
  EXPECT_EQ(fleet.weft({"goal", "send", "--to", "nowhere"}).exit, Exit::refused);
  EXPECT_EQ(fleet.weft({"goal", "show", "abc"}).exit, Exit::refused);
  EXPECT_EQ(fleet.weft({"goal", "why", "abc"}).exit, Exit::refused);
}

TEST(Commands, StopAndResume) {
  OneRobot fleet;
  EXPECT_EQ(fleet.weft({"stop", "r1"}).exit, Exit::done);
  EXPECT_EQ(fleet.r1.told.back().kind, Kind::stop);
  EXPECT_EQ(fleet.weft({"resume", "r1"}).exit, Exit::done);
  EXPECT_EQ(fleet.r1.told.back().kind, Kind::resume);
  Puppet& r2 = fleet.add_robot("r2");
  fleet.run(1s);
  EXPECT_EQ(fleet.weft({"stop", "--all"}).exit, Exit::done);
  EXPECT_EQ(fleet.r1.told.back().kind, Kind::stop);
  ASSERT_FALSE(r2.told.empty());
  EXPECT_EQ(r2.told.back().kind, Kind::stop);
}

TEST(Commands, StopAllSaysOfEachRobotHowItStandsAlsoWhenOneHasJustDied) {
  OneRobot fleet;
  Puppet& r2 = fleet.add_robot("r2");
  fleet.run(1s);
  r2.answers = false;
  r2.speak_at = SteadyTime::max();
  const SteadyTime asked = fleet.now;
  const Said said = fleet.weft({"stop", "--all"});
  EXPECT_EQ(said.exit, Exit::failed);
  EXPECT_LT(fleet.now - asked, 4s) << "less than the server takes to count r2 as silent";
  EXPECT_NE(said.out.find("r1: stands"), std::string::npos) << said.out;
  EXPECT_NE(said.out.find("r2: not heard for"), std::string::npos) << said.out;
  EXPECT_NE(said.err.find("1 of 2 robots stand"), std::string::npos) << said.err;
}

TEST(Commands, ClearNeedsARobot) {
  OneRobot fleet;
  EXPECT_EQ(fleet.weft({"robot", "clear", "r9"}).exit, Exit::refused);
  const Said said = fleet.weft({"robot", "clear", "r1"});
  EXPECT_TRUE(said.exit == Exit::done || said.exit == Exit::refused);
  EXPECT_FALSE(said.out.empty() && said.err.empty());
}

TEST(Commands, RobotThatIsHeardIsClearedForSureAlone) {
  OneRobot fleet;
  const Said refused = fleet.weft({"robot", "clear", "r1"});
  EXPECT_EQ(refused.exit, Exit::refused);
  EXPECT_NE(refused.err.find("--yes"), std::string::npos) << refused.err;
  EXPECT_EQ(fleet.weft({"robot", "clear", "r1", "--yes"}).exit, Exit::done);
}

}  // namespace
}  // namespace weft::cli::test
