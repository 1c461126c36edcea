#include "agents/perception/clouds/cell_table.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "core/random.hpp"

namespace weft::agents {
namespace {

TEST(CellTable, GivesEachCellOneNumberInOrder) {
  CellTable table;
  Random random(1);
  std::map<CellCoordinates, std::uint32_t> numbers;
  for (int at = 0; at < 20'000; ++at) {
    CellCoordinates cell{};
    for (auto& coordinate : cell) coordinate = static_cast<std::int32_t>(random.below(30)) - 15;
    const auto expected = numbers.emplace(cell, static_cast<std::uint32_t>(numbers.size())).first->second;
    ASSERT_EQ(table.number_of(cell), expected);
  }
  EXPECT_EQ(table.size(), numbers.size());
  for (const auto& [cell, number] : numbers) {
    ASSERT_EQ(table.find(cell), number);
    ASSERT_EQ(table.cells()[number], cell);
  }
  EXPECT_EQ(table.find({15, 15, 15}), CellTable::kNone);
}

TEST(CellTable, CellsReachTheirLowerEdgeOnBothSidesOfTheOrigin) {
  EXPECT_EQ(cell_of({0.0, -0.01, 0.39}, 5.0), (CellCoordinates{0, -1, 1}));
  EXPECT_EQ(cell_of({-0.2, -0.21, 0.2}, 5.0), (CellCoordinates{-1, -2, 1}));
}

TEST(CellTable, WhatHasNoCellIsToldBefore) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(is_on_grid({1.0, -200'000.0, 3.0}, 5.0));
  EXPECT_FALSE(is_on_grid({1.0, -210'000.0, 3.0}, 5.0));
  EXPECT_FALSE(is_on_grid({1.0, none, 3.0}, 5.0));
  EXPECT_FALSE(is_on_grid({1.0, 2.0, std::numeric_limits<double>::infinity()}, 5.0));
}

}  // namespace
}  // namespace weft::agents
