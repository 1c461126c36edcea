#include "server/fleet/link_directions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"

namespace weft::server::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

struct LinkDirectionsTest : testing::Test {
  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};

  /// Says a state every second for so long, in which the robot has heard nothing for `unheard_s` at first and ever
  /// more.
  void speak(Duration time, double unheard_s, bool hears = false) {
    for (Duration at{}; at < time; at += 1s) {
      msg::RobotState state = site.state(r1, std::nullopt);
      state.server_unheard_s = hears ? 1.0 : unheard_s + seconds(at);
      state.server_gap_s = std::max(unheard_s, state.server_unheard_s);
      site.say(state);
      site.pass(1s);
    }
  }
};

TEST_F(LinkDirectionsTest, ARobotThatIsHeardAndHearsNothingIsDeaf) {
  site.arrive(r1, std::nullopt);
  speak(10s, 0.0, true);
  speak(3s, 0.0);
  EXPECT_THAT(site.events_of("robot.deaf"), IsEmpty());
  EXPECT_FALSE(site.row("r1").is_deaf);
  speak(3s, 3.0);
  ASSERT_THAT(site.events_of("robot.deaf"), SizeIs(1));
  EXPECT_THAT(site.events_of("robot.deaf").front(), HasSubstr("from the server to the robot is dead"));
  EXPECT_TRUE(site.row("r1").is_deaf);
  site.service().was_away(2s, site.now);  // has stood still
  speak(1s, 6.0);
  EXPECT_TRUE(site.row("r1").is_deaf) << "a server that was away does not make it hear";
  EXPECT_THAT(site.events_of("robot.hears"), IsEmpty());
  speak(1s, 0.0, true);
  EXPECT_THAT(site.events_of("robot.hears"), SizeIs(1));
  EXPECT_FALSE(site.row("r1").is_deaf);
}

TEST_F(LinkDirectionsTest, WhoHeardNothingFirstTellsWhichDirectionWasDead) {
  site.arrive(r1, std::nullopt);
  for (const auto& [gap_s, direction] :
       {std::pair(14.0, "from the robot to the server was dead"),
        std::pair(26.0, "from the server to the robot was dead"), std::pair(20.0, "its link was down")}) {
    speak(3s, 0.0, true);
    site.pass(20s);
    speak(2s, 21.0);  // it speaks before it has heard anything
    EXPECT_THAT(site.events_of("robot.deaf"), IsEmpty());
    msg::RobotState state = site.state(r1, std::nullopt);
    state.server_gap_s = gap_s;
    site.say(state);
    site.pass(1s);
    EXPECT_THAT(site.events_of("robot.unheard").back(), HasSubstr(direction));
  }
  EXPECT_THAT(site.events_of("robot.unheard"), SizeIs(3));
}

TEST_F(LinkDirectionsTest, NothingIsToldOfShortSilencesNorOfAnAgentThatWasStartedAnew) {
  site.arrive(r1, std::nullopt);
  speak(3s, 0.0, true);
  site.pass(9s);
  speak(1s, 0.0, true);
  site.pass(30s);
  r1.incarnation = 2;
  r1.sequence = 0;
  site.arrive(r1, std::nullopt);
  speak(1s, 0.0, true);
  EXPECT_THAT(site.events_of("robot.unheard"), IsEmpty());
}

}  // namespace
}  // namespace weft::server::test
