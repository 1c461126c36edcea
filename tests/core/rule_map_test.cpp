#include "core/network/rule_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/network/change.hpp"

namespace weft {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr ExperienceId kLane{1};
constexpr ExperienceId kBypass{2};
const std::set<std::string> kMarks{"marks"};

Edge edge(const PlaceId& a, const PlaceId& b, const Pose2& a_from_b, Drivable drivable, Origin origin) {
  Edge made;
  made.id = {a, b};
  made.a_from_b = Metric2{a_from_b, Eigen::Matrix3d::Identity() * 1e-6};
  made.origin = origin;
  made.method = "marks";
  made.drivable = drivable;
  return made;
}

Batch run(ExperienceId id, std::uint32_t places, double step_m, Drivable drivable) {
  Batch batch;
  batch.experience = id;
  batch.sequence = 1;
  batch.method = "marks";
  for (std::uint32_t index = 0; index < places; ++index) {
    Place place;
    place.id = {id, index};
    place.method = "marks";
    place.content.hash.bytes[0] = 1;
    place.content.size = 1;
    batch.places.push_back(place);
    if (index > 0) {
      batch.edges.push_back(edge({id, index - 1}, {id, index}, {step_m, 0, 0}, drivable, Origin::odometry));
    }
  }
  return batch;
}

/// Returns a lane of ten places that can be driven both ways, and a longer way round its middle, from place 2 to 7.
Snapshot site() {
  Batch round = run(kBypass, 6, 2.0, Drivable::both);
  round.edges.push_back(edge({kLane, 2}, {kBypass, 0}, {0.0, 2.0, 0.0}, Drivable::both, Origin::stitch));
  round.edges.push_back(edge({kLane, 7}, {kBypass, 5}, {0.0, 2.0, 0.0}, Drivable::both, Origin::stitch));
  return with(with(Snapshot{}, run(kLane, 10, 1.0, Drivable::both)), round);
}

struct RuleMaps : testing::Test {
  Snapshot map = site();

  void lay(const Rule& rule) { map = with_rule(map, rule); }
  static Rule on(RuleKind kind, std::uint32_t from, std::uint32_t to, double value = 0.0) {
    return {.name = "it", .kind = kind, .value = value, .spans = {{{kLane, from}, {kLane, to}}}};
  }
  Result<Path> way(std::uint32_t from, std::uint32_t to, bool keeps_limits = true) const {
    return shortest_path(map, RuleMap(map), {kLane, from}, {kLane, to}, kMarks,
                         {.begins = {kLane, from}, .keeps_limits = keeps_limits});
  }
  bool goes_round(std::uint32_t from, std::uint32_t to, bool keeps_limits = true) const {
    const Result<Path> found = way(from, to, keeps_limits);
    return found && std::ranges::count(found->places, PlaceId{kBypass, 2}) == 1;
  }
  Route route(std::uint32_t from, std::uint32_t to) const {
    Route made;
    for (std::uint32_t at = from; at <= to; ++at) made.places.push_back({kLane, at});
    return made;
  }
  ReleasedByRules released(const Route& route, std::uint32_t from, std::optional<std::uint32_t> through,
                           bool keeps_limits = true) const {
    return released_by_rules(RuleMap(map), route, from, through, keeps_limits);
  }
};

TEST_F(RuleMaps, WithoutRulesNothingIsBarred) {
  const Result<Path> free = shortest_path(map, {kLane, 0}, {kLane, 9}, kMarks);
  ASSERT_TRUE(way(0, 9));
  EXPECT_EQ(way(0, 9)->places, free->places);
  EXPECT_DOUBLE_EQ(way(0, 9)->length_m, free->length_m);
  EXPECT_TRUE(is_free(RuleMap(map), *free, {.begins = {kLane, 0}}));
  EXPECT_EQ(released(route(0, 9), 0, 9).through, 9U);
}

TEST_F(RuleMaps, WaysLeadRoundWhatIsClosed) {
  lay(on(RuleKind::closed, 4, 5));
  EXPECT_TRUE(goes_round(0, 9));
  EXPECT_TRUE(goes_round(9, 0));
  EXPECT_FALSE(is_free(RuleMap(map), *shortest_path(site(), {kLane, 0}, {kLane, 9}, kMarks), {.begins = {kLane, 0}}));
}

TEST_F(RuleMaps, WhoIsInsideMayLeaveAndNotComeBack) {
  lay(on(RuleKind::closed, 4, 5));
  ASSERT_TRUE(way(4, 9));
  EXPECT_EQ(way(4, 9)->places.front(), (PlaceId{kLane, 4}));
  EXPECT_FALSE(goes_round(4, 9));
  EXPECT_FALSE(way(3, 5));
}

TEST_F(RuleMaps, TheOnlyWayIsBarredByName) {
  lay(on(RuleKind::closed, 8, 9));
  const Result<Path> none = way(0, 9);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::not_found);
  EXPECT_THAT(none.error().message,
              HasSubstr("rule it bars the way to 0000000000000001:9 from 0000000000000001:8 on"));
}

