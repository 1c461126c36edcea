#include "core/network/rules.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/network/change.hpp"
#include "core/network/codec.hpp"
#include "core/network/removal.hpp"

namespace weft {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

constexpr ExperienceId there{1};
constexpr ExperienceId back{2};
constexpr ExperienceId aside{3};
constexpr double kStep_m = 0.5;

Edge edge(const PlaceId& a, const PlaceId& b, const Pose2& a_from_b, Origin origin) {
  Edge made;
  made.id = {a, b};
  made.a_from_b = Metric2{a_from_b, Eigen::Matrix3d::Identity() * 1e-6};
  made.origin = origin;
  made.method = "marks";
  made.drivable = origin == Origin::stitch ? Drivable::both : Drivable::a_to_b;
  return made;
}

Batch run(ExperienceId id, std::uint32_t places) {
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
      batch.edges.push_back(edge({id, index - 1}, {id, index}, {kStep_m, 0, 0}, Origin::odometry));
    }
  }
  return batch;
}

/// An aisle of ten places that was taught there and back over the same floor, and another one that leaves it in the
/// middle.
Snapshot aisle() {
  Batch returning = run(back, 10);
  for (std::uint32_t at = 0; at < 10; at += 3) {
    returning.edges.push_back(edge({there, 9 - at}, {back, at}, {0.0, 0.1, M_PI}, Origin::stitch));
  }
  Batch leaving = run(aside, 5);
  leaving.edges.push_back(edge({there, 5}, {aside, 0}, {0.0, kStep_m, M_PI / 2}, Origin::stitch));
  return with_label(with(with(with(Snapshot{}, run(there, 10)), returning), leaving), "dock", {there, 5});
}

struct Rules : testing::Test {
  Snapshot map = aisle();
  Rule rule{.name = "shut", .spans = {{{there, 3}, {there, 6}}}};
  Area hall{"hall", hash_bytes(Bytes{1}), {{0, 0}, {4, 0}, {4, 3}}};

  std::string refusal() const {
    const auto fits = check(map, rule);
    return fits ? "" : fits.error().message;
  }
};

TEST_F(Rules, HoldOnEveryRunThatCoversTheFloor) {
  const RuleExtent extent = extent_of(map, rule);
  EXPECT_THAT(extent.problem, IsEmpty());
  EXPECT_THAT(extent.forbidden, IsEmpty());
  EXPECT_THAT(extent.places, ElementsAre(PlaceId{there, 3}, PlaceId{there, 4}, PlaceId{there, 5}, PlaceId{there, 6},
                                         PlaceId{back, 3}, PlaceId{back, 4}, PlaceId{back, 5}, PlaceId{back, 6}));
}

TEST_F(Rules, HoldOnRunsThatAreJoinedSomeWayOff) {
  Batch returning = run(back, 10);
  returning.edges.push_back(edge({there, 9}, {back, 0}, {0.0, 0.1, M_PI}, Origin::stitch));
  map = with(with(Snapshot{}, run(there, 10)), returning);
  rule.spans = {{{there, 5}, {there, 6}}};
  EXPECT_THAT(extent_of(map, rule).places,
              ElementsAre(PlaceId{there, 5}, PlaceId{there, 6}, PlaceId{back, 3}, PlaceId{back, 4}));
}

TEST_F(Rules, NamedBackwardsHoldOnTheSamePlaces) {
  rule.spans = {{{there, 6}, {there, 3}}};
  EXPECT_THAT(extent_of(map, rule).places, SizeIs(8));
}

TEST_F(Rules, ReachAroundTheirLabelAlongTheWays) {
  rule.spans.clear();
  rule.label = "dock";
  EXPECT_THAT(extent_of(map, rule).places, ElementsAre(PlaceId{there, 5}, PlaceId{back, 4}));
  rule.within_m = 2 * kStep_m;
  const std::vector<PlaceId> places = extent_of(map, rule).places;
  for (const PlaceId& place : {PlaceId{there, 3}, PlaceId{there, 7}, PlaceId{aside, 1}, PlaceId{back, 3}}) {
    EXPECT_THAT(places, Contains(place));
  }
  EXPECT_THAT(places, Not(Contains(PlaceId{there, 2})));
  EXPECT_THAT(places, Not(Contains(PlaceId{aside, 2})));
}

