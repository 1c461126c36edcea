#include "agents/bodies/sim/hall/movers.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::agents::sim {
namespace {

Mover walker() {
  return {Mover::Kind::person, {{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}}, 1.0, 0.0};
}

TEST(Movers, GoToAndFro) {
  const auto expect = [](double time_s, double x, double y, double heading) {
    const Pose2 pose = pose_of(walker(), time_s);
    EXPECT_NEAR(pose.x, x, 1e-9) << time_s;
    EXPECT_NEAR(pose.y, y, 1e-9) << time_s;
    EXPECT_NEAR(std::abs(wrap_angle(pose.heading - heading)), 0.0, 1e-9) << time_s;
  };
  expect(1.0, 1.0, 0.0, 0.0);
  expect(5.5, 4.0, 1.5, M_PI / 2);
  expect(8.5, 4.0, 1.5, -M_PI / 2);
  expect(13.0, 1.0, 0.0, M_PI);
  expect(15.0, 1.0, 0.0, 0.0);
}

TEST(Movers, BeginSomewhereAlongTheirWay) {
  Mover mover = walker();
  mover.begins_m = 5.0;
  mover.speed_m_s = 0.0;
  EXPECT_NEAR(pose_of(mover, 100.0).y, 1.0, 1e-9);
}

TEST(Movers, StandOnTheFloorWhereTheyAre) {
  for (const Mover::Kind kind : {Mover::Kind::person, Mover::Kind::forklift}) {
    Mover mover = walker();
    mover.kind = kind;
    std::vector<Quad> quads;
    add_mover(mover, 1, 2.0, quads);
    float lowest = 10.0F;
    float highest = 0.0F;
    for (const Quad& quad : quads) {
      const Eigen::Vector3f middle = quad.at(0.5F, 0.5F);
      EXPECT_LT(std::hypot(middle.x() - 2.0F, middle.y()), 2.0F);
      lowest = std::min(lowest, std::min(quad.at(0, 0).z(), quad.at(1, 1).z()));
      highest = std::max(highest, std::max(quad.at(0, 0).z(), quad.at(1, 1).z()));
    }
    EXPECT_NEAR(lowest, 0.0F, 1e-6F);
    EXPECT_GT(highest, 1.6F);
    EXPECT_LT(highest, 2.5F);
  }
}

}  // namespace
}  // namespace weft::agents::sim