TEST_F(RuleMaps, OneWayIsDrivenThatWayAlone) {
  lay(on(RuleKind::one_way, 3, 6));
  EXPECT_FALSE(goes_round(0, 9));
  EXPECT_TRUE(goes_round(9, 0));
  EXPECT_FALSE(goes_round(5, 0)) << "who is inside may leave either way";
  EXPECT_TRUE(goes_round(6, 0)) << "at its end one is not inside";
}

TEST_F(RuleMaps, OneDirectionOfAnEdgeIsClosed) {
  Rule rule = on(RuleKind::closed, 4, 5);
  rule.one_direction = true;
  lay(rule);
  EXPECT_TRUE(goes_round(0, 9));
  EXPECT_TRUE(goes_round(4, 9));
  EXPECT_FALSE(goes_round(9, 0));
}

TEST_F(RuleMaps, SlowWaysCostMore) {
  lay(on(RuleKind::speed, 3, 6, 0.5));
  EXPECT_FALSE(goes_round(0, 9)) << "the way round takes longer";
  lay(on(RuleKind::speed, 3, 6, 0.1));
  EXPECT_TRUE(goes_round(0, 9));
  lay(on(RuleKind::speed, 3, 6, 2.0));
  EXPECT_FALSE(goes_round(0, 9)) << "faster than robots drive";
}

TEST_F(RuleMaps, LimitsAreClosedToWhoDoesNotKeepThem) {
  lay(on(RuleKind::speed, 3, 6, 0.5));
  EXPECT_TRUE(goes_round(0, 9, false));
  EXPECT_EQ(released(route(0, 9), 0, 9, false).through, 2U);
  EXPECT_EQ(released(route(0, 9), 0, 9, true).through, 9U);
}

TEST_F(RuleMaps, ReleasesEndBeforeWhatIsClosed) {
  lay(on(RuleKind::closed, 4, 5));
  const ReleasedByRules first = released(route(0, 9), 0, 9);
  EXPECT_EQ(first.through, 3U);
  EXPECT_EQ(first.rule, "it");
  const ReleasedByRules more = released(route(0, 9), 3, 9);
  EXPECT_EQ(more.through, std::nullopt);
  EXPECT_EQ(more.rule, "it");
  EXPECT_EQ(released(route(0, 9), 4, 9).through, 9U) << "who is inside leaves";
  EXPECT_EQ(released(route(3, 9), 0, 6).through, 0U) << "where it stands it may stand";
  const ReleasedByRules others = released(route(0, 9), 1, std::nullopt);
  EXPECT_EQ(others.through, std::nullopt);
  EXPECT_EQ(others.rule, "") << "others are in the way, not the rule";
}

TEST_F(RuleMaps, ReleasesDoNotGrowWhereRobotsAreHeld) {
  lay(on(RuleKind::hold, 4, 5));
  EXPECT_EQ(released(route(0, 9), 0, 9).through, 3U);
  EXPECT_EQ(released(route(0, 9), 4, 9).through, std::nullopt);
  EXPECT_EQ(released(route(0, 9), 6, 9).through, 9U);
  EXPECT_FALSE(goes_round(0, 9)) << "a hold ends: routes do not lead round it";
  EXPECT_EQ(first_barred(RuleMap(map), route(0, 9), 0, true), std::nullopt);
}

TEST_F(RuleMaps, RoutesUnderWayAreLookedAtBeyondTheirReleasedPoint) {
  lay(on(RuleKind::closed, 4, 5));
  EXPECT_EQ(first_barred(RuleMap(map), route(0, 9), 0, true), 4U);
  EXPECT_EQ(first_barred(RuleMap(map), route(0, 9), 4, true), std::nullopt);
}

TEST_F(RuleMaps, LimitsOfARouteAreItsPiecesByTheLowest) {
  EXPECT_THAT(limits_of(RuleMap(map), route(0, 9).places), IsEmpty());
  lay(on(RuleKind::speed, 2, 6, 0.5));
  Rule slower = on(RuleKind::speed, 4, 5, 0.25);
  slower.name = "slower";
  lay(slower);
  EXPECT_THAT(limits_of(RuleMap(map), route(0, 9).places),
              ElementsAre(SpeedLimit{2, 3, 0.5}, SpeedLimit{4, 5, 0.25}, SpeedLimit{6, 6, 0.5}));
}

TEST_F(RuleMaps, NoMoreLimitsThanARouteHasRoomFor) {
  lay(on(RuleKind::speed, 2, 2, 0.5));
  std::vector<PlaceId> places;
  for (std::size_t at = 0; at < 2 * kRouteLimits + 20; ++at) places.push_back({kLane, at % 2 == 0 ? 2U : 0U});
  const std::vector<SpeedLimit> limits = limits_of(RuleMap(map), places);
  EXPECT_THAT(limits, SizeIs(kRouteLimits));
  EXPECT_EQ(limits.back().to, places.size() - 2) << "the last one reaches as far as there is any";
}

TEST_F(RuleMaps, GoalsHaveAtLeastTheClassOfTheirPlace) {
  lay(on(RuleKind::priority, 8, 9, 4.0));
  EXPECT_EQ(RuleMap(map).priority({kLane, 9}), 4);
  EXPECT_EQ(RuleMap(map).priority({kLane, 0}), 0);
}

}  // namespace
}  // namespace weft
