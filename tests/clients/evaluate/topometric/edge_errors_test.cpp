#include "clients/evaluate/topometric/edge_errors.hpp"

#include <gtest/gtest.h>

#include "clients/evaluate/topometric/delivery.hpp"
#include "core/network/codec.hpp"

namespace weft::evaluate::topometric {
namespace {

using agents::Kept;

Relation ahead(double metres, double left_m = 0.0, double heading = 0.0) {
  return Metric2{{metres, left_m, heading}, 1e-4 * Eigen::Matrix3d::Identity()};
}

/// Is taught places half a metre apart along x, in runs one after the other.
class TaughtRuns : public testing::Test {
 protected:
  PlaceId place(std::uint64_t run, std::uint32_t index) const { return {ExperienceId{run}, index}; }

  /// Keeps a place, joined to the one before it by what was guessed and by what came out.
  void keep(std::uint64_t run, std::uint32_t index, const Relation& guess, const Relation& registered,
            Origin origin = Origin::odometry) {
    Kept kept;
    kept.place.id = place(run, index);
    kept.place.method = "topometric";
    kept.content = {static_cast<std::uint8_t>(run), static_cast<std::uint8_t>(index)};
    kept.place.content = {hash_bytes(kept.content), kept.content.size()};
    if (index > 0) kept.edges.push_back(edge(place(run, index - 1), kept.place.id, registered, origin));
    add(kept, guess);
  }
  void stitch(const PlaceId& a, const PlaceId& b, const Relation& a_from_b, std::uint32_t inliers) {
    Edge stitch = edge(a, b, a_from_b, Origin::stitch);
    stitch.inliers = inliers;
    stitches_.push_back(stitch);
  }
  Edge edge(const PlaceId& a, const PlaceId& b, const Relation& a_from_b, Origin origin) const {
    Edge edge;
    edge.id = {a, b};
    edge.a_from_b = a_from_b;
    edge.origin = origin;
    edge.method = "topometric";
    edge.drivable = Drivable::both;
    return edge;
  }
  void add(Kept kept, const Relation& guess) {
    for (const Edge& stitch : stitches_)
      if (stitch.id.b == kept.place.id) kept.edges.push_back(stitch);
    const ExperienceId run = kept.place.id.experience;
    const RobotId robot{{static_cast<std::uint8_t>(run.value)}};
    kept.place.robot = robot;
    ASSERT_TRUE(taught_.map.take(run, robot, "topometric", {kept}));
    Kept unregistered = kept;
    if (kept.place.id.index > 0) unregistered.edges.front().a_from_b = guess;
    ASSERT_TRUE(taught_.unregistered.take(run, robot, "topometric", {unregistered}));
    taught_.site_from_place[kept.place.id] = {0.5 * kept.place.id.index, 0.0, 0.0};
  }

  Taught taught_;
  std::vector<Edge> stitches_;
};

TEST_F(TaughtRuns, ErrorsAreAlongAndAcrossBeforeAndAfter) {
  keep(1, 0, {}, {});
  keep(1, 1, ahead(0.52, 0.03), ahead(0.52, 0.01));
  keep(1, 2, ahead(0.50, 0.0), ahead(0.48, 0.0));
  keep(1, 3, ahead(0.51, 0.0), ahead(0.51, 0.0));  // contents have said nothing
  const EdgeErrors errors = chain_errors(taught_);
  EXPECT_EQ(errors.edges, 2.0);
  ASSERT_EQ(errors.across_m.size(), 2U);
  EXPECT_NEAR(errors.across_m[0], 0.01, 1e-12);
  EXPECT_NEAR(errors.across_before_m[0], 0.03, 1e-12);
  EXPECT_NEAR(errors.along_m[0], 0.02, 1e-12);
  EXPECT_EQ(errors.grew, 1.0) << "the second grew from 0 to 2 cm";
}

TEST_F(TaughtRuns, AWrongStitchIsCountedAndAFreeWayIsNone) {
  keep(1, 0, {}, {});
  keep(1, 1, ahead(0.5), ahead(0.5));
  keep(1, 2, ahead(0.5), ahead(0.5));
  stitch(place(1, 1), place(2, 0), ahead(-0.46), 40);
  stitch(place(1, 2), place(2, 1), ahead(-0.3), 40);
  keep(2, 0, {}, {});
  keep(2, 1, ahead(0.5), ahead(0.5));
  const StitchErrors errors = stitch_errors(taught_);
  ASSERT_EQ(errors.metres.size(), 2U);
  EXPECT_NEAR(errors.metres[0], 0.04, 1e-12);
  EXPECT_NEAR(errors.metres[1], 0.20, 1e-12);
  EXPECT_EQ(errors.wrong, 1.0);
}

TEST_F(TaughtRuns, ABlindWayHasToSaySo) {
  keep(1, 0, {}, {});
  keep(1, 1, ahead(0.5), ahead(0.5));
  keep(1, 2, ahead(0.5), ahead(0.5), Origin::blind);
  topometric::Run run{ExperienceId{1}, Moments(5), {place(1, 0), place(1, 1), place(1, 2)}};
  for (std::size_t i = 0; i < run.moments.size(); ++i)
    run.moments[i].site_from_robot = {0.25 * static_cast<double>(i), 0.0, 0.0};
  run.moments[0].kept = place(1, 0);
  run.moments[2].kept = place(1, 1);
  run.moments[4].kept = place(1, 2);
  run.moments[0].seen = run.moments[2].seen = true;  // half of each way was not seen
  taught_.runs.push_back(run);
  EXPECT_EQ(unmarked_blind_edges(taught_), 1.0);
}

TEST_F(TaughtRuns, ARouteGoesRoundWhatIsClosed) {
  for (std::uint32_t i = 0; i < 4; ++i) keep(1, i, ahead(0.5), ahead(0.5));
  const Result<Route> open = route_without(taught_, place(1, 0), place(1, 3), {});
  ASSERT_TRUE(open) << open.error().message;
  EXPECT_EQ(open->places.size(), 4U);
  EXPECT_NEAR(metres_of(*open), 1.5, 1e-12);
  EXPECT_FALSE(route_without(taught_, place(1, 0), place(1, 3), {{place(1, 1), place(1, 2)}}));
}

}  // namespace
}  // namespace weft::evaluate::topometric
