#include "clients/evaluate/floor/taught_path.hpp"

#include <gtest/gtest.h>

#include "tests/clients/evaluate/floor/driven_trace.hpp"

namespace weft::evaluate::floor {
namespace {

TEST(TaughtPath, LeftIsPositiveAndHeadingsAreAgainstThePath) {
  const TaughtPath path(straight_trace(0.5, 4.0));
  EXPECT_NEAR(path.length_m(), 4.0, 1e-6);
  const TaughtPath::Nearest left = path.nearest({1.234, 0.03, 0.1});
  EXPECT_NEAR(left.along_m, 1.234, 1e-6);
  EXPECT_NEAR(left.lateral_m, 0.03, 1e-6);
  EXPECT_NEAR(left.heading_rad, 0.1, 1e-6);
  EXPECT_NEAR(path.nearest({2.0, -0.02, -0.1}).lateral_m, -0.02, 1e-6);
  EXPECT_NEAR(path.nearest({4.3, 0.4, 0.0}).lateral_m, 0.5, 1e-6);
}

TEST(TaughtPath, AStandingRobotAddsNothing) {
  Trace trace = straight_trace(0.5, 1.0);
  for (int i = 0; i < 50; ++i) trace.moments.push_back(trace.moments.back());
  EXPECT_NEAR(TaughtPath(trace).length_m(), 1.0, 1e-6);
}

TEST(TaughtPath, APathThatComesBySecondTimeIsNotTakenForItself) {
  Trace there = straight_trace(0.5, 4.0);
  Trace back = there;
  for (Moment& moment : back.moments) moment.site_from_robot = {4.0 - moment.site_from_robot.x, 0.04, 3.14159265};
  there.moments.insert(there.moments.end(), back.moments.begin(), back.moments.end());
  const TaughtPath path(there);
  EXPECT_NEAR(path.nearest({1.0, 0.03, 0.0}, 1.0, 0.5).along_m, 1.0, 1e-3);
  EXPECT_NEAR(path.nearest({1.0, 0.01, 0.0}, 7.0, 0.5).along_m, 7.04, 1e-2);
}

}  // namespace
}  // namespace weft::evaluate::floor
