#include "clients/evaluate/floor/rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "clients/evaluate/floor/bounds.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate::floor {
namespace {

class FloorRows : public testing::Test {
 protected:
  static std::string text_of(const std::filesystem::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  storage::TemporaryDirectory folder;
  Study study{"1", "site", "line", "", 26.0};
};

TEST_F(FloorRows, ComeBackAsTheyWere) {
  EXPECT_TRUE(read_rows(folder.path(), study)->empty());
  Rows rows;
  Score& score = rows[{"concrete", "same", 4}];
  score.goal_mm = 4.25;
  score.blind_distances_m = {0.1, 0.25};
  score.refusals = {{"few_matches", 3}, {"ambiguous", 1}};
  ASSERT_TRUE(write_rows(folder.path(), study, rows, judge(rows, {1, 9})).has_value());
  const auto back = read_rows(folder.path(), study);
  ASSERT_TRUE(back.has_value()) << back.error().message;
  const Score& same = back->at({"concrete", "same", 4});
  EXPECT_EQ(same.goal_mm, 4.25);
  EXPECT_TRUE(std::isnan(same.speed_percent));
  EXPECT_EQ(same.blind_distances_m, score.blind_distances_m);
  EXPECT_EQ(same.refusals, score.refusals);
}

TEST_F(FloorRows, EveryBoundStandsThereByName) {
  Rows rows;
  rows[{"concrete", kMapping, 1}].speed_percent = 0.4;
  ASSERT_TRUE(write_rows(folder.path(), study, rows, judge(rows, {1, 1})).has_value());
  const auto document = nlohmann::json::parse(text_of(folder.path() / "floor.json"));
  ASSERT_EQ(document["bounds"].size(), bounds().size());
  const auto& first = document["bounds"][0];
  EXPECT_EQ(first["name"], "speed error while mapping");
  EXPECT_EQ(first["bound_median"], 0.5);
  EXPECT_EQ(first["median"], 0.4);
  EXPECT_EQ(first["met"], true);
  EXPECT_EQ(first["command"], "weft-evaluate floor");
  EXPECT_EQ(document["bounds"][1]["met"], false);
}

TEST_F(FloorRows, OfAnotherStudyAreRefused) {
  ASSERT_TRUE(write_rows(folder.path(), study, {}, {}).has_value());
  Study other = study;
  other.metres = 12.0;
  const auto refused = read_rows(folder.path(), other);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::conflict);
  EXPECT_NE(refused.error().message.find("metres"), std::string::npos) << refused.error().message;
  std::ofstream(folder.path() / "floor.json") << "{}";
  EXPECT_EQ(read_rows(folder.path(), study).error().code, ErrorCode::corrupt);
}

TEST_F(FloorRows, CsvHasARowAPart) {
  Rows rows;
  rows[{"concrete", kMapping, 1}].speed_percent = 0.4;
  rows[{"concrete", "same", 1}].goal_mm = 7.0;
  rows[{"concrete", "same", 1}].refusals = {{"few_matches", 3}, {"ambiguous", 1}};
  ASSERT_TRUE(write_csv(folder.path(), rows).has_value());
  const std::string text = text_of(folder.path() / "floor.csv");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
  EXPECT_NE(text.find("\"concrete\",\"mapping\",1,,0.4"), std::string::npos) << text;
  EXPECT_NE(text.find(",\"ambiguous 1; few_matches 3\"\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace weft::evaluate::floor
