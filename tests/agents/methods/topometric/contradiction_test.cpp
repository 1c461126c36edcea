// Aisles 1 and 3 of deploy/sites/topometric/aisles.toml hold the same, 8.2 m apart. At the end of the cross aisle,
// north of aisle 2, one looks on to the next racks, and north of aisle 4 there is a plain wall.
#include "agents/methods/topometric/contradiction.hpp"

#include "tests/agents/methods/topometric/sim_drive.hpp"

namespace weft::agents {
namespace {

constexpr double kAislesApartM = 8.2;

/// Holds what a place farther on shows, and where that truly is.
struct Shown {
  TopometricContent content;
  Pose2 site_from_place;
};

Shown shown_from(const sim::Site& site, const Pose2& site_from_robot, std::uint64_t seed = 1001,
                 double then_turns_rad = 0.0) {
  test::SimDrive drive(site, site_from_robot, seed);
  drive.drive(0.9);
  drive.turn(then_turns_rad);
  return {drive.place(), drive.truth()};
}

/// Returns what speaks against two places lying so far apart that they look alike.
double contradiction(const Shown& a, const Shown& b, double apart_m) {
  const Pose2 alike{b.site_from_place.x, b.site_from_place.y - apart_m, b.site_from_place.heading};
  test::SimDrive any(test::topometric_site("aisles"), {3.5, 2.05, 0.0});
  return any.method().contradiction(a.content, b.content, Metric2{a.site_from_place.inverse() * alike});
}

TEST(TopometricContradiction, InsideAislesThatHoldTheSameThereIsNone) {
  const sim::Site site = test::topometric_site("aisles");
  const Shown first = shown_from(site, {6.0, 2.05, 0.0});
  const Shown third = shown_from(site, {6.0, 2.05 + kAislesApartM, 0.0}, 1002);
  EXPECT_EQ(contradiction(first, third, kAislesApartM), 0.0);
}

TEST(TopometricContradiction, WhereOneIsAtAWallAndTheOtherLooksOnThereIs) {
  const sim::Site site = test::topometric_site("aisles");
  const Pose2 north{15.3, 4.9, 1.57};
  constexpr double into_aisle_rad = 0.5;
  const Shown first = shown_from(site, north, 1001, into_aisle_rad);
  const Shown third = shown_from(site, {north.x, north.y + kAislesApartM, north.heading}, 1002, into_aisle_rad);
  EXPECT_GT(contradiction(first, third, kAislesApartM), 4.0);
  const Shown again = shown_from(site, north, 1003, into_aisle_rad);
  EXPECT_EQ(contradiction(first, again, 0.0), 0.0);
}

TEST(TopometricContradiction, ACrateThatHasComeIsSeenThrough) {
  sim::Site site = test::topometric_site("hall");
  const Pose2 start{2.0, 1.8, 0.0};
  const Shown before = shown_from(site, start);
  sim::Obstacle crate;
  crate.name = "crate";
  crate.site_from_obstacle = {5.0, 1.6, 0.0};
  crate.length_m = 0.6;
  crate.width_m = 0.5;
  crate.height_m = 0.6;
  site.obstacles.push_back(crate);
  const Shown now = shown_from(site, start);
  const Pose3 before_from_now = lift(before.site_from_place.inverse() * now.site_from_place);
  const ExpectedInView expected = expected_in_view(before.content, now.content.cloud, before_from_now, 3.9);
  EXPECT_GT(expected.seen, 10U);
  EXPECT_GT(expected.through, 3U);
  EXPECT_EQ(contradiction(before, now, 0.0), 0.0);
}

TEST(TopometricContradiction, OfAPlaceWithoutFramesNothingIsExpected) {
  const ExpectedInView expected = expected_in_view({}, {}, {}, 3.9);
  EXPECT_EQ(expected.seen + expected.through + expected.blank, 0U);
}

TEST(TopometricContradiction, AContentThatStatesAnImpossibleViewCostsNothing) {
  Shown shown = shown_from(test::topometric_site("hall"), {2.0, 1.8, 0.0});
  const PlaceCloud cloud = shown.content.cloud;
  shown.content.rig.width = shown.content.rig.height = 16384;
  shown.content.rig.focal_px = 1.0;
  const ExpectedInView expected = expected_in_view(shown.content, cloud, {}, 3.9);
  EXPECT_EQ(expected.seen + expected.through + expected.blank, 0U);
}

}  // namespace
}  // namespace weft::agents
