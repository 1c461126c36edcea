#include "agents/navigation/charted.hpp"

#include <gtest/gtest.h>

#include "tests/agents/methods/tiny/grid_filter.hpp"

namespace weft::agents {
namespace {

/// Notes what its charts are made of.
class Noting : public tiny::GridFilter {
 public:
  explicit Noting(std::vector<std::vector<PlaceId>>& charts) : charts_(&charts) {}
  Chart chart(const std::vector<ChartPlace<Content>>& around) const {
    charts_->emplace_back();
    for (const ChartPlace<Content>& place : around) charts_->back().push_back(place.id);
    return tiny::GridFilter::chart(around);
  }

 private:
  std::vector<std::vector<PlaceId>>* charts_;
};

/// Counts how often it goes on from what it believed.
class Remembering : public Noting {
 public:
  Remembering(std::vector<std::vector<PlaceId>>& charts, int& gone_on) : Noting(charts), gone_on_(&gone_on) {}
  using Noting::begin;
  Belief begin(const Chart& chart, const Estimate& seed, const Belief&) const {
    ++*gone_on_;
    return begin(chart, seed);
  }

 private:
  int* gone_on_;
};
static_assert(Remembers<Remembering> && !Remembers<Noting>);

class NoneArrived final : public Contents {
 public:
  std::shared_ptr<const Bytes> find(const ContentHash&) const override { return nullptr; }
};

PlaceId at(std::uint32_t index) {
  return {ExperienceId{1}, index};
}

/// Returns a window of a chain of three places.
Window window_from(std::uint32_t first) {
  Window window;
  window.revision = Revision{5};
  for (std::uint32_t i = first; i < first + 3; ++i) {
    Place place;
    place.id = at(i);
    window.places.emplace(place.id, place);
    Edge edge;
    edge.id = {at(i), at(i + 1)};
    edge.a_from_b = Metric2{Pose2{0.2, 0.0, 0.0}};
    if (i + 1 < first + 3) window.edges.emplace(edge.id, edge);
  }
  index_edges(window);
  return window;
}

TEST(Charted, IsMadeAnewWhenTheWindowHasMovedWithinOneRevision) {
  std::vector<std::vector<PlaceId>> charts;
  const Noting method(charts);
  Charted<Noting> charted(method);
  DecodedContents<Noting> decoded(method, 1U << 20U);
  const Estimate here{at(2), Metric2{}, 0.0};
  charted.prepare(window_from(0), NoneArrived{}, decoded, here);
  charted.prepare(window_from(0), NoneArrived{}, decoded, here);
  ASSERT_EQ(charts.size(), 1U) << "the same window";
  charted.prepare(window_from(1), NoneArrived{}, decoded, here);
  ASSERT_EQ(charts.size(), 2U);
  EXPECT_EQ(charts.back(), (std::vector<PlaceId>{at(2), at(1), at(3)}));
}

TEST(Charted, IsMadeAnewWhenARelationHasChanged) {
  std::vector<std::vector<PlaceId>> charts;
  const Noting method(charts);
  Charted<Noting> charted(method);
  DecodedContents<Noting> decoded(method, 1U << 20U);
  const Estimate here{at(1), Metric2{}, 0.0};
  Window window = window_from(0);
  charted.prepare(window, NoneArrived{}, decoded, here);
  Edge edge = *window.edges.value({at(0), at(1)});
  edge.a_from_b = Metric2{Pose2{0.3, 0.0, 0.0}};
  window.edges.insert_or_assign(edge.id, edge);
  index_edges(window);
  charted.prepare(window, NoneArrived{}, decoded, here);
  EXPECT_EQ(charts.size(), 2U);
}

TEST(Charted, ForgetsWhereTheRobotIsAndNotWhatElseTheMethodKnows) {
  std::vector<std::vector<PlaceId>> charts;
  int gone_on = 0;
  const Remembering method(charts, gone_on);
  Charted<Remembering> charted(method);
  DecodedContents<Remembering> decoded(method, 1U << 20U);
  charted.prepare(window_from(0), NoneArrived{}, decoded, {at(2), Metric2{}, 0.0});
  EXPECT_EQ(gone_on, 0);
  charted.forget();
  charted.prepare(window_from(0), NoneArrived{}, decoded, {at(1), Metric2{}, 0.0});
  EXPECT_EQ(charts.size(), 2U);
  EXPECT_EQ(gone_on, 1);
}

/// Carries its belief from chart to chart, and notes what it is told.
class Carrying : public tiny::GridFilter {
 public:
  struct Noted {
    int charts = 0;
    int begun = 0;
    std::vector<Estimate> carried;
    std::vector<double> told_m;  ///< of each `locate`
  };
  explicit Carrying(Noted& noted) : noted_(&noted) {}
  Chart chart(const std::vector<ChartPlace<Content>>& around) const {
    ++noted_->charts;
    return tiny::GridFilter::chart(around);
  }
  Belief begin(const Chart& chart, const Estimate& seed) const {
    ++noted_->begun;
    return tiny::GridFilter::begin(chart, seed);
  }
  Belief carried(const Chart&, const Estimate& seed, const Belief& before) const {
    noted_->carried.push_back(seed);
    return before;
  }
  Located<Belief> locate(const Chart&, Belief belief, const Step& step, const Content&) const {
    noted_->told_m.push_back(planar(step.previous_from_current).x);
    return {std::move(belief), std::nullopt, {}};
  }

