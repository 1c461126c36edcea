#include "agents/navigation/taught_way.hpp"

#include <gtest/gtest.h>

namespace weft::agents {
namespace {

constexpr ExperienceId kExperience{7};

Trial found(double sigma_m = 0.01) {
  return {true, {}, sigma_m};
}
Trial refused(std::string_view why) {
  return {false, why, 0.0};
}

/// A place every quarter of a metre, found whatever comes.
TaughtWay way_of(double metres) {
  TaughtWay way;
  way.experience = kExperience;
  way.driven_m = metres;
  for (std::uint32_t i = 0; 0.25 * i < metres; ++i)
    way.places.push_back({{kExperience, i}, 0.25 * i, Trials{found(), found(), found()}});
  return way;
}

TEST(TaughtWayRows, ARowAMetre) {
  const auto rows = stretches_of(way_of(3.0), 1000);
  ASSERT_EQ(rows.size(), 3U);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].from_m, static_cast<double>(i));
    EXPECT_EQ(rows[i].to_m, static_cast<double>(i + 1));
    EXPECT_EQ(rows[i].places, 4U);
    EXPECT_EQ(rows[i].first, (PlaceId{kExperience, static_cast<std::uint32_t>(4 * i)}));
    EXPECT_EQ(rows[i].found, (std::array<double, prospects>{1.0, 1.0, 1.0}));
    EXPECT_NEAR(rows[i].sigma_m, 0.01, 1e-12);
    EXPECT_TRUE(rows[i].reason.empty());
  }
}

TEST(TaughtWayRows, TheEndBelongsToTheLastRowOrIsHalfOfOne) {
  EXPECT_EQ(stretches_of(way_of(2.4), 1000).size(), 2U);
  EXPECT_EQ(stretches_of(way_of(2.4), 1000).back().to_m, 2.4);
  EXPECT_EQ(stretches_of(way_of(2.6), 1000).size(), 3U);
  EXPECT_EQ(stretches_of(way_of(0.1), 1000).size(), 1U);
}

TEST(TaughtWayRows, ALongWayHasLongerRows) {
  const auto rows = stretches_of(way_of(2500.0), 1000);
  EXPECT_LE(rows.size(), 1000U);
  EXPECT_EQ(rows.front().to_m, 3.0);
  EXPECT_EQ(rows.back().to_m, 2500.0);
  std::uint32_t places = 0;
  for (const TaughtStretch& row : rows) places += row.places;
  EXPECT_EQ(places, 10'000U);
}

TEST(TaughtWayRows, TheWorstProspectSaysWhy) {
  TaughtWay way = way_of(1.0);
  way.places[0].trials = Trials{found(0.03), refused("few_matches"), refused("no_overlap")};
  way.places[1].trials = Trials{found(), refused("few_matches"), found()};
  way.places[2].trials = Trials{found(), refused("too_blank"), found()};
  const auto rows = stretches_of(way, 1000);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].found, (std::array<double, prospects>{1.0, 0.25, 0.75}));
  EXPECT_NEAR(rows[0].sigma_m, 0.015, 1e-12);
  EXPECT_EQ(rows[0].reason, "half light: few_matches");
}

TEST(TaughtWayRows, WhatIsNotFoundAsItIsIsNamedFirst) {
  TaughtWay way = way_of(1.0);
  for (TaughtPlace& place : way.places)
    place.trials = Trials{refused("few_matches"), refused("too_blank"), refused("too_blank")};
  const auto rows = stretches_of(way, 1000);
  EXPECT_EQ(rows[0].reason, "as is: few_matches");
  EXPECT_EQ(rows[0].sigma_m, 0.0);
}

TEST(TaughtWayRows, AMetreWithoutAPlaceFindsNothing) {
  TaughtWay way = way_of(3.0);
  std::erase_if(way.places, [](const TaughtPlace& place) { return place.at_m >= 1.0 && place.at_m < 2.0; });
  way.missed = {{1.2, "too_blank"}};
  const auto rows = stretches_of(way, 1000);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[1].places, 0U);
  EXPECT_EQ(rows[1].first, (PlaceId{kExperience, 3}));
  EXPECT_EQ(rows[1].found, (std::array<double, prospects>{}));
  EXPECT_EQ(rows[1].reason, "no place: too_blank");
}

TEST(TaughtWayRows, WhatIsNotTriedIsNotJudged) {
  TaughtWay way = way_of(4.0);
  for (TaughtPlace& place : way.places) {
    const bool is_tried = place.at_m < 1.0 || (place.at_m >= 2.0 && place.at_m < 2.3);
    if (!is_tried) place.trials.reset();
  }
  const auto rows = stretches_of(way, 1000);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].to_m, 2.0);
  EXPECT_EQ(rows[0].places, 8U);
  EXPECT_EQ(rows[1].from_m, 2.0);
  EXPECT_EQ(rows[1].to_m, 3.0) << "the last metre has not been tried";
  EXPECT_EQ(rows[1].places, 4U);
  EXPECT_EQ(rows[1].found[0], 1.0);
}

TEST(TaughtWayRows, NothingTaughtOrTriedIsNoRow) {
  EXPECT_TRUE(stretches_of({}, 1000).empty());
  TaughtWay way = way_of(2.0);
  for (TaughtPlace& place : way.places) place.trials.reset();
  EXPECT_TRUE(stretches_of(way, 1000).empty());
}

}  // namespace
}  // namespace weft::agents
