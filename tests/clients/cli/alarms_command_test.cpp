#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "tests/clients/cli/one_robot.hpp"

/// Tests `weft alarms`.
namespace weft::cli::test {
namespace {
using namespace std::chrono_literals;
using testing::HasSubstr;

TEST(AlarmsCommand, AFleetThatIsWellHasNone) {
  OneRobot fleet;
  const Said said = fleet.weft({"alarms"});
  EXPECT_EQ(said.exit, Exit::done) << said.out;
  EXPECT_EQ(said.out, "no alarms\n");
  EXPECT_EQ(fleet.weft({"alarms", "--json"}).json(), (nlohmann::json{{"alarms", nlohmann::json::array()}}));
}

TEST(AlarmsCommand, EachHasSinceWhenCauseAndCure) {
  OneRobot fleet;
  fleet.r1.state.mode = msg::RobotMode::lost;
  fleet.r1.state.reason = "no fix for 3 m";
  fleet.r1.state.spool_refuses = "/var/lib/weft: no space left";
  fleet.run(30s);
  const Said said = fleet.weft({"alarms"});
  EXPECT_EQ(said.exit, Exit::failed);
  EXPECT_THAT(said.out, HasSubstr("lost: r1, since "));
  EXPECT_THAT(said.out, HasSubstr("no fix for 3 m\n  cause: the robot does not know where it is"));
  EXPECT_THAT(said.out, HasSubstr("cure: `weft localise"));
  const nlohmann::json document = fleet.weft({"alarms", "--json"}).json();
  ASSERT_EQ(document["alarms"].size(), 2U) << document;
  EXPECT_EQ(document["alarms"][0]["kind"], "lost");
  EXPECT_EQ(document["alarms"][0]["robot"], "r1");
  EXPECT_EQ(document["alarms"][0]["place"], to_string(PlaceId{fleet.first, 4}));
  EXPECT_EQ(document["alarms"][1]["kind"], "spool");
  EXPECT_EQ(document["alarms"][1]["detail"], "/var/lib/weft: no space left");
  const nlohmann::json later = [&] {
    fleet.run(30s);
    return fleet.weft({"alarms", "--json"}).json();
  }();
  EXPECT_EQ(later["alarms"][0]["since"], document["alarms"][0]["since"]);
  fleet.r1.state.mode = msg::RobotMode::idle;
  fleet.r1.state.spool_refuses.clear();
  fleet.run(5s);
  EXPECT_EQ(fleet.weft({"alarms"}).exit, Exit::done);
}

TEST(AlarmsCommand, AStoreThatRefusesEndsByItselfWhenThereIsRoom) {
  OneRobot fleet;
  fleet.disk->faults.full = true;
  std::ignore = fleet.weft({"map", "label", to_string(PlaceId{fleet.first, 3}), "gate"});
  const nlohmann::json document = fleet.weft({"alarms", "--json"}).json();
  ASSERT_EQ(document["alarms"].size(), 2U) << document;
  EXPECT_EQ(document["alarms"][0]["kind"], "store");
  EXPECT_EQ(document["alarms"][0]["robot"], nullptr);
  EXPECT_EQ(document["alarms"][1]["kind"], "disk");
  fleet.disk->faults.full = false;
  fleet.run(10s);
  EXPECT_EQ(fleet.weft({"alarms"}).out, "no alarms\n") << "though nobody has written";
}

}  // namespace
}  // namespace weft::cli::test
