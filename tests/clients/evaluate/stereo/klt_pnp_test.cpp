#include "clients/evaluate/stereo/klt_pnp.hpp"

#include <gtest/gtest.h>

#include "agents/perception/stereo/rectifier.hpp"
#include "tests/clients/evaluate/stereo/rendered_recording.hpp"

namespace weft::evaluate::stereo {
namespace {

TEST(KltPnp, SeesHowACameraMoved) {
  const agents::Sensor sensor = test::small_sensor();
  const auto rectifier = agents::Rectifier::make(sensor);
  ASSERT_TRUE(rectifier);
  const weft::test::StereoRoom room = weft::test::crate_room();
  KltPnp klt(rectifier->rig());
  EXPECT_FALSE(klt.step(room.pair(sensor, test::room_from_robot(0))));
  const auto step = klt.step(room.pair(sensor, test::room_from_robot(1)));
  ASSERT_TRUE(step);
  const Pose3& mount = sensor.camera.robot_from_camera;
  const Pose3 truth = mount.inverse() * test::room_from_robot(0).inverse() * test::room_from_robot(1) * mount;
  const Vector6d off = se3_log(truth.inverse() * *step);
  EXPECT_LT(off.head<3>().norm(), 0.01);
  EXPECT_LT(off.tail<3>().norm(), 0.01);
}

TEST(KltPnp, IsBlindWithoutCorners) {
  const agents::Sensor sensor = test::small_sensor();
  KltPnp klt(agents::Rectifier::make(sensor)->rig());
  const agents::Image grey =
      weft::test::filled(weft::test::crate_room().pair(sensor, test::room_from_robot(0)).left, 90);
  EXPECT_FALSE(klt.step({grey, grey}));
  EXPECT_FALSE(klt.step({grey, grey}));
}

}  // namespace
}  // namespace weft::evaluate::stereo
