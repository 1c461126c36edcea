#include "clients/evaluate/bearing/model.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::evaluate::bearing {
namespace {

/// Returns a course that leads straight on, or round a circle once.
Course course_of(double length_m, double turn_rad) {
  Course course;
  constexpr int kHops = 100;
  Pose2 pose;
  for (int i = 0; i <= kHops; ++i) {
    PlaceId id;
    id.index = static_cast<std::uint32_t>(i);
    course.places.push_back(id);
    course.site_from_place.push_back(pose);
    course.along_m.push_back(length_m * i / kHops);
    course.relations.emplace_back(AlongPath{length_m / kHops, 0.0, turn_rad / kHops});
    pose = pose * se2_exp({length_m / kHops, 0.0, turn_rad / kHops});
  }
  course.relations.back() = AlongPath{};
  course.length_m = length_m;
  return course;
}

TEST(BearingModel, OnAStraightWhatIsAsideDecaysAndWhatIsAheadStays) {
  const auto aside = modelled(course_of(6.0, 0.0), {0.0, -1.0}, 2.0);
  EXPECT_NEAR(aside.back().error_m, std::exp(-6.0 / 2.0), 0.005);
  const auto ahead = modelled(course_of(6.0, 0.0), {0.4, 0.0}, 2.0);
  EXPECT_NEAR(ahead.back().error_m, 0.4, 1e-9);
}

TEST(BearingModel, InABendBothDecay) {
  // Eigenvalues with real parts of -1 / (2 l) each, as omega > v / (2 l).
  const auto bend = modelled(course_of(12.0, 12.0), {0.4, 0.0}, 2.0);
  EXPECT_LT(bend.back().error_m, 0.4 * std::exp(-12.0 / 4.0) * 1.5);
}

TEST(BearingModel, FurtherLandmarksMeanSlowerConvergence) {
  // As said of the 10 m oval: the further away l is, the more is left.
  double before = 0.0;
  for (const double landmark_m : {1.0, 2.0, 5.0}) {
    const double left = modelled(course_of(20.0, 4.0 * M_PI), {0.0, -1.0}, landmark_m).back().error_m;
    EXPECT_GT(left, before);
    before = left;
  }
}

TEST(BearingModel, TheBandIsTheLargestDifference) {
  const std::vector<ErrorAt> model = {{0.0, 1.0}, {2.0, 0.5}, {4.0, 0.25}};
  EXPECT_NEAR(band_of({{2.0, 0.6}, {4.0, 0.2}}, model), 0.1, 1e-12);
  EXPECT_NEAR(band_of({{0.0, model.front().error_m + 0.3}, {2.0, 0.6}}, model), 0.3, 1e-12)
      << "from its beginning on";
  EXPECT_NEAR(band_of({{3.0, 0.375}}, model), 0.0, 1e-12) << "between two places it lies between theirs";
}

TEST(BearingModel, AlongAClosedWayGoesOnWhereItCloses) {
  const std::vector<double> all = unwrapped({9.9, 0.1, 5.0, 9.8, 0.1, 9.9, 0.2}, 10.0);
  const std::vector<double> wanted = {-0.1, 0.1, 5.0, 9.8, 10.1, 9.9, 10.2};
  ASSERT_EQ(all.size(), wanted.size());
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_NEAR(all[i], wanted[i], 1e-12) << i;
}

TEST(BearingModel, TheFirstLoopEndsWhereTheTaughtWayEnds) {
  const Course course = course_of(6.0, 2.0 * M_PI);
  Repeated repeated;
  for (const double along_m : {5.95, 0.0, 2.5, 4.5, 5.9, 0.05, 1.0}) {
    Deviation deviation;
    deviation.along_m = along_m;
    repeated.along.push_back(deviation);
  }
  const std::vector<ErrorAt> first = first_loop_of(repeated, course);
  ASSERT_EQ(first.size(), 5U);
  for (std::size_t i = 1; i < first.size(); ++i) EXPECT_GT(first[i].along_m, first[i - 1].along_m);
  EXPECT_NEAR(first.front().along_m, -0.05, 1e-12);
  EXPECT_NEAR(first.back().along_m, 5.9, 1e-12);
}

TEST(BearingCourse, AWayIsWhereItsPlacesTrulyWereRoundTheEnd) {
  Course course = course_of(2.0 * M_PI, 2.0 * M_PI);
  EXPECT_NEAR(course.site_from_path(25, 0.0).heading, M_PI / 2.0, 1e-9);
  EXPECT_NEAR(course.site_from_path(24, 2.0 * M_PI / 100.0).y, course.site_from_place[25].y, 1e-9);
  EXPECT_NEAR(course.site_from_path(100, 2.0 * M_PI / 200.0).x, course.site_from_path(0, 2.0 * M_PI / 200.0).x, 1e-9);
  EXPECT_NEAR(course.site_from_path(0, -2.0 * M_PI / 200.0).y, course.site_from_path(99, 2.0 * M_PI / 200.0).y, 1e-9);
}

TEST(BearingCourse, AnEndBeyondTheBeginningIsNoWayBack) {
  Course course = course_of(2.0 * M_PI, 2.0 * M_PI);
  course.relations.back() = AlongPath{-0.02};  // the last place lies 2 cm beyond the first
  EXPECT_NEAR(course.site_from_path(100, 0.05).y, course.site_from_path(0, 0.07).y, 1e-9);
}

TEST(BearingCourse, LoopsAreOneRoute) {
  const Course course = course_of(6.0, 0.0);
  const Route route = course.loops(3);
  EXPECT_EQ(route.places.size(), 3 * 101 + 1U);
  EXPECT_EQ(route.relations.size() + 1, route.places.size());
  EXPECT_EQ(route.places[101], route.places[0]);
  EXPECT_EQ(route.released, route.places.size() - 1);
}

}  // namespace
}  // namespace weft::evaluate::bearing
