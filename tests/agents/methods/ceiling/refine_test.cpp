#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "agents/methods/ceiling/ceiling.hpp"
#include "tests/agents/methods/ceiling/corner_ceiling.hpp"

namespace weft::agents {
namespace {

using test::CornerCeiling;
using test::TaughtUnder;

std::vector<Pose2> straight_on(std::size_t places) {
  std::vector<Pose2> way;
  for (std::size_t i = 0; i < places; ++i) way.push_back({0.4 * static_cast<double>(i), 0.0, 0.0});
  return way;
}

std::vector<Pose2> once_round(std::size_t places) {
  const double turn = 2.0 * std::numbers::pi / static_cast<double>(places);
  std::vector<Pose2> way{{}};
  while (way.size() < places) way.push_back(way.back() * se2_exp({0.4, 0.0, turn}));
  return way;
}

Ceiling refining() {
  CeilingConfig config;
  config.height_m = CornerCeiling::ceiling_m;
  return *Ceiling::make(config, test::up_camera(0.03, -0.02));
}

Amendments<CeilingContent> amendments(const Ceiling& method, const CeilingRun& run) {
  Ceiling::Refinement refinement = method.begin_refine(run);
  const std::size_t most = method.pieces(refinement);
  std::size_t done = 1;
  for (; method.refine(refinement); ++done) EXPECT_LE(method.pieces(refinement), most);
  EXPECT_LE(done, method.pieces(refinement));
  return method.refined(std::move(refinement));
}

/// Returns the run with its amendments in it.
CeilingRun amended(CeilingRun run, const Amendments<CeilingContent>& changes) {
  std::map<EdgeId, Relation> relations;
  for (const AmendedEdge& change : changes.edges) relations[change.edge] = change.a_from_b;
  for (auto& place : run)
    for (Edge& edge : place.edges)
      if (relations.contains(edge.id)) edge.a_from_b = relations.at(edge.id);
  for (const auto& change : changes.places)
    run[change.place.index].content = std::make_shared<const CeilingContent>(change.content);
  return run;
}

/// Returns where places lie by the odometry between them.
std::vector<Pose2> laid_out(const CeilingRun& run) {
  std::vector<Pose2> poses{{}};
  for (std::size_t i = 1; i < run.size(); ++i) poses.push_back(poses.back() * taught_step(run, i).a_from_b);
  return poses;
}

double off_m(const CeilingRun& run, const std::vector<Pose2>& truth) {
  const std::vector<Pose2> poses = laid_out(run);
  double sum = 0.0;
  for (std::size_t i = 0; i < poses.size(); ++i)
    sum += (poses[i].translation() - truth[i].translation()).squaredNorm();
  return std::sqrt(sum / static_cast<double>(poses.size()));
}

TEST(CeilingRefine, ALineThatOdometryBentIsStraightened) {
  const std::vector<Pose2> way = straight_on(40);
  const CornerCeiling ceiling(test::seen_about(way), 1);
  const TaughtUnder taught(ceiling, way, 2);
  const double before = off_m(taught.run, taught.truth);
  ASSERT_GT(before, 0.08);
  EXPECT_LT(off_m(amended(taught.run, amendments(refining(), taught.run)), taught.truth), 0.4 * before);
}

TEST(CeilingRefine, ALoopIsClosedAndEachStitchSaysWhatTheWayRoundSays) {
  const std::vector<Pose2> way = once_round(80);
  const CornerCeiling ceiling(test::seen_about(way), 3);
  TaughtUnder taught(ceiling, way, 4);
  for (std::uint32_t i = 0; i < 5; ++i) taught.stitch(i, 79 - i);
  taught.stitch(6, 70);
  Edge& wrong = taught.run[70].edges.back();
  wrong.a_from_b = Metric2{planar(wrong.a_from_b) * Pose2{1.0, 0.5, 0.1}, planar_covariance(wrong.a_from_b)};
  const double before = off_m(taught.run, taught.truth);
  const CeilingRun after = amended(taught.run, amendments(refining(), taught.run));
  EXPECT_LT(off_m(after, taught.truth), 0.5 * before);
  EXPECT_LT(off_m(after, taught.truth), 0.08);
  const std::vector<Pose2> poses = laid_out(after);
  std::size_t stitches = 0;
  for (const auto& place : after) {
    for (const Edge& edge : place.edges) {
      if (edge.origin != Origin::stitch) continue;
      ++stitches;
      const Pose2 way_round = poses[edge.id.a.index].inverse() * poses[edge.id.b.index];
      EXPECT_LT(se2_log(way_round.inverse() * planar(edge.a_from_b)).norm(), 1e-6) << edge.id.b.index;
    }
  }
  EXPECT_EQ(stitches, 6U);
}

TEST(CeilingRefine, HeightsOfWhatHangsAreBetterKnownAndKeepTheirRays) {
  const std::vector<Pose2> way = straight_on(24);
  const CornerCeiling ceiling(test::seen_about(way), 5);
  const TaughtUnder taught(ceiling, way, 6);
  const CeilingRun after = amended(taught.run, amendments(refining(), taught.run));
  double before_m = 0.0, after_m = 0.0;
  std::size_t changed = 0, beyond = 0;
  for (std::size_t i = 0; i < way.size(); ++i) {
    for (std::size_t k = 0; k < taught.corners[i].size(); ++k) {
      const PlaneFeature& was = taught.run[i].content->features[k];
      const PlaneFeature& is = after[i].content->features[k];
      if (is.above_floor_m == was.above_floor_m) continue;
      const double true_m = ceiling.at[taught.corners[i][k]].z();
      ++changed;
      before_m += std::abs(was.above_floor_m - true_m);
      after_m += std::abs(is.above_floor_m - true_m);
      if (std::abs(is.above_floor_m - true_m) > 4.0 * is.above_floor_sigma_m) ++beyond;
      EXPECT_LT(is.above_floor_sigma_m, was.above_floor_sigma_m);
      EXPECT_LE(is.above_floor_m, CornerCeiling::ceiling_m);
      const Eigen::Vector3d& eye = ceiling.camera.robot_from_camera.translation;
      const auto slope = [&](const PlaneFeature& feature) {
        return Eigen::Vector2d((feature.on_plane - eye.head<2>()) / (feature.above_floor_m - eye.z()));
      };
      EXPECT_LT((slope(is) - slope(was)).norm(), 1e-9);
    }
  }
  EXPECT_GT(changed, 300U);
  EXPECT_LT(after_m, 0.5 * before_m);
  EXPECT_LT(beyond, changed / 20);
}

TEST(CeilingRefine, CovariancesStayAsTaught) {
  const std::vector<Pose2> way = straight_on(10);
  const TaughtUnder taught(CornerCeiling(test::seen_about(way), 7), way, 8);
  const CeilingRun after = amended(taught.run, amendments(refining(), taught.run));
  for (std::size_t i = 1; i < way.size(); ++i)
    EXPECT_EQ(taught_step(after, i).covariance, taught_step(taught.run, i).covariance);
}

TEST(CeilingRefine, TheSameRunGivesTheSameBits) {
  const std::vector<Pose2> way = straight_on(20);
  const TaughtUnder taught(CornerCeiling(test::seen_about(way), 9), way, 10);
  const Ceiling method = refining();
  const Amendments<CeilingContent> one = amendments(method, taught.run);
  const Amendments<CeilingContent> other = amendments(method, taught.run);
  ASSERT_EQ(one.edges.size(), way.size() - 1);
  ASSERT_EQ(one.places.size(), way.size());
  for (std::size_t i = 0; i < one.edges.size(); ++i)
    EXPECT_TRUE(identical(one.edges[i].a_from_b, other.edges[i].a_from_b)) << i;
  for (std::size_t i = 0; i < one.places.size(); ++i) {
    const Bytes bytes = method.encode(one.places[i].content);
    EXPECT_EQ(bytes, method.encode(other.places[i].content)) << i;
    const Result<CeilingContent> decoded = method.decode(bytes);
    EXPECT_TRUE(decoded) << i << ": " << decoded.error().message;
  }
}

TEST(CeilingRefine, ARunThatCannotBeAdjustedStaysAsItWasTaught) {
  const std::vector<Pose2> way = straight_on(4);
  const TaughtUnder taught(CornerCeiling(test::seen_about(way), 11), way, 12);
  const Ceiling method = refining();
  const auto stays = [&](const CeilingRun& run) {
    Ceiling::Refinement refinement = method.begin_refine(run);
    const bool has_none = method.pieces(refinement) == 0 && !method.refine(refinement);
    const Amendments<CeilingContent> changes = method.refined(std::move(refinement));
    return has_none && changes.edges.empty() && changes.places.empty();
  };
  EXPECT_FALSE(stays(taught.run));
  EXPECT_TRUE(stays({}));
  EXPECT_TRUE(stays({taught.run.front()}));
  CeilingRun other_scale = taught.run;
  auto higher = std::make_shared<CeilingContent>(*other_scale[2].content);
  higher->ceiling_m = 6.5;
  other_scale[2].content = higher;
  EXPECT_TRUE(stays(other_scale));
  CeilingRun not_joined = taught.run;
  not_joined[2].edges.clear();
  EXPECT_TRUE(stays(not_joined));
}

TEST(RunCorners, ACornerHasOneFeatureOfAPlaceAndTheFirstMatchCounts) {
  RunCorners corners;
  corners.add(2, {});
  corners.add(2, std::vector<MatchedPlace>{{0, {{0, 1, 5}}}});
  // Both features of the third place are taken for the first corner; the nearer place's match counts.
  corners.add(2, std::vector<MatchedPlace>{{1, {{1, 0, 5}}}, {0, {{0, 1, 3}, {1, 1, 9}}}});
  const std::vector<std::vector<RunFeature>> expected = {{{0, 0}, {1, 1}, {2, 0}}, {{0, 1}, {2, 1}}, {{1, 0}}};
  EXPECT_EQ(corners.corners(), expected);
}

}  // namespace
}  // namespace weft::agents
