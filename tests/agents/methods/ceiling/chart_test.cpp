#include "agents/methods/ceiling/chart.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "agents/methods/ceiling/ceiling.hpp"
#include "agents/methods/ceiling/corner_grid.hpp"
#include "tests/agents/methods/ceiling/corner_ceiling.hpp"

namespace weft::agents {
namespace {

using test::CornerCeiling;

const ExperienceId kCharted{3};
const Step kStanding{Metric2{}, true, {}};

/// Holds places of a line, 0.4 m apart, whose relations are known well, and what each stored.
struct ChartedLine {
  explicit ChartedLine(std::size_t places, std::size_t most_features = most_ceiling_features)
      : ceiling(test::box(-10.0, -10.0, 24.0, 20.0), 21), random(22) {
    for (std::uint32_t i = 0; i < places; ++i) {
      poses.push_back({0.4 * i, 0.0, 0.2 * i});
      test::StoredCorners stored = ceiling.stored_from(poses.back(), random);
      keep_some(stored, i, most_features);
      corners.push_back(stored.corners);
      const Eigen::Matrix3d covariance = Eigen::Vector3d(1e-5 * i, 1e-5 * i, 1e-6 * i).asDiagonal();
      around.push_back({{kCharted, i},
                        i,
                        Metric2{poses.front().inverse() * poses.back(), covariance},
                        std::make_shared<const CeilingContent>(stored.content)});
    }
  }

  /// Leaves a place so many features, other ones than its neighbours have.
  static void keep_some(test::StoredCorners& stored, std::size_t place, std::size_t most) {
    if (stored.corners.size() <= most) return;
    test::StoredCorners some;
    some.content = stored.content;
    some.content.features.clear();
    for (std::size_t k = 0; k < most; ++k) {
      const std::size_t i = (7 * k + 5 * place) % stored.corners.size();
      some.content.features.push_back(stored.content.features[i]);
      some.corners.push_back(stored.corners[i]);
    }
    stored = some;
  }