TEST_F(Rules, OfOneWayForbidTheOtherOneOnEveryRun) {
  rule.kind = RuleKind::one_way;
  const std::vector<Span> forbidden = extent_of(map, rule).forbidden;
  EXPECT_THAT(forbidden, Contains(Span{{there, 4}, {there, 3}}));
  EXPECT_THAT(forbidden, Contains(Span{{back, 4}, {back, 5}}));
  EXPECT_THAT(forbidden, Not(Contains(Span{{there, 3}, {there, 4}})));
  EXPECT_THAT(forbidden, Not(Contains(Span{{back, 5}, {back, 4}})));
  EXPECT_THAT(forbidden, Not(Contains(Span{{there, 5}, {aside, 0}})));
  EXPECT_THAT(forbidden, Not(Contains(Span{{there, 3}, {back, 6}}))) << "across, on the spot";
}

TEST_F(Rules, ThatCloseOneDirectionForbidThatOne) {
  rule.one_direction = true;
  const std::vector<Span> forbidden = extent_of(map, rule).forbidden;
  EXPECT_THAT(forbidden, Contains(Span{{there, 3}, {there, 4}}));
  EXPECT_THAT(forbidden, Contains(Span{{back, 5}, {back, 4}}));
  EXPECT_THAT(forbidden, Not(Contains(Span{{back, 4}, {back, 5}})));
}

TEST_F(Rules, CloseAnEdgeBetweenRuns) {
  rule.spans = {{{there, 5}, {aside, 0}}};
  rule.one_direction = true;
  EXPECT_EQ(refusal(), "");
  EXPECT_THAT(extent_of(map, rule).forbidden, ElementsAre(Span{{there, 5}, {aside, 0}}));
}

TEST_F(Rules, HoldOnWhatIsLeftOfTheirPlaces) {
  const Snapshot thinner = without(with_rule(map, rule), {{{there, 0, 4}}, {}});
  ASSERT_THAT(thinner.rules(), SizeIs(1)) << "it stays, as the places may come back";
  EXPECT_THAT(extent_of(thinner, rule).places, Contains(PlaceId{there, 5}));
  const Snapshot none = without(thinner, {{{there, 0, 9}, {back, 0, 9}}, {}});
  EXPECT_THAT(extent_of(none, rule).places, IsEmpty());
  EXPECT_THAT(extent_of(none, rule).problem, HasSubstr("no place of 0000000000000001:3..6"));
}

TEST_F(Rules, AreReplacedByNameAndSharedByLaterRevisions) {
  Snapshot ruled = with_rule(map, rule);
  EXPECT_EQ(ruled.revision().value, map.revision().value + 1);
  rule.kind = RuleKind::parking;
  ruled = with_rule(ruled, rule);
  EXPECT_EQ(ruled.rules().at("shut").kind, RuleKind::parking);
  const Snapshot later =
      without(with_seal(with_label(ruled, "gate", {there, 1}), there, "done"), {{{aside, 0, 0}}, {}});
  EXPECT_EQ(later.shared_rules(), ruled.shared_rules());
  EXPECT_THAT(without_rule(later, "shut").rules(), IsEmpty());
}

