#include "clients/cli/commands.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
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
