#include "clients/cli/rule_areas.hpp"

#include <gtest/gtest.h>

#include "core/network/change.hpp"
#include "tests/clients/cli/fleet.hpp"

namespace weft::cli::test {
namespace {

constexpr ExperienceId kOne{0xA1};
constexpr ExperienceId kTwo{0xB2};

/// Lays two loops that share a side, from (4, 0) to (12, 0), out on a plan, in the frame in which they were made.
struct RuleAreasOfTwoLoops : testing::Test {
  static RuleAreas on(const std::vector<Registration>& plans) {
    const std::vector<Batch> loops = two_loops(kOne, kTwo, {}, {});
    return {make_window(with(with(Snapshot{}, loops[0]), loops[1]), {}), plans};
  }

  Registration hall{"hall", content_hash(), {{"dock", {kOne, 0}, {0.0, 0.0}, {0.0, 0.0}, 0.05, 0.0}}};
  RuleAreas areas = on({hall});
  Area area{"hall", content_hash(), *parse_polygon("5.9,-1;8.1,-1;8.1,1;5.9,1")};
  Rule rule{.name = "wet", .spans = {{{kOne, 12}, {kOne, 16}}, {{kTwo, 4}, {kTwo, 8}}}, .area = area};
};

TEST_F(RuleAreasOfTwoLoops, GiveTheSpansOfWhatLiesWithinThem) {
  EXPECT_EQ(areas.spans_of(area).value(), rule.spans);
  EXPECT_EQ(areas.area_on("", area.corners).value(), area);
  EXPECT_EQ(areas.area_on("hall", area.corners).value(), area);
  EXPECT_EQ(areas.area_on("yard", area.corners).error().code, ErrorCode::not_found);
}

TEST_F(RuleAreasOfTwoLoops, CountWhatTheRuleDoesNotCover) {
  EXPECT_EQ(areas.not_covered(rule).value(), 0U);
  rule.spans = {{{kOne, 12}, {kOne, 16}}};
  EXPECT_EQ(areas.not_covered(rule).value(), 0U) << "the other loop's places lie on the same floor";
  rule.spans = {{{kOne, 12}, {kOne, 14}}};
  EXPECT_EQ(areas.not_covered(rule).value(), 4U) << "two of each loop";
  rule.area->corners = *parse_polygon("50,50;51,50;51,51");
  EXPECT_EQ(areas.not_covered(rule).value(), 0U) << "nothing lies within";
  rule.area.reset();
  EXPECT_EQ(areas.not_covered(rule).value(), 0U);
}

TEST_F(RuleAreasOfTwoLoops, OnPlansThatAreGoneOrOthersAreNamed) {
  RuleAreas none = on({});
  EXPECT_EQ(none.spans_of(area).error().code, ErrorCode::not_found);
  EXPECT_EQ(none.not_covered(rule).error().code, ErrorCode::not_found);
  hall.plan_hash.bytes[0] ^= 1U;
  RuleAreas another = on({hall});
  EXPECT_EQ(another.spans_of(area).error().code, ErrorCode::refused);
  EXPECT_EQ(another.not_covered(rule).error().code, ErrorCode::refused);
}

TEST(SpansAndPlaces, AreMadeOfEachOther) {
  const std::vector<Span> spans = {{{kOne, 3}, {kOne, 5}}, {{kOne, 7}, {kOne, 7}}, {{kTwo, 8}, {kTwo, 9}}};
  EXPECT_EQ(places_of(spans).size(), 6U);
  EXPECT_EQ(spans_of(places_of(spans)), spans);
  EXPECT_EQ(places_of({{{kOne, 5}, {kOne, 3}}}), places_of({{{kOne, 3}, {kOne, 5}}}));
  EXPECT_EQ(places_of({{{kOne, 5}, {kTwo, 3}}}).size(), 2U) << "over the edge between them";
}

}  // namespace
}  // namespace weft::cli::test
