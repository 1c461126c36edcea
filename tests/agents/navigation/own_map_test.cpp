#include "agents/navigation/own_map.hpp"

#include <gtest/gtest.h>

namespace weft::agents {
namespace {

Place a_place(const PlaceId& id, const std::string& method) {
  Place place;
  place.id = id;
  place.method = method;
  return place;
}

Edge an_edge(const PlaceId& a, const PlaceId& b) {
  Edge edge;
  edge.id = {a, b};
  return edge;
}

const PlaceId kOne{ExperienceId{1}, 0};
const PlaceId kOther{ExperienceId{2}, 0};
const PlaceId kOwn{ExperienceId{3}, 0};

Window mixed() {
  Window window;
  window.revision = Revision{5};
  window.places.emplace(kOne, a_place(kOne, "floor"));
  window.places.emplace(kOther, a_place(kOther, "along"));
  window.edges.emplace({kOne, kOther}, an_edge(kOne, kOther));
  window.labels = {{"dock", kOne}, {"shelf", kOther}};
  index_edges(window);
  return window;
}

TEST(OwnMap, LeavesOutWhatOtherMethodsSee) {
  OwnMap own("floor");
  const Window window = mixed();
  own.update(window, 1, true);
  const Window& seen = own.map(window);
  EXPECT_NE(seen.place(kOne), nullptr);
  EXPECT_EQ(seen.place(kOther), nullptr);
  EXPECT_TRUE(seen.edges.empty());
  EXPECT_EQ(seen.labels.size(), 1U);
  EXPECT_EQ(seen.revision, window.revision);
}

TEST(OwnMap, OfOneMethodIsTheWindowItself) {
  OwnMap own("floor");
  Window window;
  window.places.emplace(kOne, a_place(kOne, "floor"));
  own.update(window, 1, true);
  EXPECT_EQ(&own.map(window), &window) << "not a copy";
}

TEST(OwnMap, AWindowThatMovesWithinOneRevisionIsAnotherOne) {
  OwnMap own("floor");
  Window window = mixed();
  own.update(window, 1, true);
  const PlaceId further{ExperienceId{1}, 7};
  window.places.erase_all({kOne});
  window.edges.erase_all({EdgeId{kOne, kOther}});
  window.places.emplace(further, a_place(further, "floor"));
  window.edges.emplace({kOther, further}, an_edge(kOther, further));
  index_edges(window);
  own.update(window, 2, true);
  EXPECT_NE(own.map(window).place(further), nullptr);
  EXPECT_EQ(own.map(window).place(kOne), nullptr);
}

TEST(OwnMap, OwnPlacesAreJoinedUntilTheWindowHasThem) {
  OwnMap own("floor");
  Window window = mixed();
  own.update(window, 1, false);
  own.add(a_place(kOwn, "floor"), {an_edge(kOne, kOwn)});
  own.update(window, 1, false);
  EXPECT_TRUE(own.has(kOwn));
  EXPECT_NE(own.map(window).place(kOwn), nullptr);
  EXPECT_EQ(own.map(window).edges.size(), 1U);
  EXPECT_EQ(own.map(window).place(kOther), nullptr);

  window.places.emplace(kOwn, a_place(kOwn, "floor"));
  index_edges(window);
  own.update(window, 2, true);
  EXPECT_FALSE(own.has(kOwn));
  EXPECT_NE(own.map(window).place(kOwn), nullptr) << "the window's";
  EXPECT_EQ(own.map(window).place(kOther), nullptr);
}

}  // namespace
}  // namespace weft::agents
