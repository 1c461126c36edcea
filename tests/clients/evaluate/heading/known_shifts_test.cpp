#include "clients/evaluate/heading/known_shifts.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "clients/evaluate/heading/heading_study.hpp"

namespace weft::evaluate::heading {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class KnownShiftsTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("known_shifts_") + test->name());
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  void write(const fs::path& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
  }
  fs::path folder_;
};

TEST_F(KnownShiftsTest, EveryTwoSeasonsOfALocationAreAPair) {
  write("ground_truth/location_1.txt", "0 -10 9\n10 0 19\n-9 -19 0\n");
  write("ground_truth/location_2.txt", "0 5\n-5 0\n");
  for (const char* const name : {"0101.png", "0201.png", "0301.png", "0102.pgm", "0202.jpg"})
    write(fs::path("images") / name, "");
  const auto known = read_known_shifts(folder_);
  ASSERT_TRUE(known) << known.error().message;
  ASSERT_EQ(known->pairs.size(), 4U);
  EXPECT_EQ(known->pairs[2].group, "location 1");
  EXPECT_EQ(known->images[known->pairs[2].a].filename(), "0201.png");
  EXPECT_EQ(known->images[known->pairs[2].b].filename(), "0301.png");
  EXPECT_EQ(known->pairs[2].shift_px, 19.0);
  EXPECT_EQ(known->pairs[3].group, "location 2");
  EXPECT_EQ(known->images[known->pairs[3].b].filename(), "0202.jpg");
}

TEST_F(KnownShiftsTest, APathInTwoSeasons) {
  write("displacements.txt", "0 -109 -27\n3 -265 8\n");
  for (const char* const name :
       {"season_00/000000000.png", "season_01/000000000.png", "season_00/000000003.jpg", "season_01/000000003.jpg"})
    write(name, "");
  const auto known = read_known_shifts(folder_);
  ASSERT_TRUE(known) << known.error().message;
  ASSERT_EQ(known->pairs.size(), 2U);
  EXPECT_EQ(known->pairs[1].shift_px, -265.0);
  EXPECT_EQ(known->images[known->pairs[1].b], folder_ / "season_01" / "000000003.jpg");
}

TEST_F(KnownShiftsTest, RowsMayHaveNoNumber) {
  write("displacements.txt", "-109 -27\n");
  write("season_00/000000000.png", "");
  write("season_01/000000000.png", "");
  const auto known = read_known_shifts(folder_);
  ASSERT_TRUE(known) << known.error().message;
  EXPECT_EQ(known->pairs.front().shift_px, -109.0);
}

TEST_F(KnownShiftsTest, WhatIsWrongIsNamed) {
  const auto message = [&] {
    const auto known = read_known_shifts(folder_);
    return known ? std::string("nothing is wrong") : known.error().message;
  };
  EXPECT_THAT(message(), HasSubstr("neither ground_truth/location_1.txt"));
  write("displacements.txt", "0 -109 -27\n1 x 8\n");
  EXPECT_THAT(message(), HasSubstr("displacements.txt:2: 'x'"));
  write("displacements.txt", "0 nan 8\n");
  EXPECT_THAT(message(), HasSubstr("displacements.txt:1: 'nan'"));
  write("displacements.txt", "0\n");
  EXPECT_THAT(message(), HasSubstr("row 1 has 1 numbers"));
  write("displacements.txt", "4 1 2\n");
  EXPECT_THAT(message(), HasSubstr("season_00/000000004.*: no such image"));
  fs::remove(folder_ / "displacements.txt");
  write("ground_truth/location_1.txt", "0 1\n2\n");
  write("images/0101.png", "");
  EXPECT_THAT(message(), HasSubstr("row 2 has 1 numbers, there are 2 rows"));
}

TEST_F(KnownShiftsTest, ADamagedImageIsNamedByTheStudy) {
  write("displacements.txt", "0 -109 -27\n");
  write("season_00/000000000.png", "no image");
  write("season_01/000000000.png", "no image");
  std::ostringstream out;
  std::ostringstream progress;
  const Surroundings around{out, progress, [] { return 0.0; }, [] { return false; }};
  const Result<Ended> ended = study_heading({folder_, agents::Description::brief, false}, around);
  ASSERT_FALSE(ended);
  EXPECT_EQ(ended.error().code, ErrorCode::corrupt);
  EXPECT_THAT(ended.error().message, HasSubstr("season_00/000000000.png"));
  EXPECT_EQ(out.str(), "");
}

}  // namespace
}  // namespace weft::evaluate::heading
