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

}  // namespace
}  // namespace weft::agents
