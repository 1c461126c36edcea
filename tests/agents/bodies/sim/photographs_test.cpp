#include "agents/bodies/sim/floor/photographs.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <opencv2/imgproc.hpp>

#include "tests/support/raw_png.hpp"
#include "tiles.hpp"

namespace weft::agents::sim {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class Photographs : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / (std::string("weft-photographs-") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void add_picture(const std::string& name, int side, std::uint64_t seed) const {
    cv::Mat picture(side, side, CV_8U);
    cv::theRNG().state = seed;
    cv::randu(picture, 0, 255);
    cv::GaussianBlur(picture, picture, {5, 5}, 1.5);
    weft::test::write_png(folder_ / name, {images::Shades::grey, side, side, {picture.datastart, picture.dataend}});
  }
  void add_text(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  Result<std::shared_ptr<const FloorSource>> make(const std::string& photograph = "") {
    FloorSetup setup;
    setup.photograph = photograph;
    return make_photographed_floor(setup, folder_.string(), [this](const std::string& text) { warnings_ += text; });
  }

  fs::path folder_;
  std::string warnings_;
};

TEST_F(Photographs, AreQuiltedWithoutRepetition) {
  add_picture("stone.png", 1500, 3);
  add_text("floors.toml", "[stone]\nfile = \"stone.png\"\nmm_per_pixel = 0.9\n");
  auto floor = make();
  ASSERT_TRUE(floor) << floor.error().message;
  EXPECT_EQ(warnings_, "");
  Tile here = tile_of(**floor, {0, 0});
  for (const TileKey other : {TileKey{1, 0}, {0, 1}, {5, 7}}) {
    Tile there = tile_of(**floor, other);
    EXPECT_LT(best_match(here, there), 0.65);
  }
}

TEST_F(Photographs, UnderRedLightRedShinesAndGreyStays) {
  cv::Mat picture(1200, 1200, CV_8UC3, cv::Scalar(100, 100, 100));
  // Stripes of a red as bright as the grey under white light: 0.299 * 234 + 0.587 * 51 = 100.
  for (int y = 0; y < 1200; y += 40) picture.rowRange(y, y + 20).setTo(cv::Scalar(1, 51, 234));
  weft::test::write_png(folder_ / "stripes.png",
                        {images::Shades::colours, 1200, 1200, {picture.datastart, picture.dataend}});
  add_text("stripes.png.toml", "mm_per_pixel = 1.0\n");
  const auto contrast_under = [&](double warmth) {
    auto floor = make_photographed_floor({}, folder_.string(), {}, warmth);
    EXPECT_TRUE(floor) << floor.error().message;
    Tile tile = tile_of(**floor, {0, 0});
    cv::Scalar mean;
    cv::Scalar sigma;
    cv::meanStdDev(picture_of(tile), mean, sigma);
    return sigma[0];
  };
  EXPECT_LT(contrast_under(0.0), 2.0);
  EXPECT_GT(contrast_under(0.6), 8.0);
  EXPECT_GT(contrast_under(-0.6), 8.0);
}

TEST_F(Photographs, WithoutAScaleOneIsAssumedAndSaid) {
  add_picture("stone.png", 600, 3);
  ASSERT_TRUE(make());
  EXPECT_THAT(warnings_, HasSubstr("stone.png"));
  EXPECT_THAT(warnings_, HasSubstr("0.7 assumed"));
}

TEST_F(Photographs, ASidecarBesideOnePictureIsRead) {
  add_picture("stone.png", 600, 3);
  add_text("stone.png.toml", "mm_per_pixel = 0.5\n");
  ASSERT_TRUE(make());
  EXPECT_EQ(warnings_, "");
}

TEST_F(Photographs, AScaleOutOfBoundsIsRefused) {
  add_picture("stone.png", 600, 3);
  add_text("stone.png.toml", "mm_per_pixel = 50\n");
  const auto floor = make();
  ASSERT_FALSE(floor);
  EXPECT_THAT(floor.error().message, HasSubstr("stone.png.toml:1"));
  EXPECT_THAT(floor.error().message, HasSubstr("mm_per_pixel"));
}

TEST_F(Photographs, ADamagedPictureIsNamed) {
  add_text("stone.png", "not a picture");
  const auto floor = make();
  ASSERT_FALSE(floor);
  EXPECT_EQ(floor.error().code, ErrorCode::corrupt);
  EXPECT_THAT(floor.error().message, HasSubstr("stone.png"));
}

TEST_F(Photographs, AListedPictureThatIsMissingIsNamed) {
  add_picture("stone.png", 600, 3);
  add_text("floors.toml",
           "[stone]\nfile = \"stone.png\"\nmm_per_pixel = 0.9\n[moss]\nfile = \"moss.png\"\nmm_per_pixel = 0.9\n");
  const auto floor = make();
  ASSERT_FALSE(floor);
  EXPECT_THAT(floor.error().message, HasSubstr("moss"));
}

TEST_F(Photographs, AFolderWithoutPicturesIsRefused) {
  EXPECT_FALSE(make());
  folder_ /= "nowhere";
  const auto floor = make();
  ASSERT_FALSE(floor);
  EXPECT_EQ(floor.error().code, ErrorCode::not_found);
}

TEST_F(Photographs, OneOfSeveralCanBeChosen) {
  add_picture("stone.png", 600, 3);
  add_picture("moss.png", 600, 4);
  EXPECT_TRUE(make("moss"));
  const auto floor = make("sand");
  ASSERT_FALSE(floor);
  EXPECT_THAT(floor.error().message, HasSubstr("sand"));
}

}  // namespace
}  // namespace weft::agents::sim