TEST_F(Rules, ThatCannotHoldAreRefusedByNameAndBound) {
  rule.spans.clear();
  EXPECT_THAT(refusal(), HasSubstr("rule shut holds nowhere"));
  rule.label = "gate";
  EXPECT_THAT(refusal(), HasSubstr("no label gate"));
  rule.label = "dock";
  rule.kind = RuleKind::one_way;
  EXPECT_THAT(refusal(), HasSubstr("has a direction"));
  rule = {.name = "shut", .kind = RuleKind::speed, .value = 11.0, .spans = {{{there, 3}, {there, 6}}}};
  EXPECT_THAT(refusal(), HasSubstr("speed needs a value from 0.01 to 10 m/s, not 11"));
  rule.kind = RuleKind::capacity;
  rule.value = 1.5;
  EXPECT_THAT(refusal(), HasSubstr("a whole number from 1 to 1000 robots"));
  rule.kind = RuleKind::closed;
  EXPECT_THAT(refusal(), HasSubstr("closed takes no value"));
  rule.value = 0.0;
  rule.within_m = 2.0;
  EXPECT_THAT(refusal(), HasSubstr("around a label"));
  rule.within_m = 0.0;
  rule.spans = {{{there, 3}, {there, 60}}};
  EXPECT_THAT(refusal(), HasSubstr("place 0000000000000001:60 is not in the map"));
  rule.spans = {{{there, 3}, {aside, 2}}};
  EXPECT_THAT(refusal(), HasSubstr("no edge joins"));
  rule.name = "a b";
  EXPECT_THAT(refusal(), HasSubstr("rule"));
}

TEST_F(Rules, WithAnAreaThatCannotBeAreRefused) {
  rule.area = hall;
  EXPECT_EQ(refusal(), "") << "whether the plan is registered does not count";
  rule.area->plan = "the hall";
  EXPECT_THAT(refusal(), HasSubstr("rule shut, its area: "));
  rule.area = hall;
  rule.area->corners.resize(2);
  EXPECT_THAT(refusal(), HasSubstr("its area on plan hall has 2 corners; give 3 to 100"));
  rule.area->corners = {{0, 0}, {4, 0}, {4, std::nan("")}};
  EXPECT_THAT(refusal(), HasSubstr("has a corner farther than"));
  rule.area = hall;
  rule.one_direction = true;
  EXPECT_THAT(refusal(), HasSubstr("has a direction, which an area has not"));
}

TEST_F(Rules, WithAnAreaComeBackFromTheirBytesAndDamageIsSeen) {
  rule.area = hall;
  EXPECT_THAT(to_string(rule), HasSubstr(" (3 corners on plan hall)"));
  const Bytes bytes = encode(rule);
  EXPECT_EQ(decode_rule(bytes).value(), rule);
  for (std::size_t size = 0; size < bytes.size(); ++size) EXPECT_FALSE(decode_rule(ByteView(bytes).first(size)));
  rule.area->corners[1].x() = 1.1e6;
  EXPECT_THAT(decode_rule(encode(rule)).error().message, HasSubstr("area corner"));
}

TEST_F(Rules, AreSaidForPeople) {
  rule = {
      .name = "slow", .kind = RuleKind::speed, .value = 0.3, .spans = rule.spans, .label = "dock", .within_m = 2.5};
  EXPECT_EQ(to_string(rule), "speed 0.3 m/s on 0000000000000001:3..6 and within 2.5 m of dock");
  rule.spans = {{{there, 5}, {aside, 0}}};
  EXPECT_THAT(to_string(rule), HasSubstr("0000000000000001:5..0000000000000003:0"));
}

TEST_F(Rules, ComeBackFromTheirBytesAndDamageIsSeen) {
  rule = {
      .name = "slow", .kind = RuleKind::speed, .value = 0.3, .spans = rule.spans, .label = "dock", .within_m = 2.5};
  const Bytes bytes = encode(rule);
  EXPECT_EQ(decode_rule(bytes).value(), rule);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const auto read = decode_rule(ByteView(bytes).first(size));
    ASSERT_FALSE(read) << size;
    EXPECT_EQ(read.error().code, ErrorCode::corrupt);
  }
  rule.value = std::nan("");
  EXPECT_FALSE(decode_rule(encode(rule)));
}

}  // namespace
}  // namespace weft
