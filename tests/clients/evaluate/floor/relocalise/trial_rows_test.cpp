#include "clients/evaluate/floor/relocalise/trial_rows.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "clients/evaluate/floor/relocalise/trial_report.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate::floor {
namespace {

/// Makes as many as `count`, of which the first `lost` are not found.
std::vector<Trial> trials(std::size_t count, std::size_t lost, Along along = Along::forwards) {
  std::vector<Trial> all(count);
  for (std::size_t i = 0; i < count; ++i) {
    all[i].along = along;
    all[i].site_from_robot = {static_cast<double>(i), 2.0, 0.25};
    if (i < lost) {
      all[i].refused = "no_consensus";
    } else {
      all[i].found_m = 0.5;
    }
  }
  return all;
}

class TrialsFolder : public testing::Test {
 protected:
  storage::TemporaryDirectory folder;
  Study study{"1", "site", "", "", 1000.0};
  TrialRows rows;
};

TEST_F(TrialsFolder, RowsComeBackAsTheyWere) {
  EXPECT_TRUE(read_trials(folder.path(), study)->empty());
  rows[{"wood", "halved", 4}] = trials(3, 1, Along::backwards);
  rows[{"wood", "halved", 4}][2].is_wrong = true;
  ASSERT_TRUE(write_trials(folder.path(), study, rows).has_value());
  const auto back = read_trials(folder.path(), study);
  ASSERT_TRUE(back.has_value()) << back.error().message;
  const std::vector<Trial>& same = back->at({"wood", "halved", 4});
  ASSERT_EQ(same.size(), 3U);
  EXPECT_FALSE(same[0].found_m);
  EXPECT_EQ(same[0].refused, "no_consensus");
  EXPECT_EQ(same[1].found_m, 0.5);
  EXPECT_EQ(same[1].along, Along::backwards);
  EXPECT_EQ(same[1].site_from_robot, (Pose2{1.0, 2.0, 0.25}));
  EXPECT_TRUE(same[2].is_wrong);
  study.metres = 2000.0;
  EXPECT_EQ(read_trials(folder.path(), study).error().code, ErrorCode::conflict);
  std::ofstream(folder.path() / "relocalise.json") << "[]";
  EXPECT_EQ(read_trials(folder.path(), study).error().code, ErrorCode::corrupt);
}

TEST_F(TrialsFolder, TheWorstSeedAndAWrongPlaceAreHeldAgainstIt) {
  const auto verdict = [&](const std::string& kind) {
    const std::string tables = tables_of(rows);
    const std::size_t at = tables.find("| " + kind);
    return tables.substr(at, tables.find('\n', at) - at);
  };
  rows[{"asphalt", "same", 1}] = trials(100, 0);
  rows[{"asphalt", "same", 2}] = trials(100, 3);
  EXPECT_NE(verdict("asphalt").find("NOT MET"), std::string::npos) << "median 98.5: " << verdict("asphalt");
  rows[{"asphalt", "same", 3}] = trials(100, 0);
  EXPECT_EQ(verdict("asphalt").find("NOT MET"), std::string::npos) << verdict("asphalt");
  rows[{"asphalt", "same", 3}] = trials(100, 4);
  EXPECT_NE(verdict("asphalt").find("NOT MET"), std::string::npos) << verdict("asphalt");
  rows[{"tiles", "same", 1}] = trials(10, 10);
  EXPECT_EQ(verdict("tiles").find("NOT MET"), std::string::npos) << verdict("tiles");
  rows[{"tiles", "same", 1}] = trials(10, 0);
  rows[{"tiles", "same", 1}][5].is_wrong = true;
  EXPECT_NE(verdict("tiles").find("NOT MET"), std::string::npos) << verdict("tiles");
}

TEST_F(TrialsFolder, ALineATrial) {
  rows[{"wood", "same", 1}] = trials(2, 1);
  ASSERT_TRUE(write_trials_csv(folder.path(), rows).has_value());
  std::ifstream in(folder.path() / "relocalise.csv");
  const std::string csv{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(csv.find("\"wood\",\"same\",1,forwards,0,2,0.25,,0,no_consensus\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\"wood\",\"same\",1,forwards,1,2,0.25,0.5,0,\n"), std::string::npos) << csv;
}

}  // namespace
}  // namespace weft::evaluate::floor
