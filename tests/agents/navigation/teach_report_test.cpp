#include "agents/navigation/teach_report.hpp"

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

/// Returns the shares found, by condition.
std::vector<double> shares_of(const TaughtStretch& row) {
  std::vector<double> shares;
  for (const Diagnostic& share : row.found)
    if (share.name != kSeenShare) shares.push_back(share.value);
  return shares;
}

/// Returns a run with a place every quarter of a metre, each found whatever comes.
TeachReport way_of(double metres) {
  TeachReport way;
  way.experience = kExperience;
  way.conditions = {"as_is", "half_light", "worn"};
  way.driven_m = metres;
  for (std::uint32_t i = 0; 0.25 * i < metres; ++i)
    way.places.push_back({{kExperience, i}, 0.25 * i, Trials{found(), found(), found()}});
  return way;
}

TEST(TeachReportRows, ARowAMetre) {
  const auto rows = stretches_of(way_of(3.0), 1000);
  ASSERT_EQ(rows.size(), 3U);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].from_m, static_cast<double>(i));
    EXPECT_EQ(rows[i].to_m, static_cast<double>(i + 1));
    EXPECT_EQ(rows[i].places, 4U);
    EXPECT_EQ(rows[i].first, (PlaceId{kExperience, static_cast<std::uint32_t>(4 * i)}));
    EXPECT_EQ(shares_of(rows[i]), (std::vector<double>{1.0, 1.0, 1.0}));
    EXPECT_NEAR(rows[i].sigma_m, 0.01, 1e-12);
    EXPECT_TRUE(rows[i].reason.empty());
  }
}

TEST(TeachReportRows, TheEndBelongsToTheLastRowOrIsHalfOfOne) {
  EXPECT_EQ(stretches_of(way_of(2.4), 1000).size(), 2U);
  EXPECT_EQ(stretches_of(way_of(2.4), 1000).back().to_m, 2.4);
  EXPECT_EQ(stretches_of(way_of(2.6), 1000).size(), 3U);
  EXPECT_EQ(stretches_of(way_of(0.1), 1000).size(), 1U);
}

TEST(TeachReportRows, ALongWayHasLongerRows) {
  const auto rows = stretches_of(way_of(2500.0), 1000);
  EXPECT_LE(rows.size(), 1000U);
  EXPECT_EQ(rows.front().to_m, 3.0);
  EXPECT_EQ(rows.back().to_m, 2500.0);
  std::uint32_t places = 0;
  for (const TaughtStretch& row : rows) places += row.places;
  EXPECT_EQ(places, 10'000U);
}

TEST(TeachReportRows, TheWorstConditionSaysWhy) {
  TeachReport way = way_of(1.0);
  way.places[0].trials = Trials{found(0.03), refused("few_matches"), refused("no_overlap")};
  way.places[1].trials = Trials{found(), refused("few_matches"), found()};
  way.places[2].trials = Trials{found(), refused("too_blank"), found()};
  const auto rows = stretches_of(way, 1000);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(shares_of(rows[0]), (std::vector<double>{1.0, 0.25, 0.75}));
  EXPECT_NEAR(rows[0].sigma_m, 0.015, 1e-12);
  EXPECT_EQ(rows[0].reason, "half light: few_matches");
  EXPECT_EQ(rows[0].found[1].name, "half_light");
  EXPECT_NEAR(rows[0].found[1].sigma, 0.2165, 1e-4) << "of a quarter of four places";
  EXPECT_EQ(rows[0].found[1].bound, kFoundEnough);
}

TEST(TeachReportRows, WhatIsNotFoundAsItIsIsNamedFirst) {
  TeachReport way = way_of(1.0);
  for (TaughtPlace& place : way.places)
    place.trials = Trials{refused("few_matches"), refused("too_blank"), refused("too_blank")};
  const auto rows = stretches_of(way, 1000);
  EXPECT_EQ(rows[0].reason, "as is: few_matches");
  EXPECT_EQ(rows[0].sigma_m, 0.0);
}

TEST(TeachReportRows, AMetreWithoutAPlaceFindsNothing) {
  TeachReport way = way_of(3.0);
  std::erase_if(way.places, [](const TaughtPlace& place) { return place.at_m >= 1.0 && place.at_m < 2.0; });
  way.missed = {{1.2, "too_blank"}};
  const auto rows = stretches_of(way, 1000);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[1].places, 0U);
  EXPECT_EQ(rows[1].first, (PlaceId{kExperience, 3}));
  EXPECT_EQ(shares_of(rows[1]), (std::vector<double>{0.0, 0.0, 0.0}));
  EXPECT_EQ(rows[1].reason, "no place: too_blank");
}

TEST(TeachReportRows, SayHowMuchOfTheWayWasSeen) {
  TeachReport way = way_of(3.0);
  way.places[0].trials = Trials{found(), refused("few_matches"), found()};
  way.blind = {{0.9, 1.5, "dark"}, {1.6, 1.7, "blurred"}};
  const auto rows = stretches_of(way, 1000);
  ASSERT_EQ(rows.size(), 3U);
  for (const TaughtStretch& row : rows) EXPECT_EQ(row.found.back().name, kSeenShare);
  EXPECT_NEAR(rows[0].found.back().value, 0.9, 1e-9);
  EXPECT_EQ(rows[0].reason, "half light: few_matches") << "three of four are fewer than nine tenths";
  EXPECT_NEAR(rows[1].found.back().value, 0.4, 1e-9);
  EXPECT_EQ(rows[1].found.back().bound, kFoundEnough);
  EXPECT_EQ(rows[1].reason, "seen: dark");
  EXPECT_EQ(rows[2].found.back().value, 1.0);
  EXPECT_TRUE(rows[2].reason.empty());
}

TEST(TeachReportRows, WhatIsNotTriedIsNotJudged) {
  TeachReport way = way_of(4.0);
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
  EXPECT_EQ(rows[1].found[0].value, 1.0);
}

TEST(TeachReportRows, NothingTaughtOrTriedIsNoRow) {
  EXPECT_TRUE(stretches_of({}, 1000).empty());
  TeachReport way = way_of(2.0);
  for (TaughtPlace& place : way.places) place.trials.reset();
  EXPECT_TRUE(stretches_of(way, 1000).empty());
}

}  // namespace
}  // namespace weft::agents
