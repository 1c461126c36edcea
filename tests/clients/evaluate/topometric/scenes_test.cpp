#include "clients/evaluate/topometric/scenes.hpp"

#include <gtest/gtest.h>

#include "clients/evaluate/floor/scenario.hpp"
#include "clients/evaluate/topometric/trials.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate::topometric {
namespace {

TEST(TopometricScenes, AreThoseOfTheRepository) {
  const Result<Scenes> scenes = read_scenes(WEFT_SITES "/topometric", {480, false});
  ASSERT_TRUE(scenes) << scenes.error().message;
  EXPECT_NEAR(floor::length_of(scenes->level11.line), 53.5, 0.1);
  EXPECT_EQ(scenes->level11.site.stereo_camera.width, 480);
  EXPECT_EQ(scenes->level11.site.stereo_camera.height, 360);
  EXPECT_NEAR(scenes->level11.site.stereo_camera.focal_px, 312.0, 1e-9);
  EXPECT_EQ(scenes->level11.site.stations.size(), 3U);
  for (const Scene* const scene : {&scenes->level11, &scenes->hall, &scenes->aisles})
    EXPECT_FALSE(scene->site.base.has_encoders) << scene->site.name << ": nobody may read wheels";
  EXPECT_EQ(scenes->sha256, read_scenes(WEFT_SITES "/topometric", {})->sha256);
}

TEST(TopometricScenes, AFolderWithoutThemIsNamed) {
  const storage::TemporaryDirectory folder;
  const Result<Scenes> scenes = read_scenes(folder.path(), {});
  ASSERT_FALSE(scenes);
  EXPECT_NE(scenes.error().message.find("level11.toml"), std::string::npos) << scenes.error().message;
}

TEST(Blackouts, ComeOneAfterTheOtherByTheSeed) {
  const auto all = blackouts(6, 10.0, 400.0, 3);
  ASSERT_EQ(all.size(), 6U);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_GE(all[i].from_s, i == 0 ? 10.0 : all[i - 1].to_s);
    EXPECT_LE(all[i].to_s, 400.0);
    EXPECT_GE(all[i].to_s - all[i].from_s, 1.0);
    EXPECT_LE(all[i].to_s - all[i].from_s, 2.0);
  }
  EXPECT_NE(blackouts(6, 10.0, 400.0, 4)[0].from_s, all[0].from_s);
  EXPECT_EQ(blackouts(6, 10.0, 400.0, 3)[0].from_s, all[0].from_s);
}

TEST(TopometricTrials, LongOnesTakeTheFirstSeeds) {
  EXPECT_EQ(seeds_of(trial::kMap, {1, 5}).last, 5U);
  EXPECT_EQ(seeds_of(trial::kDeliveries, {1, 5}).last, 3U);
  EXPECT_EQ(seeds_of(trial::kBlocked, {1001, 1005}).last, 1002U);
  EXPECT_EQ(seeds_of(trial::kDeliveries, {2, 2}).last, 2U);
}

}  // namespace
}  // namespace weft::evaluate::topometric
