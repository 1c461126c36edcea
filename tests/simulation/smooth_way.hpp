#pragma once
#include <gtest/gtest.h>

#include "tests/simulation/course.hpp"

namespace weft::simulation {

/// Expects that steps of `step_m` along a course, round it and on, are as long as that and turn no more than so much.
inline void expect_one_smooth_closed_way(const Course& course, double step_m, double most_turn_rad) {
  Pose2 before = course.at(0.0);
  for (double along = step_m; along < course.length_m() + 2.0 * step_m; along += step_m) {
    const Pose2 here = course.at(along);
    const Pose2 moved = before.inverse() * here;
    ASSERT_NEAR(moved.translation().norm(), step_m, 1e-4) << along;
    ASSERT_NEAR(moved.heading, 0.0, most_turn_rad) << along;
    before = here;
  }
}

}  // namespace weft::simulation
