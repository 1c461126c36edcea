#include "agents/adjustment/mosaic_adjustment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/seen_ceiling.hpp"

namespace weft::agents {
namespace {

/// Returns the root mean square of how far places lie from where they are, the first one aside.
double off_m(const Mosaic& mosaic, const std::vector<Pose2>& truth) {
  double sum = 0.0;
  for (std::size_t i = 1; i < truth.size(); ++i)
    sum += (mosaic.places[i].map_from_place.translation() - truth[i].translation()).squaredNorm();
  return std::sqrt(sum / static_cast<double>(truth.size() - 1));
}

Mosaic adjusted(const Mosaic& mosaic) {
  Result<MosaicAdjustment> adjustment = MosaicAdjustment::make(mosaic);
  EXPECT_TRUE(adjustment) << adjustment.error().message;
  while (adjustment->step()) {
  }
  EXPECT_LE(adjustment->done(), adjustment->pieces());
  return adjustment->mosaic();
}

TEST(MosaicAdjustment, ALineThatOdometryBentIsStraightenedByWhatHangsBelowTheCeiling) {
  SeenCeiling seen({.way = line_way(40, 0.4), .seed = 1});
  const double before = off_m(seen.mosaic, seen.truth);
  const double after = off_m(adjusted(seen.mosaic), seen.truth);
  EXPECT_GT(before, 0.08);
  EXPECT_LT(after, 0.25 * before);
}

TEST(MosaicAdjustment, ALoopIsClosedByItsStitches) {
  SeenCeiling seen({.way = loop_way(120, 0.4), .stitches = 6, .seed = 2});
  const double after = off_m(adjusted(seen.mosaic), seen.truth);
  EXPECT_LT(after, 0.5 * off_m(seen.mosaic, seen.truth));
  EXPECT_LT(after, 0.06);
}

TEST(MosaicAdjustment, AWrongStitchAmongRightOnesMovesNothing) {
  SeenCeiling seen({.way = loop_way(120, 0.4), .stitches = 6, .seed = 2});
  const double without = off_m(adjusted(seen.mosaic), seen.truth);
  MosaicLink wrong = seen.mosaic.links.back();
  ASSERT_TRUE(wrong.is_stitch);
  wrong.from_from_to = wrong.from_from_to * Pose2{1.0, 0.5, 0.1};
  seen.mosaic.links.push_back(wrong);
  EXPECT_LT(off_m(adjusted(seen.mosaic), seen.truth), without + 0.01);
}

TEST(MosaicAdjustment, NoiseOfSightingsDoesNotShortenTheWay) {
  const SeenCeiling seen({.way = line_way(60, 0.4), .seed = 7, .longer = 0.0, .sigma_rad = 0.004});
  const double adjusted_m = adjusted(seen.mosaic).places.back().map_from_place.translation().norm();
  EXPECT_NEAR(adjusted_m / seen.truth.back().translation().norm(), 1.0, 0.0015);
}

TEST(MosaicAdjustment, HeightsAreFoundWithinWhatTheirSigmasSay) {
  SeenCeiling seen({.way = line_way(24, 0.4), .seed = 3});
  const Mosaic after = adjusted(seen.mosaic);
  std::size_t known = 0;
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < after.points.size(); ++i) {
    const MosaicPoint& point = after.points[i];
    if (point.height_sigma_m == 0.0 || point.height_sigma_m > 0.1) continue;
    ++known;
    if (std::abs(point.in_map.z() - seen.points[i].z()) > 4.0 * point.height_sigma_m) ++beyond;
  }
  EXPECT_GT(known, after.points.size() / 3);
  EXPECT_LT(beyond, known / 20);
}

TEST(MosaicAdjustment, TheResultIsTheSameToTheLastBit) {
  const SeenCeiling seen({.way = line_way(20, 0.4), .seed = 4});
  const Mosaic one = adjusted(seen.mosaic);
  const Mosaic other = adjusted(seen.mosaic);
  for (std::size_t i = 0; i < one.places.size(); ++i)
    EXPECT_EQ(one.places[i].map_from_place, other.places[i].map_from_place) << i;
}

TEST(MosaicAdjustment, APlaceThatSeesNothingIsHeldByItsLinks) {
  SeenCeiling seen({.way = line_way(20, 0.4), .seed = 5});
  std::erase_if(seen.mosaic.sightings, [](const MosaicSighting& sighting) { return sighting.place == 10; });
  const Mosaic after = adjusted(seen.mosaic);
  EXPECT_LT((after.places[10].map_from_place.translation() - seen.truth[10].translation()).norm(), 0.1);
}

TEST(MosaicAdjustment, WhatIsWrongIsNamed) {
  const SeenCeiling seen({.way = line_way(6, 0.4), .seed = 6});
  const auto refusal = [](const Mosaic& mosaic, const MosaicAdjustmentConfig& config = {}) {
    const Result<MosaicAdjustment> made = MosaicAdjustment::make(mosaic, config);
    return made ? std::string() : made.error().message;
  };
  EXPECT_EQ(refusal(seen.mosaic), "");
  Mosaic mosaic = seen.mosaic;
  mosaic.sightings[3].place = 6;
  EXPECT_EQ(refusal(mosaic), "mosaic: sighting 3: place 6 is not one of 6");
  mosaic = seen.mosaic;
  mosaic.links.erase(mosaic.links.begin() + 2);
  EXPECT_EQ(refusal(mosaic), "mosaic: no link joins place 2 to the next one");
  mosaic = seen.mosaic;
  mosaic.places[1].attitude_sigma.z() = 0.0;
  EXPECT_EQ(refusal(mosaic), "mosaic: place 1: a sigma of its attitude is not above 0");
  EXPECT_EQ(refusal(seen.mosaic, {.window_places = 5}),
            "mosaic: windows of 5 places; at least 4, and an even number");
}

}  // namespace
}  // namespace weft::agents
