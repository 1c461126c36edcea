#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/simulation/site.hpp"
#include "tests/simulation/smooth_way.hpp"

namespace weft::simulation {
namespace {

class Courses : public testing::TestWithParam<std::string> {
 protected:
  Site site = make_site(GetParam(), Random(1));
  const Course& course = site.course();
};

TEST_P(Courses, IsOneClosedWayThatIsSmooth) {
  expect_one_smooth_closed_way(course, 0.01, 0.01);
}

TEST_P(Courses, LessonsHoldTheWholeCourseAndEveryStation) {
  for (std::size_t robots = 1; robots <= 8; ++robots) {
    std::set<int> metres;
    std::multiset<std::size_t> stations;
    for (std::size_t robot = 0; robot < robots; ++robot) {
      const Lesson lesson = course.lesson(robot, robots);
      EXPECT_DOUBLE_EQ(lesson.from_m, course.start_m(robot, robots));
      for (double at = lesson.from_m; at < lesson.to_m; at += 0.5)
        metres.insert(static_cast<int>(std::fmod(at, course.length_m())));
      stations.insert(lesson.through.begin(), lesson.through.end());
    }
    EXPECT_EQ(metres.size(), static_cast<std::size_t>(std::ceil(course.length_m()))) << robots;
    for (std::size_t k = 0; k < course.stations().size(); ++k) EXPECT_EQ(stations.count(k), 1U) << k;
  }
}

TEST_P(Courses, RobotsStandApartAndOnTheCourseAtFirst) {
  for (std::size_t robots = 1; robots <= 8; ++robots) {
    for (std::size_t i = 0; i < robots; ++i) {
      const double start = course.start_m(i, robots);
      const Pose2 here = course.at(start);
      for (std::size_t k = 0; k < i; ++k) {
        const Pose2 there = course.at(course.start_m(k, robots));
        EXPECT_GT((here.translation() - there.translation()).norm(), 1.0) << i << " and " << k << " of " << robots;
      }
      const auto through = course.lesson(i, robots).through;
      if (GetParam() == "aisles") {
        EXPECT_EQ(site.pose(start, through).translation(), here.translation()) << i << " of " << robots;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Courses, testing::ValuesIn(site_names()));

/// Returns whether some lane comes by a spot of another part of the course at about that angle.
bool meets(const Course& course, double angle_rad) {
  constexpr double step_m = 0.1;
  for (double a = 0.0; a < course.length_m(); a += step_m) {
    for (double b = a + 5.0; b < course.length_m(); b += step_m) {
      const Pose2 apart = course.at(a).inverse() * course.at(b);
      if (apart.translation().norm() < 0.1 && std::abs(std::abs(apart.heading) - angle_rad) < 0.1) return true;
    }
  }
  return false;
}

TEST(Aisles, AreDrivenBothWaysAndCrossed) {
  const Site aisles = make_site("aisles", Random(1));
  EXPECT_TRUE(meets(aisles.course(), M_PI));
  EXPECT_TRUE(meets(aisles.course(), M_PI / 2.0));
  const Site ring = make_site("ring", Random(1));
  EXPECT_FALSE(meets(ring.course(), M_PI));
  EXPECT_FALSE(meets(ring.course(), M_PI / 2.0));
}

}  // namespace
}  // namespace weft::simulation
