#include "clients/cli/teach_report.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "tests/clients/cli/fleet.hpp"

namespace weft::cli::test {
namespace {
using namespace std::chrono_literals;
using Kind = msg::AgentCommand::Kind;

constexpr ExperienceId kRun{0xE5};

msg::TaughtStretch stretch(double from_m, double as_is, double half_light, double worn,
                           const std::string& reason = {}) {
  return {from_m,
          from_m + 1.0,
          5,
          {kRun, static_cast<std::uint32_t>(5.0 * from_m)},
          {{"as_is", as_is, 0.0, 0.5},
           {"half_light", half_light, 0.0, 0.5},
           {"worn", worn, 0.0, 0.5},
           {"seen", 1.0, 0.0, 0.5}},
          0.004,
          reason};
}

/// Returns a report: dim from metre 1 on, blank in the fourth metre; the last stretch is shorter.
std::vector<msg::TaughtStretch> report() {
  std::vector<msg::TaughtStretch> rows = {
      stretch(0.0, 1.0, 0.8, 1.0, "half light: few_matches"), stretch(1.0, 1.0, 0.2, 0.8, "half light: few_matches"),
      stretch(2.0, 0.8, 0.0, 0.4, "half light: too_blank"), stretch(3.0, 0.0, 0.0, 0.0, "no place: too_blank"),
      stretch(4.0, 1.0, 1.0, 0.4, "worn: few_matches")};
  rows.back().to_m = 4.6;
  return rows;
}

struct TaughtRobot : Fleet {
  TaughtRobot() : r1(add_robot("r1")) {
    r1.how = [](const msg::AgentCommand&, msg::AgentReply& reply) {
      reply.experience = kRun;
      reply.report = report();
    };
    run(1s);
  }
  Puppet& r1;
};

TEST(TeachReportAdvice, NamesTheMetresAndWhatToDo) {
  const std::vector<std::string> advice = advice_of(report());
  ASSERT_EQ(advice.size(), 3U);
  EXPECT_EQ(advice[0].substr(0, 47), "metres 1..3 will not be found in half the light");
  EXPECT_NE(advice[0].find("clean the lens"), std::string::npos);
  EXPECT_EQ(advice[1].substr(0, 49), "metres 3..4 will not be found again as they are: ");
  EXPECT_EQ(advice[2].substr(0, 56), "metres 4..4.6 will not be found on a worn or dirty floor");
}

TEST(TeachReportAdvice, NamesAConditionThatItDoesNotKnow) {
  msg::TaughtStretch dusty = stretch(0.0, 1.0, 1.0, 1.0);
  dusty.found.push_back({"dusty", 0.1, 0.0, 0.5});
  const std::vector<std::string> advice = advice_of({dusty});
  ASSERT_EQ(advice.size(), 1U);
  EXPECT_EQ(advice[0].substr(0, 47), "metres 0..1 will not be found under \"dusty\": te");
}

TEST(TeachReportAdvice, NamesMetresThatWereDrivenBlind) {
  msg::TaughtStretch dark = stretch(2.0, 1.0, 1.0, 1.0, "seen: dark");
  dark.found.back().value = 0.3;
  const std::vector<std::string> advice = advice_of({dark});
  ASSERT_EQ(advice.size(), 1U);
  EXPECT_EQ(advice[0].substr(0, 37), "metres 2..3 were driven nearly blind:");
}

TEST(TeachReportAdvice, NothingToDoIsNothingSaid) {
  EXPECT_TRUE(advice_of({stretch(0.0, 1.0, 0.8, 0.6)}).empty());
  EXPECT_TRUE(advice_of({}).empty());
}

TEST(TeachReport, IsATable) {
  TaughtRobot fleet;
  const Said said = fleet.weft({"teach", "r1", "report"});
  ASSERT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_EQ(fleet.r1.told.back().kind, Kind::teach_report);
  EXPECT_NE(said.out.find("HALF LIGHT"), std::string::npos) << said.out;
  EXPECT_NE(said.out.find("0..1    5       100 %  80 %"), std::string::npos) << said.out;
  EXPECT_NE(said.out.find("no place: too_blank"), std::string::npos) << said.out;
  EXPECT_NE(said.out.find("metres 1..3 will not be found"), std::string::npos) << said.out;
}

TEST(TeachReport, SaysThatAllIsWell) {
  TaughtRobot fleet;
  fleet.r1.how = [](const msg::AgentCommand&, msg::AgentReply& reply) { reply.report = {stretch(0.0, 1, 1, 1)}; };
  EXPECT_NE(fleet.weft({"teach", "r1", "report"})
                .out.find("all 1 m will be found again, in half the light and on a worn floor too\n"),
            std::string::npos);
}

TEST(TeachReport, IsADocument) {
  TaughtRobot fleet;
  const auto document = fleet.weft({"teach", "r1", "report", "--json"}).json();
  EXPECT_EQ(document["experience"], "00000000000000e5");
  ASSERT_EQ(document["stretches"].size(), 5U);
  EXPECT_EQ(document["stretches"][1]["half_light"], 0.2);
  EXPECT_EQ(document["stretches"][1]["first"], "00000000000000e5:5");
  EXPECT_EQ(document["advice"].size(), 3U);
}

TEST(TeachReport, IsDrawn) {
  TaughtRobot fleet;
  for (const char* const name : {"taught.png", "taught.svg"}) {
    const std::string file = (folder() / name).string();
    EXPECT_EQ(fleet.weft({"teach", "r1", "report", "--draw", file}).exit, Exit::done);
    EXPECT_GT(std::filesystem::file_size(file), 3000U);
  }
  const auto misnamed = fleet.weft({"teach", "r1", "report", "--draw", "taught.bmp"});
  EXPECT_EQ(misnamed.exit, Exit::usage);
  EXPECT_EQ(misnamed.out, "") << "told before the robot is asked";
  EXPECT_NE(fleet.weft({"teach", "r1", "report", "--draw", "/nowhere/a.png"}).exit, Exit::done);
}

TEST(TeachReport, ARefusalCarriesTheRobotsWords) {
  TaughtRobot fleet;
  fleet.r1.how = [](const msg::AgentCommand&, msg::AgentReply& reply) {
    reply.done = false;
    reply.reason = "r1: nothing has been taught since its agent started";
  };
  const Said said = fleet.weft({"teach", "r1", "report"});
  EXPECT_EQ(said.exit, Exit::refused);
  EXPECT_NE(said.err.find("nothing has been taught"), std::string::npos);
}

}  // namespace
}  // namespace weft::cli::test
