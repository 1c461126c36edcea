#include "agents/perception/pseudo_scan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/random.hpp"

namespace weft::agents {
namespace {

using Points = std::vector<Eigen::Vector3f>;

/// Adds a column of points at a bearing and a range, from low to high.
void stand(Points& points, double bearing_rad, double range_m, double low_m, double high_m, int count = 6) {
  for (int i = 0; i < count; ++i) {
    const double z = low_m + (high_m - low_m) * i / std::max(1, count - 1);
    points.emplace_back(static_cast<float>(range_m * std::cos(bearing_rad)),
                        static_cast<float>(range_m * std::sin(bearing_rad)), static_cast<float>(z));
  }
}

void lay_floor(Points& points, double bearing_rad, double from_m, double to_m) {
  for (double range = from_m; range <= to_m; range += 0.05) stand(points, bearing_rad, range, 0.0, 0.0, 2);
}

Beam beam_at(const Scan& scan, double bearing_rad) {
  const Beam* nearest = &scan.beams.front();
  for (const Beam& beam : scan.beams)
    if (std::abs(beam.bearing_rad - bearing_rad) < std::abs(nearest->bearing_rad - bearing_rad)) nearest = &beam;
  return *nearest;
}

constexpr double kLeft = 0.2007;

TEST(PseudoScan, HasABeamEachHalfDegreeOfTheView) {
  const Scan scan = pseudo_scan({}, {}, {0.1, 0.0, 0.0});
  EXPECT_EQ(scan.beams.size(), 161U);
  EXPECT_NEAR(scan.beams[1].bearing_rad - scan.beams[0].bearing_rad, 0.0087266, 1e-9);
  EXPECT_NEAR(scan.beams.front().bearing_rad, -scan.beams.back().bearing_rad, 1e-9);
  EXPECT_EQ(scan.robot_from_scan, (Pose2{0.1, 0.0, 0.0}));
}

TEST(PseudoScan, TakesTheThirdClosestPointOfABin) {
  Points points;
  stand(points, kLeft, 1.0, 0.5, 0.6, 2);  // two that fly
  stand(points, kLeft, 2.0, 0.5, 0.6, 2);
  stand(points, kLeft, 2.5, 0.5, 1.4, 5);
  const Beam beam = beam_at(pseudo_scan({}, points, {}), kLeft);
  EXPECT_EQ(beam.kind, Beam::Return::obstacle);
  EXPECT_NEAR(beam.range_m, 2.0, 1e-3);
  EXPECT_NEAR(beam.clear_m, 2.0, 1e-3);
  EXPECT_NEAR(beam.sigma_m, 0.01 * 4.0, 1e-3);
}

TEST(PseudoScan, ANoisyWallReturnsWhereItStandsAndNotItsFront) {
  Points points;
  Random random(1);
  for (int i = 0; i < 100; ++i) stand(points, kLeft, random.normal(4.0, 0.16), 0.5, 0.6, 1);
  const Beam beam = beam_at(pseudo_scan({}, points, {}), kLeft);
  EXPECT_NEAR(beam.range_m, 4.0, 0.08);
  EXPECT_LT(beam.clear_m, 3.8);
}

TEST(PseudoScan, WhatStandsBeyondTheRangeShowsThatNothingStandsBefore) {
  const auto seen = [](const Points& points) { return beam_at(pseudo_scan({}, points, {}), kLeft); };
  Points far;
  stand(far, kLeft, 8.0, 0.3, 1.4);
  EXPECT_EQ(seen(far).kind, Beam::Return::none);
  EXPECT_EQ(seen(far).clear_m, 5.0);

  Points faded = far;  // a floor whose texture fades ends no way that is seen to go on
  for (double bearing = 0.1; bearing < 0.3; bearing += 0.004) lay_floor(faded, bearing, 0.8, 2.6);
  EXPECT_EQ(seen(faded).clear_m, 5.0);
  Points crate = far;
  stand(crate, kLeft, 2.0, 0.2, 0.6);
  EXPECT_EQ(seen(crate).kind, Beam::Return::obstacle);
  EXPECT_NEAR(seen(crate).clear_m, 2.0, 1e-3);
  Points drop = far;
  lay_floor(drop, kLeft, 0.8, 1.5);
  stand(drop, kLeft, 1.8, -0.4, -0.2);
  EXPECT_LT(seen(drop).clear_m, 1.6);

  Points unsure;  // as far beyond the range as depth is off there
  stand(unsure, kLeft, 5.4, 0.3, 1.4);
  Points lamps;
  stand(lamps, kLeft, 8.0, 1.7, 2.2);
  Points few;
  stand(few, kLeft, 8.0, 0.3, 1.4, 2);
  for (const Points& points : {unsure, lamps, few}) EXPECT_EQ(seen(points).clear_m, 0.0);
}

TEST(PseudoScan, OnlyTheSliceReturns) {
  Points points;
  stand(points, kLeft, 1.0, 0.07, 0.11);  // a sill
  stand(points, kLeft, 1.5, 1.6, 2.2);    // a lintel
  EXPECT_EQ(beam_at(pseudo_scan({}, points, {}), kLeft).kind, Beam::Return::none);
}

TEST(PseudoScan, ARayWithoutAReturnIsNotFree) {
  const Beam beam = beam_at(pseudo_scan({}, {}, {}), kLeft);
  EXPECT_EQ(beam.kind, Beam::Return::none);
  EXPECT_EQ(beam.clear_m, 0.0);
}

TEST(PseudoScan, ARayWithoutAReturnIsFreeAsFarAsFloorWasSeenWithoutAGap) {
  Points points;
  lay_floor(points, kLeft, 0.8, 2.0);
  lay_floor(points, kLeft, 2.6, 4.0);
  const Beam beam = beam_at(pseudo_scan({}, points, {}), kLeft);
  EXPECT_NEAR(beam.clear_m, 2.0, 0.051);
  Points far;
  lay_floor(far, kLeft, 2.6, 4.0);
  EXPECT_EQ(beam_at(pseudo_scan({}, far, {}), kLeft).clear_m, 0.0) << "what is nearer was not seen";
}

TEST(PseudoScan, TheFarEdgeOfSeenFloorIsAWeakReturn) {
  Points points;
  for (int i = -5; i <= 5; ++i) lay_floor(points, kLeft + 0.0087266 * i, 0.8, 2.5);
  const Beam beam = beam_at(pseudo_scan({}, points, {}), kLeft);
  EXPECT_EQ(beam.kind, Beam::Return::floor_edge);
  EXPECT_NEAR(beam.range_m, 2.5, 0.051);
  EXPECT_GT(beam.sigma_m, 0.25);
  Points to_the_end;
  for (int i = -5; i <= 5; ++i) lay_floor(to_the_end, kLeft + 0.0087266 * i, 0.8, 4.95);
  EXPECT_EQ(beam_at(pseudo_scan({}, to_the_end, {}), kLeft).kind, Beam::Return::none)
      << "it ends because the range does";
}

TEST(PseudoScan, AFloorThatEndsRaggedlyTellsOfNoWall) {
  Points points;
  for (int i = -9; i <= 9; ++i) lay_floor(points, kLeft + 0.0087266 * i, 0.8, 2.0 + 0.3 * ((i + 9) % 4));
  for (const Beam& beam : pseudo_scan({}, points, {}).beams) EXPECT_EQ(beam.kind, Beam::Return::none);
  EXPECT_GE(beam_at(pseudo_scan({}, points, {}), kLeft).clear_m, 1.9) << "free it is, all the same";
}

TEST(PseudoScan, ADropEndsWhatIsFreeThoughAWallReturnsBehindIt) {
  Points points;
  lay_floor(points, kLeft, 0.8, 1.5);
  stand(points, kLeft, 2.2, -0.5, -0.3);
  stand(points, kLeft, 3.5, 0.2, 1.4);
  const Beam beam = beam_at(pseudo_scan({}, points, {}), kLeft);
  EXPECT_NEAR(beam.range_m, 3.5, 1e-3);
  EXPECT_NEAR(beam.clear_m, 1.5, 0.051);
}

TEST(PseudoScan, PointsBehindBeyondOrNotFiniteAreLeftOut) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Points points(5, {nan, 0.0F, 0.5F});
  points.insert(points.end(), 5, {1.0F, 0.0F, nan});
  stand(points, 0.0, 7.0, 0.2, 1.4);
  stand(points, 3.0, 1.0, 0.2, 1.4);
  for (const Beam& beam : pseudo_scan({}, points, {}).beams) EXPECT_EQ(beam.kind, Beam::Return::none);
}

TEST(PseudoScan, SettingsOutOfBoundsAreNamed) {
  PseudoScanConfig config;
  EXPECT_TRUE(check(config).empty());
  config.rank = 0;
  config.body_height_m = 0.1;
  EXPECT_EQ(check(config).size(), 2U);
}

}  // namespace
}  // namespace weft::agents
