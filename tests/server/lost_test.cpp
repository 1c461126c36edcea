#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"

/// Tests how a robot that does not know any more where it is calls for help.
namespace weft::server::test {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

TEST(Lost, IsRecordedWithWhatToDoOnceUntilItIsFound) {
  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  TaughtRun run{r1, 10};
  site.arrive(r1, std::nullopt);
  site.hand_in(r1, run.next(5));
  const auto say = [&](msg::RobotMode mode) {
    msg::RobotState state = site.state(r1, run.place(3));
    state.mode = mode;
    state.localised = mode != msg::RobotMode::lost;
    state.reason = mode == msg::RobotMode::lost ? "few_features" : "";
    site.say(state);
  };
  say(msg::RobotMode::driving);
  say(msg::RobotMode::lost);
  say(msg::RobotMode::lost);
  const std::vector<std::string> calls = site.events_of("robot.lost");
  ASSERT_THAT(calls, SizeIs(1));
  EXPECT_THAT(calls.front(), HasSubstr("needs help (few_features)"));
  EXPECT_THAT(calls.front(), HasSubstr("by place " + to_string(run.place(3))));
  EXPECT_THAT(calls.front(), HasSubstr("weft localise r1 --at LABEL"));
  say(msg::RobotMode::driving);
  EXPECT_THAT(site.events_of("robot.found"), SizeIs(1));
  say(msg::RobotMode::lost);
  EXPECT_THAT(site.events_of("robot.lost"), SizeIs(2));
}

}  // namespace
}  // namespace weft::server::test
