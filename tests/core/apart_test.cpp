#include "core/network/apart.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/network/change.hpp"
#include "tests/support/network_maker.hpp"

namespace weft {
namespace {

struct Aparts : testing::Test {
  Random random{5};
  Snapshot whole = support::make_network(random);
  ExperienceId one = whole.experiences().begin()->first;
  ExperienceId two = std::next(whole.experiences().begin())->first;
  Apart apart{{one, 2, 5}, {two, 1, 3}};

  std::string refusal(const Apart& asked) const {
    const auto fits = check(whole, asked);
    return fits ? "" : fits.error().message;
  }
  ErrorCode code(const Apart& asked) const {
    const auto fits = check(whole, asked);
    EXPECT_FALSE(fits) << to_string(asked);
    return fits ? ErrorCode::internal : fits.error().code;
  }
};

TEST_F(Aparts, AnswersForPlacesOfTheTwoStretchesInEitherOrder) {
  const Snapshot vouched = with_apart(whole, apart);
  EXPECT_EQ(vouched.revision().value, whole.revision().value + 1);
  for (const std::uint32_t at : {2U, 5U}) {
    for (const std::uint32_t other : {1U, 3U}) {
      EXPECT_TRUE(are_apart(vouched, {one, at}, {two, other}));
      EXPECT_TRUE(are_apart(vouched, {two, other}, {one, at}));
      EXPECT_FALSE(are_apart(whole, {one, at}, {two, other}));
    }
  }
  EXPECT_FALSE(are_apart(vouched, {one, 1}, {two, 1}));
  EXPECT_FALSE(are_apart(vouched, {one, 6}, {two, 1}));
  EXPECT_FALSE(are_apart(vouched, {one, 2}, {two, 4}));
  EXPECT_FALSE(are_apart(vouched, {one, 2}, {one, 3})) << "both on the same of the two";
}

TEST_F(Aparts, AreOnePairWhicheverIsNamedFirst) {
  const Apart turned{apart.other, apart.one};
  EXPECT_EQ(ordered(apart), ordered(turned));
  const Snapshot vouched = with_apart(with_apart(whole, turned), apart);
  EXPECT_EQ(vouched.aparts(), Snapshot::Aparts{ordered(apart)});
  EXPECT_TRUE(without_apart(vouched, turned).aparts().empty());
}

TEST_F(Aparts, AreSharedByLaterRevisionsThatChangeSomethingElse) {
  const Snapshot vouched = with_apart(whole, apart);
  const Snapshot labelled = with_label(vouched, "dock", {one, 3});
  const Snapshot sealed = with_seal(labelled, one, "done");
  const Snapshot thinner = without(sealed, {{{one, 2, 4}}, {}});
  for (const Snapshot* const later : {&labelled, &sealed, &thinner}) {
    EXPECT_EQ(later->shared_aparts(), vouched.shared_aparts());
  }
  support::BatchPlan plan{.experience = {4711}, .robot = support::random_id<RobotId>(random)};
  EXPECT_EQ(with(vouched, support::make_batch(random, vouched, plan)).shared_aparts(), vouched.shared_aparts());
}

TEST_F(Aparts, GoWithTheLastPlaceOfAStretch) {
  const Apart second{{one, 0, 9}, {two, 4, 6}};
  const Snapshot vouched = with_apart(with_apart(whole, apart), second);
  EXPECT_EQ(without(vouched, {{{two, 1, 3}}, {}}).aparts(), Snapshot::Aparts{second});
  EXPECT_EQ(without(vouched, {{{one, 3, 5}}, {}}).aparts(), vouched.aparts()) << "place 2 is still there";
}

TEST_F(Aparts, RefusesWhatCannotBeTwoFloors) {
  EXPECT_EQ(refusal(apart), "");
  EXPECT_EQ(code({{one, 5, 2}, {two, 1, 3}}), ErrorCode::invalid);
  EXPECT_EQ(code({{one, 2, 5}, {one, 2, 5}}), ErrorCode::invalid);
  EXPECT_THAT(refusal({{one, 2, 5}, {one, 2, 5}}), testing::HasSubstr("named twice"));
  EXPECT_EQ(code({{one, 2, 5}, {one, 5, 8}}), ErrorCode::invalid);
  EXPECT_THAT(refusal({{one, 2, 6}, {one, 5, 8}}), testing::HasSubstr("share the places 5 to 6"));
  EXPECT_EQ(refusal({{one, 2, 5}, {one, 6, 8}}), "") << "two floors of one run";
}

TEST_F(Aparts, RefusesWhatIsNotInTheMap) {
  const ExperienceId unknown{0xdead};
  EXPECT_EQ(code({{unknown, 0, 1}, {two, 1, 3}}), ErrorCode::not_found);
  EXPECT_THAT(refusal({{one, 2, 5}, {unknown, 0, 1}}), testing::HasSubstr("000000000000dead"));
  const std::uint32_t behind = whole.experience(one)->extent;
  EXPECT_EQ(code({{one, 0, behind}, {two, 1, 3}}), ErrorCode::not_found)
      << "what a robot teaches later is no part of what was vouched for";
  EXPECT_THAT(refusal({{one, 0, behind}, {two, 1, 3}}),
              testing::HasSubstr("the last place of that experience is " + std::to_string(behind - 1)));
  const Snapshot thinner = without(whole, {{{one, 2, 5}}, {}});
  const auto fits = check(thinner, apart);
  ASSERT_FALSE(fits);
  EXPECT_EQ(fits.error().code, ErrorCode::not_found);
}

TEST_F(Aparts, RefusesToVouchTwice) {
  const Snapshot vouched = with_apart(whole, apart);
  const auto again = check(vouched, {apart.other, apart.one});
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().code, ErrorCode::conflict);
}

}  // namespace
}  // namespace weft