 private:
  Noted* noted_;
};
static_assert(CarriesBelief<Carrying> && !CarriesBelief<Noting>);

/// Arranges a robot with a carried belief at the second of three places.
struct ChartedCarrying : testing::Test {
  static Step ahead(double metres) {
    return {Metric2{Pose2{metres, 0.0, 0.0}, 1e-4 * Eigen::Matrix3d::Identity()}, true, {}};
  }
  static Estimate estimate_at(const PlaceId& place, double ahead_m) {
    return {place, Metric2{Pose2{ahead_m, 0.0, 0.0}, 1e-3 * Eigen::Matrix3d::Identity()}, ahead_m};
  }
  void SetUp() override { charted.prepare(window_from(0), NoneArrived{}, decoded, estimate_at(at(1), 0.0)); }

  Carrying::Noted noted;
  const Carrying method{noted};
  Charted<Carrying> charted{method};
  DecodedContents<Carrying> decoded{method, 1U << 20U};
};

TEST_F(ChartedCarrying, StepsSinceTheLastLookAreToldOnce) {
  charted.advance(ahead(0.1));
  charted.locate({});
  charted.advance(ahead(0.05));
  charted.advance(ahead(0.07));
  charted.prepare(window_from(1), NoneArrived{}, decoded, estimate_at(at(1), 0.22));
  ASSERT_EQ(noted.carried.size(), 1U);
  EXPECT_EQ(noted.begun, 1);
  EXPECT_EQ(noted.carried.front().place, at(1));
  EXPECT_NEAR(planar(noted.carried.front().place_from_robot).x, 0.1, 1e-9) << "where it was at the last look";
  charted.locate({});
  ASSERT_EQ(noted.told_m.size(), 2U);
  EXPECT_NEAR(noted.told_m[0], 0.1, 1e-9);
  EXPECT_NEAR(noted.told_m[1], 0.12, 1e-9) << "all that it has driven since, in the new chart";
}

TEST_F(ChartedCarrying, RightAfterALookItIsWhereItIsBelievedToBe) {
  charted.advance(ahead(0.1));
  charted.locate({});
  charted.prepare(window_from(1), NoneArrived{}, decoded, estimate_at(at(2), -0.1));
  ASSERT_EQ(noted.carried.size(), 1U);
  EXPECT_NEAR(planar(noted.carried.front().place_from_robot).x, -0.1, 1e-9);
}

TEST_F(ChartedCarrying, AnotherPlaceToSayItByChangesNothing) {
  charted.stand();
  const auto before = charted.around(estimate_at(at(1), 0.15));
  const auto after = charted.around(estimate_at(at(2), -0.05));
  ASSERT_TRUE(before && after);
  EXPECT_NEAR(before->centre_from_robot.x, 0.15, 1e-9);
  EXPECT_NEAR(after->centre_from_robot.x, 0.15, 1e-9);
  EXPECT_EQ(before->chart, after->chart);
  charted.prepare(window_from(0), NoneArrived{}, decoded, estimate_at(at(2), -0.05));
  EXPECT_EQ(noted.charts, 1);
}

TEST_F(ChartedCarrying, FoundElsewhereItBeginsAnew) {
  charted.advance(ahead(0.1));
  charted.found(estimate_at(at(0), 0.0));
  EXPECT_FALSE(charted.around(estimate_at(at(0), 0.0)));
  charted.prepare(window_from(0), NoneArrived{}, decoded, estimate_at(at(0), 0.0));
  EXPECT_EQ(noted.begun, 2);
  EXPECT_TRUE(noted.carried.empty());
  charted.locate({});
  EXPECT_EQ(noted.told_m.back(), 0.0) << "where it was found it has not moved since";
}

TEST_F(ChartedCarrying, OutsideOfItsChartThereIsNone) {
  EXPECT_FALSE(charted.around(estimate_at(at(7), 0.0)));
  EXPECT_TRUE(charted.covers(at(2)));
  EXPECT_FALSE(charted.covers(at(7)));
}

TEST(Charted, WithoutCarryingAnotherPlaceToSayItByForgets) {
  std::vector<std::vector<PlaceId>> charts;
  const Noting method(charts);
  Charted<Noting> charted(method);
  DecodedContents<Noting> decoded(method, 1U << 20U);
  charted.prepare(window_from(0), NoneArrived{}, decoded, {at(1), Metric2{}, 0.0});
  charted.stand();
  EXPECT_FALSE(charted.covers(at(1)));
}

}  // namespace
}  // namespace weft::agents
