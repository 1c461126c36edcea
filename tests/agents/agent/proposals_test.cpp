#include "agents/agent/proposals.hpp"

#include <gtest/gtest.h>

#include "tests/agents/agent/rig.hpp"

namespace weft::agents::test {
namespace {

constexpr ExperienceId kProposedRun{70};
const std::vector<PlaceId> kProposed{{kProposedRun, 4}, {kProposedRun, 9}};
constexpr WindowSize kUsual{.hops = 25, .cap = 100};

WindowDefinition around(std::uint32_t index) {
  return {.centre = PlaceId{kProposedRun, index}, .hops = kUsual.hops, .cap = kUsual.cap, .route = {}};
}

TEST(Proposals, RobotThatKnowsNothingGetsAWindowOfThemAlone) {
  Proposals proposals(kUsual);
  proposals.set(kProposed);
  const WindowDefinition wanted = proposals.wanted(around(30), std::nullopt, {.places = 100});
  EXPECT_TRUE(proposals.is_alone());
  EXPECT_EQ(wanted.centre, kProposed.front());
  EXPECT_EQ(wanted.hops, 3U);
  EXPECT_EQ(wanted.cap, 52U);
  EXPECT_EQ(wanted.route, kProposed);
}

TEST(Proposals, RobotThatKnowsSomethingHoldsThemBesideItsWindow) {
  Proposals proposals(kUsual);
  proposals.set(kProposed);
  const WindowDefinition wanted =
      proposals.wanted(around(30), std::nullopt, {.places = 100, .knows_something = true});
  EXPECT_FALSE(proposals.is_alone());
  EXPECT_EQ(wanted.centre, around(30).centre);
  EXPECT_EQ(wanted.cap, kUsual.cap);
  EXPECT_EQ(wanted.route, kProposed);
}

TEST(Proposals, WholeNetworkThatFitsStays) {
  Proposals proposals(kUsual);
  proposals.set(kProposed);
  WindowDefinition whole = around(0);
  whole.centre.reset();
  EXPECT_FALSE(proposals.wanted(whole, std::nullopt, {.places = 99}).centre.has_value());
  EXPECT_FALSE(proposals.is_alone());
  EXPECT_TRUE(proposals.wanted(whole, std::nullopt, {.places = 100}).centre.has_value());
  EXPECT_TRUE(proposals.is_alone());
}

TEST(Proposals, SuspectedPlaceIsTheCentre) {
  Proposals proposals(kUsual);
  proposals.set(kProposed);
  EXPECT_TRUE(proposals.suspect(kProposed.back()));
  EXPECT_FALSE(proposals.suspect(kProposed.back())) << "it is known by now";
  EXPECT_EQ(proposals.wanted(around(30), std::nullopt, {.places = 100}).centre, kProposed.back());
}

TEST(Proposals, UsualWindowIsAsItWasBeforeButForWhatIsHeld) {
  Proposals proposals(kUsual);
  proposals.set(kProposed);
  const Route route = a_route(kProposedRun, 3, 1);
  const WindowDefinition alone = proposals.wanted(around(30), route, {.places = 100});
  proposals.forget();
  const WindowDefinition usual = proposals.usual(alone, route);
  EXPECT_FALSE(usual.centre.has_value()) << "where it was is not known";
  EXPECT_EQ(usual.hops, kUsual.hops);
  EXPECT_EQ(usual.cap, kUsual.cap);
  EXPECT_EQ(usual.route, route.places);
}

TEST(Proposals, NoteIsNewsOnceUntilTheyAreForgotten) {
  Proposals proposals(kUsual);
  EXPECT_TRUE(proposals.is_news("2 places"));
  EXPECT_FALSE(proposals.is_news("2 places"));
  EXPECT_TRUE(proposals.is_news("3 places"));
  proposals.forget();
  EXPECT_TRUE(proposals.is_news("3 places"));
}

TEST(Proposals, ContentsOfThemComeBeforeOthersAndOnce) {
  Window window;
  std::vector<ContentRef> contents;
  for (std::uint32_t index : {1U, 4U, 9U}) {
    const Place place = a_place(kProposedRun, index, {}, some_content(index, 10));
    window.places.emplace(place.id, place);
    contents.push_back(place.content);
  }
  index_edges(window);
  Proposals proposals(kUsual);
  EXPECT_EQ(proposals.put_first(contents, window), contents);
  proposals.set({{kProposedRun, 9}, {kProposedRun, 8}});
  EXPECT_EQ(proposals.put_first(contents, window), (std::vector<ContentRef>{contents[2], contents[0], contents[1]}));
  proposals.suspect(PlaceId{kProposedRun, 4});
  EXPECT_EQ(proposals.put_first(contents, window), (std::vector<ContentRef>{contents[1], contents[2], contents[0]}));
}

}  // namespace
}  // namespace weft::agents::test
