#include "agents/bodies/sim/hall/hall_photographs.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tests/agents/bodies/sim/sites.hpp"
#include "tests/storage/temporary_directory.hpp"
#include "tests/support/raw_png.hpp"

namespace weft::agents::sim {
namespace {

using testing::HasSubstr;

/// Writes a photograph of stripes of one height: nobody draws loads like that.
void photograph(const std::filesystem::path& file, int stripe_px) {
  std::filesystem::create_directories(file.parent_path());
  images::Picture picture = weft::test::plain_picture(400, 300, 40);
  for (int y = 0; y < picture.height; ++y) {
    if ((y / stripe_px) % 2 != 0)
      std::fill_n(picture.samples.begin() + y * picture.width, picture.width, std::uint8_t{240});
  }
  weft::test::write_png(file, picture);
}

TEST(HallPhotographs, AreOfTheStuffsThatHaveAFolder) {
  const storage::TemporaryDirectory folder;
  photograph(folder.path() / "load" / "a.png", 30);
  photograph(folder.path() / "load" / "b.png", 50);
  photograph(folder.path() / "wall" / "bricks.png", 10);
  const auto read = read_hall_photographs(folder.path().string());
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->at(Stuff::load).size(), 2U);
  EXPECT_EQ(read->at(Stuff::wall).size(), 1U);
  EXPECT_EQ(read->at(Stuff::wall).front().side(), 512);
  EXPECT_FALSE(read->contains(Stuff::sign));
}

TEST(HallPhotographs, HaveOneMean) {
  const storage::TemporaryDirectory folder;
  photograph(folder.path() / "sign" / "a.png", 30);
  const auto read = read_hall_photographs(folder.path().string());
  ASSERT_TRUE(read);
  const TexelLevels levels = read->at(Stuff::sign).front().levels();
  EXPECT_NEAR(levels.texels[levels.from[levels.top]], 128, 3) << "the last halving";
}

TEST(HallPhotographs, ChangeWhatARobotSees) {
  const storage::TemporaryDirectory folder;
  photograph(folder.path() / "load" / "a.png", 30);
  photograph(folder.path() / "wall" / "a.png", 30);
  SimBodyConfig config = config_of(empty_site());
  config.site.robots.front().looks = {Gaze::ahead};
  config.site.disturbances.dropped_frames = 0.0;
  const auto drawn = body_of(config);
  config.hall_dir = folder.path().string();
  const auto photographed = body_of(config);
  const Sample before = *drawn->step({});
  const Sample after = *photographed->step({});
  EXPECT_NE(*std::get<Image>(before.views.front().data).pixels, *std::get<Image>(after.views.front().data).pixels);
}

TEST(HallPhotographs, WhatIsWrongIsNamed) {
  const storage::TemporaryDirectory folder;
  EXPECT_EQ(read_hall_photographs((folder.path() / "none").string()).error().code, ErrorCode::not_found);
  EXPECT_EQ(read_hall_photographs(folder.path().string()).error().code, ErrorCode::not_found);
  photograph(folder.path() / "sky" / "a.png", 30);
  const auto unknown = read_hall_photographs(folder.path().string());
  EXPECT_EQ(unknown.error().code, ErrorCode::invalid);
  EXPECT_THAT(unknown.error().message, HasSubstr("sky"));
  EXPECT_THAT(unknown.error().message, HasSubstr("load"));
  std::filesystem::rename(folder.path() / "sky", folder.path() / "load");
  std::ofstream(folder.path() / "load" / "b.png") << "no picture";
  const auto damaged = read_hall_photographs(folder.path().string());
  EXPECT_EQ(damaged.error().code, ErrorCode::corrupt);
  EXPECT_THAT(damaged.error().message, HasSubstr("b.png"));
}

}  // namespace
}  // namespace weft::agents::sim
