#include <gtest/gtest.h>

#include "agents/agent/diagnostic_watch.hpp"
#include "agents/methods/floor/floor.hpp"
#include "clients/evaluate/floor/drive.hpp"
#include "clients/evaluate/floor/driven_robot.hpp"
#include "tests/clients/evaluate/floor/small_hall.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate::floor {
namespace {

class ABodyUnderLoad : public testing::Test {
 protected:
  void teach_with(double mount_error_m, double focal_error) {
    const Result<agents::sim::Site> site = agents::sim::parse_site(small_hall(8.0, 6.0, 3.0), "hall.toml");
    ASSERT_TRUE(site) << site.error().message;
    drive.body.site = *site;
    drive.body.site.disturbances.mount_error_m = mount_error_m;
    drive.body.site.disturbances.focal_error = focal_error;
    drive.body.site.disturbances.centre_error_px = focal_error / 0.003;
    drive.body.site.disturbances.distortion_error_px = 0.5 * focal_error / 0.003;
    drive.body.robot = "r1";
    drive.body.truth_path = (folder.path() / "truth").string();
    drive.asked_to_stop = [] { return false; };
    const Result<bool> done = teach(drive, {{2.0, 3.0}, {5.0, 3.0}}, taught);
    ASSERT_TRUE(done) << done.error().message;
  }

  /// Drives another robot, sunk by so much, to the last place.
  void repeat_sunk(double sinks_m, agents::DiagnosticWatch& noticing) {
    Drive second = drive;
    second.body.site.change.sinks_m = sinks_m;
    second.body.site.robots.front().seed = 3;
    second.body.day = 1;
    Result<DrivenRobot> robot = DrivenRobot::make(second.body, {});
    ASSERT_TRUE(robot) << robot.error().message;
    robot->navigator().seek(std::nullopt);
    bool on_its_way = false;
    bool arrived = false;
    for (int i = 0; i < 900 && !arrived; ++i) {
      const Result<DrivenRobot::Stepped> stepped = robot->step(taught.map.view());
      ASSERT_TRUE(stepped) << stepped.error().message;
      const auto& fix = stepped->navigated.fix;
      if (fix && !fix->evidence.diagnostics.empty())
        noticing.add(fix->place.experience, fix->evidence.diagnostics.front().value);
      arrived = stepped->navigated.following == agents::Following::arrived;
      if (on_its_way || !robot->navigator().estimate()) continue;
      const auto route = taught.map.route(robot->navigator().estimate()->place, taught.last, "floor");
      ASSERT_TRUE(route) << route.error().message;
      robot->navigator().follow(*route);
      on_its_way = true;
    }
    EXPECT_TRUE(arrived);
  }

  storage::TemporaryDirectory folder;
  Drive drive;
  Taught taught;
  agents::DiagnosticWatch watch{agents::Floor::watched.front()};
};

TEST_F(ABodyUnderLoad, NoticesThatItStandsACentimetreLowerThanItsPlacesSay) {
  teach_with(0.0005, 0.0005);  // both cameras calibrated
  repeat_sunk(0.0, watch);
  EXPECT_EQ(watch.notice(), "");
  agents::DiagnosticWatch restarted{agents::Floor::watched.front()};
  repeat_sunk(0.010, restarted);
  ASSERT_TRUE(restarted.value());
  EXPECT_NEAR(*restarted.value(), -0.010, 0.003);
  EXPECT_NE(restarted.notice().find("mm lower than its places say"), std::string::npos) << restarted.notice();
}

TEST_F(ABodyUnderLoad, NoticesItWithCamerasThatNobodyCalibratedWhenItHasBeenThereBefore) {
  teach_with(0.003, 0.003);
  repeat_sunk(0.0, watch);
  repeat_sunk(0.0, watch);
  EXPECT_EQ(watch.notice(), "");
  repeat_sunk(0.010, watch);
  ASSERT_TRUE(watch.change());
  EXPECT_NEAR(*watch.change(), -0.010, 0.003);
  EXPECT_NE(watch.notice().find("mm lower than"), std::string::npos) << watch.notice();
}

}  // namespace
}  // namespace weft::evaluate::floor
