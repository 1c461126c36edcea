#include "tests/simulation/grid_course.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/simulation/site.hpp"
#include "tests/simulation/smooth_way.hpp"

namespace weft::simulation {
namespace {

class GridCourses : public testing::TestWithParam<std::size_t> {
 protected:
  GridCourse course{GetParam()};
};

TEST_P(GridCourses, IsOneClosedWayThatIsSmooth) {
  expect_one_smooth_closed_way(course, 0.02, 0.04);
}

/// Expects so many metres of aisles for each robot. The course leads four times through each, less what turns cut
/// off.
TEST_P(GridCourses, HasTheAislesThatSoManyRobotsWant) {
  const double each_m = course.length_m() / 4.0 / static_cast<double>(GetParam());
  EXPECT_GT(each_m, 20.0);
  EXPECT_LT(each_m, 80.0);
  EXPECT_GE(course.dead_ends(), 2U);
  EXPECT_GT(course.stations().size(), GetParam());
}

TEST_P(GridCourses, RobotsStandApartAtFirst) {
  for (std::size_t i = 0; i < GetParam(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const Pose2 apart =
          course.at(course.start_m(i, GetParam())).inverse() * course.at(course.start_m(k, GetParam()));
      ASSERT_GT(apart.translation().norm(), 4.0) << i << " and " << k;
    }
  }
}

TEST_P(GridCourses, DrivesEveryAisleBothWays) {
  std::set<std::tuple<int, int, int>> lanes;  // by the middle of an aisle, and where it is driven to
  for (double along = 0.0; along < course.length_m(); along += 0.25) {
    const Pose2 here = course.at(along);
    const auto eighths = [](double metres) { return static_cast<int>(std::lround(metres / 4.0)); };
    const bool is_middle =
        std::abs(here.x - 4.0 * eighths(here.x)) < 0.2 && std::abs(here.y - 4.0 * eighths(here.y)) < 0.2;
    const bool is_inside = here.y > -1.0 && here.y < course.north_m() + 1.0;
    const int quarters = static_cast<int>(std::lround(here.heading / (M_PI / 2.0)) + 4) % 4;
    if (is_middle && is_inside && (eighths(here.x) + eighths(here.y)) % 2 != 0)
      lanes.insert({eighths(here.x), eighths(here.y), quarters});
  }
  const auto columns = static_cast<std::size_t>(std::lround(course.east_m() / 8.0)) + 1;
  const auto rows = static_cast<std::size_t>(std::lround(course.north_m() / 8.0)) + 1;
  EXPECT_EQ(lanes.size(), 2 * (columns * (rows - 1) + rows * (columns - 1)));
}

INSTANTIATE_TEST_SUITE_P(OfSizes, GridCourses, testing::Values(4, 10, 50, 200));

}  // namespace
}  // namespace weft::simulation
