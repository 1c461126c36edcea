#include "clients/cli/label_placement.hpp"

#include <gtest/gtest.h>

#include "clients/cli/text_width.hpp"
#include "core/random.hpp"

namespace weft::cli::test {
namespace {

constexpr Box kFrame = {8.0, 80.0, 1592.0, 900.0};

/// Expects that nothing covers anything, and that all of it is in the frame.
void expect_apart(const std::vector<LabelWish>& wishes, const std::vector<Box>& marks, const LabelPlacement& placed) {
  ASSERT_EQ(placed.boxes.size(), wishes.size());
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    const Box& box = placed.boxes[i];
    EXPECT_DOUBLE_EQ(box.right - box.left, wishes[i].wide);
    EXPECT_DOUBLE_EQ(box.bottom - box.top, wishes[i].tall);
    EXPECT_GE(box.left, placed.frame.left);
    EXPECT_GE(box.top, placed.frame.top);
    EXPECT_LE(box.right, placed.frame.right);
    EXPECT_LE(box.bottom, placed.frame.bottom);
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(box, placed.boxes[j])) << i << " covers " << j;
    for (const LabelWish& wish : wishes) EXPECT_FALSE(overlap(box, around(wish.anchor, wish.clear))) << i;
    for (const Box& mark : marks) EXPECT_FALSE(overlap(box, mark)) << i;
  }
}

TEST(PlaceLabels, OneStandsRightOfItsPlaceWithoutALine) {
  const std::vector<LabelWish> wishes = {{{400.0, 400.0}, 8.0, 60.0, 23.0}};
  const LabelPlacement placed = place_labels(wishes, {}, {}, kFrame);
  expect_apart(wishes, {}, placed);
  EXPECT_GT(placed.boxes[0].left, 408.0);
  EXPECT_LT(placed.boxes[0].left, 420.0);
  EXPECT_FALSE(needs_leader(wishes[0], placed.boxes[0]));
  EXPECT_EQ(placed.frame.bottom, kFrame.bottom);
}

TEST(PlaceLabels, AtTheRightEdgeOneStandsElsewhere) {
  const std::vector<LabelWish> wishes = {{{1580.0, 400.0}, 8.0, 60.0, 23.0}};
  const LabelPlacement placed = place_labels(wishes, {}, {}, kFrame);
  expect_apart(wishes, {}, placed);
  EXPECT_LT(placed.boxes[0].right, 1580.0);
  EXPECT_EQ(placed.frame.right, kFrame.right);
}

TEST(PlaceLabels, TheSideWithFewerPointsIsTaken) {
  const std::vector<LabelWish> wishes = {{{400.0, 400.0}, 8.0, 60.0, 23.0}};
  std::vector<Point> points;
  for (double x = 400.0; x < 800.0; x += 10.0) points.push_back({x, 400.0});
  const LabelPlacement placed = place_labels(wishes, {}, points, kFrame);
  expect_apart(wishes, {}, placed);
  for (const Point& point : points) EXPECT_FALSE(overlap(placed.boxes[0], around(point, 1.0)));
}

TEST(PlaceLabels, WhatIsMovedAwayHasALine) {
  const std::vector<LabelWish> wishes(12, {{400.0, 400.0}, 8.0, 120.0, 23.0});
  const LabelPlacement placed = place_labels(wishes, {}, {}, kFrame);
  expect_apart(wishes, {}, placed);
  EXPECT_FALSE(needs_leader(wishes.front(), placed.boxes.front()));
  EXPECT_TRUE(needs_leader(wishes.back(), placed.boxes.back()));
  const Point end = nearest_in(placed.boxes.back(), wishes.back().anchor);
  EXPECT_TRUE(overlap(around(end, 0.5), placed.boxes.back()));
}

TEST(PlaceLabels, FiftyAtNearlyOnePointAreApart) {
  Random random(5);
  std::vector<LabelWish> wishes;
  for (int i = 0; i < 50; ++i) {
    wishes.push_back({{700.0 + random.uniform(), 300.0 + random.uniform()}, 8.0, 100.0 + 10.0 * i, 23.0});
  }
  const std::vector<Box> marks = {around({720.0, 310.0}, 16.0), around({690.0, 280.0}, 16.0)};
  expect_apart(wishes, marks, place_labels(wishes, marks, {}, kFrame));
}

TEST(PlaceLabels, WithoutRoomTheFrameGrowsDownwards) {
  const Box small{0.0, 0.0, 300.0, 60.0};
  const std::vector<LabelWish> wishes(40, {{150.0, 30.0}, 8.0, 90.0, 23.0});
  const LabelPlacement placed = place_labels(wishes, {}, {}, small);
  expect_apart(wishes, {}, placed);
  EXPECT_GT(placed.frame.bottom, small.bottom);
  EXPECT_EQ(placed.frame.right, small.right);
}

TEST(PlaceLabels, AWiderOneThanTheFrameMakesItWider) {
  const Box small{0.0, 0.0, 300.0, 60.0};
  const std::vector<LabelWish> wishes = {{{150.0, 30.0}, 8.0, 900.0, 23.0}, {{150.0, 30.0}, 8.0, 900.0, 23.0}};
  const LabelPlacement placed = place_labels(wishes, {}, {}, small);
  expect_apart(wishes, {}, placed);
  EXPECT_GE(placed.frame.right, 900.0);
}

TEST(PlaceLabels, NamesOfSixtyFourBytesInOtherScriptsAreApart) {
  const WidthOf width = text_widths();
  std::vector<LabelWish> wishes;
  for (const char* const letter : {"W", "ü", "Ж", "ש", "倉", "ก", "𝒲"}) {
    std::string name;
    while (name.size() + std::string(letter).size() <= 64) name += letter;
    const double wide = width(name, 15.0);
    EXPECT_GT(wide, 60.0) << letter;
    for (int i = 0; i < 8; ++i) wishes.push_back({{800.0, 400.0 + i}, 8.0, wide, 23.0});
  }
  expect_apart(wishes, {}, place_labels(wishes, {}, {}, kFrame));
}

}  // namespace
}  // namespace weft::cli::test
