#include "agents/methods/advance.hpp"

#include <gtest/gtest.h>

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

TEST(Motion, TwoAreOne) {
  const Motion first{100ms, {0.6, 0.0}, WheelStep{0.06, 0.0}};
  const Motion second{300ms, {0.2, 0.4}, WheelStep{0.07, 0.1}};
  const Motion both = joined(first, second);
  EXPECT_EQ(both.elapsed, 400ms);
  EXPECT_NEAR(both.command.linear_m_s, 0.3, 1e-12) << "the same way as both, in the time of both";
  EXPECT_NEAR(both.command.angular_rad_s, 0.3, 1e-12);
  EXPECT_NEAR(both.wheels->distance_m, 0.13, 1e-12);
  EXPECT_NEAR(both.wheels->heading_rad, 0.1, 1e-12);
}

TEST(Motion, NothingBeforeIsNothing) {
  const Motion only{100ms, {0.6, 0.1}, std::nullopt};
  EXPECT_EQ(joined({}, only).command, only.command);
  EXPECT_FALSE(joined(Motion{100ms, {}, WheelStep{}}, only).wheels) << "one of them is not known";
}

}  // namespace
}  // namespace weft::agents
