#include <gtest/gtest.h>

#include "tests/agents/agent/rig.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;
using Kind = msg::AgentCommand::Kind;

/// Arranges a robot that was taught 3 m, the last of which has not been tried yet.
class TeachReports : public testing::Test {
 protected:
  TeachReports() {
    rig.run(4s);
    TeachReport way;
    way.experience = {0xE5};
    way.conditions = {"as_is", "half_light"};
    way.driven_m = 3.0;
    for (std::uint32_t i = 0; i < 15; ++i) {
      TaughtPlace place{{way.experience, i}, 0.2 * i, std::nullopt};
      if (i < 10) place.trials = Trials{Trial{true, {}, 0.004}, Trial{i < 5, "few_matches", 0.0}};
      way.places.push_back(place);
    }
    rig.script->way = way;
  }
  msg::AgentReply answer(const std::string& name = {}) {
    msg::AgentCommand command = rig.command(Kind::teach_report, ++asked);
    command.name = name;
    rig.tell(command);
    return *rig.last<msg::AgentReply>();
  }

  Rig rig;
  std::uint64_t asked = 0;
};

TEST_F(TeachReports, SaysMetreByMetreHowFarItHasCome) {
  const msg::AgentReply reply = answer();
  ASSERT_TRUE(reply.done) << reply.reason;
  EXPECT_EQ(reply.experience, (ExperienceId{0xE5}));
  ASSERT_EQ(reply.report.size(), 2U);
  EXPECT_EQ(reply.report[0],
            (msg::TaughtStretch{0.0,
                                1.0,
                                5,
                                {{0xE5}, 0},
                                {{"as_is", 1.0, 0.0, 0.5}, {"half_light", 1.0, 0.0, 0.5}, {"seen", 1.0, 0.0, 0.5}},
                                reply.report[0].sigma_m,
                                ""}));
  EXPECT_NEAR(reply.report[0].sigma_m, 0.004, 1e-9);
  EXPECT_EQ(reply.report[1].found[0], (Diagnostic{"as_is", 1.0, 0.0, 0.5}));
  EXPECT_EQ(reply.report[1].found[1], (Diagnostic{"half_light", 0.0, 0.0, 0.5}));
  EXPECT_EQ(reply.report[1].reason, "half light: few_matches");
  EXPECT_TRUE(answer("00000000000000e5").done);
}

TEST_F(TeachReports, RefusesWhatItDoesNotKnow) {
  const msg::AgentReply other = answer("loop");
  EXPECT_FALSE(other.done);
  EXPECT_NE(other.reason.find("00000000000000e5"), std::string::npos) << other.reason;
  for (TaughtPlace& place : rig.script->way->places) place.trials.reset();
  EXPECT_FALSE(answer().done);
  EXPECT_NE(answer().reason.find("lead it on"), std::string::npos);
  rig.script->way = fail(ErrorCode::refused, "nothing has been taught since its agent started");
  EXPECT_FALSE(answer().done);
  EXPECT_NE(answer().reason.find("nothing has been taught"), std::string::npos);
}

}  // namespace
}  // namespace weft::agents::test
