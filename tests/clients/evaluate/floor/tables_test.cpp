#include "clients/evaluate/floor/tables.hpp"

#include <gtest/gtest.h>

#include <string>

namespace weft::evaluate::floor {
namespace {

/// Returns the line of `text` that begins with `beginning`.
std::string line_of(const std::string& text, const std::string& beginning) {
  const auto at = text.find("\n" + beginning);
  EXPECT_NE(at, std::string::npos) << beginning << " is not in\n" << text;
  return at == std::string::npos ? "" : text.substr(at + 1, text.find('\n', at + 1) - at - 1);
}

TEST(FloorTables, TablesNameEveryBoundAndFloor) {
  Rows rows;
  rows[{"concrete", "same", 1}].goal_mm = 5.0;
  const std::string text = tables_of(judge(rows, {1, 1}), rows, {1, 1});
  for (const Bound& bound : bounds()) EXPECT_NE(text.find(bound.name), std::string::npos) << bound.name;
  EXPECT_NE(text.find("| concrete |"), std::string::npos) << text;
  EXPECT_NE(text.find("not measured (weft-evaluate floor)"), std::string::npos);
}

TEST(FloorTables, RefusalsOfAllSeedsAreCountedByReason) {
  Rows rows;
  rows[{"concrete", "same", 1}].refusals = {{"few_matches", 2}, {"ambiguous", 4}};
  rows[{"concrete", "same", 2}].refusals = {{"few_matches", 5}};
  const std::string tables = tables_of(judge(rows, {1, 2}), rows, {1, 2});
  const auto few = tables.find("| few_matches |");
  ASSERT_NE(few, std::string::npos) << tables;
  EXPECT_EQ(tables.substr(few, tables.find('\n', few) - few).find_first_of("0123456789"),
            tables.substr(few, tables.find('\n', few) - few).find('7'))
      << tables;
  EXPECT_LT(few, tables.find("| ambiguous |")) << "the most frequent first";
}

TEST(FloorTables, HowOftenRegionsHoldStandsThereByFloor) {
  Rows rows;
  rows[{"wood", kMapping, 1}].held_10m_percent = 80.0;
  rows[{"wood", kMapping, 2}].held_10m_percent = 97.0;
  rows[{"wood", "same", 1}].held_1m_percent = 91.5;
  rows[{"epoxy", kMapping, 1}].held_10m_percent = 99.0;
  const std::string tables = tables_of(judge(rows, {1, 2}), rows, {1, 2});
  const std::string shares = tables.substr(tables.find("| 95 % regions hold"));
  const std::string wood = line_of(shares, "| wood");
  EXPECT_NE(wood.find("held out"), std::string::npos) << wood;
  EXPECT_NE(wood.find("88.5"), std::string::npos) << wood;
  EXPECT_NE(wood.find("91.5"), std::string::npos) << wood;
  EXPECT_NE(line_of(shares, "| epoxy").find("set by it"), std::string::npos);
}

}  // namespace
}  // namespace weft::evaluate::floor