  CornerCeiling ceiling;
  Random random;
  std::vector<Pose2> poses;
  std::vector<std::vector<std::size_t>> corners;
  std::vector<ChartPlace<CeilingContent>> around;
};

Ceiling charting() {
  CeilingConfig config;
  config.height_m = CornerCeiling::ceiling_m;
  return *Ceiling::make(config, test::up_camera(0.03, -0.02));
}

Metric2 known_to(const Pose2& pose, double sigma_m, double sigma_rad) {
  return {pose, Eigen::Vector3d(sigma_m, sigma_m, sigma_rad).cwiseAbs2().asDiagonal()};
}

TEST(CeilingChart, WhatSeveralPlacesShowIsOneCorner) {
  const ChartedLine line(8);
  const CeilingChart chart = charting().chart(line.around);
  std::map<std::size_t, std::uint32_t> shown;
  std::size_t features = 0;
  for (const std::vector<std::size_t>& corners : line.corners) {
    features += corners.size();
    for (const std::size_t corner : corners) ++shown[corner];
  }
  ASSERT_GT(features, 4 * shown.size()) << "most corners are shown several times";
  EXPECT_GE(chart.corners.size(), shown.size());
  EXPECT_LE(chart.corners.size(), shown.size() + shown.size() / 20);
  std::size_t places = 0;
  for (const ChartCorner& corner : chart.corners) places += corner.places;
  EXPECT_EQ(places, features);
}

TEST(CeilingChart, CornersLieWhereTheyAre) {
  const ChartedLine line(8);
  const CeilingChart chart = charting().chart(line.around);
  std::size_t compared = 0, right = 0;
  for (const ChartCorner& corner : chart.corners) {
    if (corner.places < 4 || corner.feature.above_floor_m < CornerCeiling::ceiling_m) continue;
    ++compared;
    for (const Eigen::Vector3d& there : line.ceiling.at)
      if ((corner.feature.on_plane - there.head<2>()).norm() < 0.02) {
        ++right;
        break;
      }
  }
  EXPECT_GT(compared, 50U);
  EXPECT_GE(right, compared - compared / 20);
}

TEST(CeilingChart, APlaceBelowAnotherCeilingLendsNoCorner) {
  ChartedLine line(2);
  auto higher = std::make_shared<CeilingContent>(*line.around[1].content);
  higher->ceiling_m = 9.0;
  line.around[1].content = higher;
  const CeilingChart chart = charting().chart(line.around);
  EXPECT_EQ(chart.places.size(), 2U);
  EXPECT_EQ(chart.corners.size(), line.corners[0].size());
}

TEST(CeilingChart, CornersAreGivenAboutAPointInTheFrameOfAPlace) {
  const ChartedLine line(8);
  const CeilingChart chart = charting().chart(line.around);
  const Eigen::Vector2d here(1.0, 0.5);
  const Pose2 centre_from_place{1.2, 0.1, 0.6};
  constexpr double reach_m = 2.0;
  std::size_t near = 0;
  std::uint32_t most_places = 0;
  for (const ChartCorner& corner : chart.corners) {
    if ((corner.feature.on_plane - here).norm() >= reach_m) continue;
    ++near;
    most_places = std::max(most_places, corner.places);
  }
  const std::vector<PlaneFeature> all = chart.around(here, reach_m, 1000, centre_from_place);
  EXPECT_EQ(all.size(), near);
  for (const PlaneFeature& feature : all)
    EXPECT_LT((centre_from_place * feature.on_plane - here).norm(), reach_m + 1e-9);
  ASSERT_GT(near, 3U);
  const std::vector<PlaneFeature> some = chart.around(here, reach_m, 3, centre_from_place);
  ASSERT_EQ(some.size(), 3U);
  const auto first = std::find_if(chart.corners.begin(), chart.corners.end(), [&](const ChartCorner& corner) {
    return corner.feature.descriptor == some.front().descriptor;
  });
  ASSERT_NE(first, chart.corners.end());
  EXPECT_EQ(first->places, most_places);
  EXPECT_NEAR(wrap_angle(some.front().heading_rad + 0.6 - first->feature.heading_rad), 0.0, 1e-9);
}

TEST(CeilingLocate, FindsTheRobotBesideTheWayWhateverItsHeading) {
  ChartedLine line(10);
  const Ceiling method = charting();
  const CeilingChart chart = method.chart(line.around);
  for (const Pose2& truth : {Pose2{1.3, 0.2, 0.5}, Pose2{2.1, -0.4, 2.6}, Pose2{0.7, 0.5, -1.5}}) {
    const Pose2 believed = truth * Pose2{0.08, -0.06, 0.03};
    const Ceiling::Belief belief{known_to(believed, 0.1, 0.05)};
    const CeilingContent seen = line.ceiling.stored_from(truth, line.random).content;
    const auto located = method.locate(chart, belief, kStanding, seen);
    ASSERT_TRUE(located.fix) << located.refusals.back().reason;
    EXPECT_TRUE(located.refusals.empty()) << "the mosaic itself was refused: " << located.refusals.front().reason;
    const Pose2 place_from_robot = line.poses[located.fix->place.index].inverse() * truth;
    EXPECT_LT(place_from_robot.translation().norm(), 0.6) << "the nearest place";
    const Eigen::Vector3d off = se2_log(place_from_robot.inverse() * planar(located.fix->place_from_robot));
    EXPECT_LT(off.head<2>().norm(), 0.04);
    EXPECT_LT(std::abs(off.z()), 0.01);
    EXPECT_LT((located.belief.centre_from_robot.a_from_b.translation() - truth.translation()).norm(), 0.04);
  }
}

TEST(CeilingLocate, PlacesTogetherShowWhatNoneShowsAlone) {
  ChartedLine line(10, 12);
  const Ceiling method = charting();
  const Pose2 truth{1.7, 0.1, 0.9};
  const CeilingContent seen = line.ceiling.stored_from(truth, line.random).content;
  for (std::size_t i = 0; i < line.around.size(); ++i)
    EXPECT_FALSE(method.relate(*line.around[i].content, seen, known_to(line.poses[i].inverse() * truth, 0.1, 0.05)));
  const CeilingChart chart = method.chart(line.around);
  const auto located = method.locate(chart, {known_to(truth, 0.1, 0.05)}, kStanding, seen);
  ASSERT_TRUE(located.fix) << located.refusals.front().reason;
  EXPECT_LT((located.belief.centre_from_robot.a_from_b.translation() - truth.translation()).norm(), 0.06);
}

TEST(CeilingLocate, TheBeliefMovesWithTheStepAndWithoutAFix) {
  ChartedLine line(3);
  const Ceiling method = charting();
  const CeilingChart chart = method.chart(line.around);
  const Estimate seed{{kCharted, 1}, known_to({0.1, 0.0, 0.0}, 0.05, 0.02), 0.0};
  const Ceiling::Belief begun = method.begin(chart, seed);
  const Pose2 expected = line.poses[1] * Pose2{0.1, 0.0, 0.0};
  EXPECT_LT(se2_log(expected.inverse() * begun.centre_from_robot.a_from_b).norm(), 1e-9);
  const Step step{known_to({30.0, 0.0, 0.0}, 0.1, 0.01), true, {}};
  const auto located = method.locate(chart, begun, step, *line.around[0].content);
  EXPECT_FALSE(located.fix);
  ASSERT_EQ(located.refusals.size(), 1U);
  EXPECT_EQ(located.refusals.front().reason, "nothing_near");
  const Pose2 moved = expected * Pose2{30.0, 0.0, 0.0};
  EXPECT_LT(se2_log(moved.inverse() * located.belief.centre_from_robot.a_from_b).norm(), 1e-9);
  EXPECT_GT(located.belief.centre_from_robot.covariance(0, 0), begun.centre_from_robot.covariance(0, 0));
}

TEST(CeilingLocate, AChartWithoutContentsShowsNothing) {
  ChartedLine line(2);
  for (auto& place : line.around) place.content = nullptr;
  const Ceiling method = charting();
  const CeilingChart chart = method.chart(line.around);
  EXPECT_TRUE(chart.corners.empty());
  const CeilingContent seen = line.ceiling.stored_from({}, line.random).content;
  const auto located = method.locate(chart, {known_to({}, 0.1, 0.05)}, kStanding, seen);
  EXPECT_FALSE(located.fix);
  EXPECT_EQ(located.refusals.front().reason, "nothing_near");
}

TEST(CornerGrid, NamesAllPointsThatLieNear) {
  Random random(5);
  CornerGrid grid({-3.0, -2.0}, {5.0, 4.0});
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 400; ++i) {
    points.emplace_back(random.uniform(-3.0, 5.0), random.uniform(-2.0, 4.0));
    grid.add(points.back());
  }
  for (const Eigen::Vector2d& here :
       {Eigen::Vector2d(0.2, 0.3), Eigen::Vector2d(-3.0, 4.0), Eigen::Vector2d(9.0, 1.0)}) {
    std::set<std::uint32_t> named;
    grid.near(here, 0.7, [&](std::uint32_t number) { EXPECT_TRUE(named.insert(number).second); });
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const bool is_near = (points[i] - here).cwiseAbs().maxCoeff() <= 0.7;
      EXPECT_TRUE(!is_near || named.contains(i)) << i;
    }
    EXPECT_LT(named.size(), points.size() / 4);
  }
}

}  // namespace
}  // namespace weft::agents
