#include <gtest/gtest.h>

#include <chrono>
#include <tuple>

#include "tests/clients/cli/one_robot.hpp"

/// Tests what `weft doctor` finds.
namespace weft::cli::test {
namespace {
using namespace std::chrono_literals;

TEST(Doctor, NamesRobotsThatDoNotKnowWhereTheyAreAndGoalsThatGetNowhere) {
  OneRobot fleet;
  fleet.r1.state.localised = false;
  fleet.run(2s);
  std::ignore = fleet.weft({"goal", "send", "--to", "packing", "--no-return", "--robot", "r1"});
  fleet.run(70s);
  const Said said = fleet.weft({"doctor"});
  EXPECT_EQ(said.exit, Exit::failed);
  EXPECT_NE(said.out.find("does not know where it is: weft localise r1"), std::string::npos) << said.out;
  EXPECT_NE(said.out.find("to packing is pending for"), std::string::npos) << said.out;
}

TEST(Doctor, FindsWhatIsWrong) {
  OneRobot fleet;
  const auto well = fleet.weft({"doctor", "--json"}).json();
  EXPECT_EQ(well["server"]["vendor"], "inprocess");
  EXPECT_EQ(well["client"]["vendor"], "inprocess");
  EXPECT_EQ(well["server"]["software"], well["client"]["software"]);
  fleet.r1.state.mode = msg::RobotMode::faulted;
  fleet.r1.state.reason = "camera unplugged";
  fleet.run(2s);
  const Said said = fleet.weft({"doctor"});
  EXPECT_EQ(said.exit, Exit::failed);
  EXPECT_NE(said.out.find("camera unplugged"), std::string::npos);
}

TEST(Doctor, NamesRobotsInPartsThatNothingJoins) {
  OneRobot fleet;
  Puppet& r2 = fleet.add_robot("r2");
  Batch batch;
  batch.experience = {0xC3};
  batch.sequence = 1;
  batch.robot = r2.id;
  batch.method = "marks";
  Place alone;
  alone.id = {batch.experience, 0};
  alone.method = "marks";
  alone.robot = r2.id;
  alone.content = {content_hash(), content_bytes().size()};
  batch.places = {alone};
  msg::ExperienceBatch handed;
  handed.header.sender = r2.id;
  handed.header.incarnation = 1;
  handed.batch = batch;
  fleet.service->handle(handed, {.steady = fleet.now, .wall = {}});
  r2.state.localised = true;
  r2.state.place = alone.id;
  fleet.run(2s);
  const Said said = fleet.weft({"doctor"});
  EXPECT_EQ(said.exit, Exit::failed);
  EXPECT_NE(said.out.find("nothing in the map joins the part with r1 and that with r2"), std::string::npos)
      << said.out;
}

TEST(Doctor, NamesAgentsOfAnotherVersion) {
  OneRobot fleet;
  EXPECT_EQ(fleet.weft({"doctor"}).out.find("PROBLEM"), std::string::npos);
  fleet.add_robot("r9", "0.1.00");  // contains the server's, and is another one
  fleet.run(1s);
  const Said said = fleet.weft({"doctor"});
  EXPECT_EQ(said.exit, Exit::failed);
  EXPECT_NE(said.out.find("version 0.1.00, the server's 0.1.0"), std::string::npos) << said.out;
}

}  // namespace
}  // namespace weft::cli::test
