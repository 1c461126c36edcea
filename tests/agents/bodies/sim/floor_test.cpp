#include <gmock/gmock.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "agents/bodies/sim/floor/floor_window.hpp"
#include "agents/bodies/sim/floor/procedural.hpp"
#include "agents/bodies/sim/floor/tile_print.hpp"
#include "tiles.hpp"

namespace weft::agents::sim {
namespace {

using testing::HasSubstr;

FloorSetup setup_of(const std::string& material) {
  FloorSetup setup;
  setup.material = material;
  return setup;
}

std::shared_ptr<const FloorSource> floor_of(const FloorSetup& setup) {
  auto floor = make_procedural_floor(setup);
  EXPECT_TRUE(floor) << floor.error().message;
  return *floor;
}

class EveryMaterial : public testing::TestWithParam<std::string> {};

class EveryMaterialWithoutPattern : public EveryMaterial {};

TEST_P(EveryMaterialWithoutPattern, NeverRepeats) {
  const auto floor = floor_of(setup_of(GetParam()));
  Tile here = tile_of(*floor, {3, 2});
  EXPECT_GT(best_match(here, here), 0.999);
  for (const TileKey other : {TileKey{4, 2}, {3, 3}, {-3, -2}, {2, 3}, {19, 18}, {-4, 2}}) {
    Tile there = tile_of(*floor, other);
    EXPECT_LT(best_match(here, there), 0.65) << other.x << ", " << other.y;
  }
}

TEST_P(EveryMaterial, TilesFitTogether) {
  const auto floor = floor_of(setup_of(GetParam()));
  Tile left = tile_of(*floor, {0, 0});
  Tile right = tile_of(*floor, {1, 0});
  Tile above = tile_of(*floor, {0, 1});
  // Across the seam neighbours differ no more than within a tile.
  double inside = 0.0;
  double inside_up = 0.0;
  double across = 0.0;
  double up = 0.0;
  for (int j = 0; j < kTileTexels; ++j) {
    const auto row = static_cast<std::size_t>(j) * kTileTexels;
    const auto last = static_cast<std::size_t>(kTileTexels - 1) * kTileTexels;
    inside += std::abs(left[row + 500] - left[row + 501]);
    for (const int i : {100, 300, 500, 700, 900}) {
      const auto at = static_cast<std::size_t>(i) * kTileTexels + static_cast<std::size_t>(j);
      inside_up += std::abs(left[at] - left[at + kTileTexels]) / 5.0;
    }
    across += std::abs(left[row + kTileTexels - 1] - right[row]);
    up += std::abs(left[last + static_cast<std::size_t>(j)] - above[static_cast<std::size_t>(j)]);
  }
  EXPECT_LT(across, 1.25 * inside);
  EXPECT_LT(up, 1.25 * inside_up);
}

TEST_P(EveryMaterial, HasContrastAtMillimetres) {
  const auto floor = floor_of(setup_of(GetParam()));
  Tile tile = tile_of(*floor, {5, 5});
  cv::Mat fine;
  cv::Mat coarse;
  const cv::Mat picture = picture_of(tile);
  // The band between 1 and 5 mm.
  cv::boxFilter(picture, fine, CV_32F, {2, 2});
  cv::boxFilter(picture, coarse, CV_32F, {15, 15});
  cv::Scalar mean;
  cv::Scalar sigma;
  cv::meanStdDev(fine - coarse, mean, sigma);
  RecordProperty("sigma", std::to_string(sigma[0]));
  EXPECT_GT(sigma[0], GetParam() == "epoxy" || GetParam() == "polished-concrete" ? 2.0 : 4.0);
  EXPECT_LT(sigma[0], 25.0);
}

std::string test_name(const testing::TestParamInfo<std::string>& material) {
  std::string name = material.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(Floor, EveryMaterial,
                         testing::Values("concrete", "polished-concrete", "worn-concrete", "tiles", "wood", "asphalt",
                                         "terrazzo", "epoxy"),
                         test_name);
INSTANTIATE_TEST_SUITE_P(Floor, EveryMaterialWithoutPattern,
                         testing::Values("concrete", "polished-concrete", "worn-concrete", "wood", "asphalt",
                                         "terrazzo", "epoxy"),
                         test_name);

TEST(Floor, TilesRepeatFromTileToTileButForWhatLiesOnThem) {
  Tile tile = tile_of(*floor_of(setup_of("tiles")), {3, 2});
  const cv::Mat picture = picture_of(tile);
  const cv::Rect one(0, 0, 400, 400);
  const auto likeness = [&](int right) {
    cv::Mat score;
    cv::matchTemplate(picture(one), picture(one + cv::Point(right, 0)), score, cv::TM_CCOEFF_NORMED);
    return score.at<float>(0, 0);
  };
  EXPECT_GT(likeness(kPrintTexels), 0.8F);
  EXPECT_LT(likeness(kPrintTexels), 0.999F);
  EXPECT_LT(likeness(kPrintTexels / 3), 0.4F);
}

TEST(Floor, PlanksAreLongerThanWide) {
  Tile tile = tile_of(*floor_of(setup_of("wood")), {3, 2});
  cv::Mat along;
  cv::Mat across;
  cv::Sobel(picture_of(tile), along, CV_32F, 1, 0);
  cv::Sobel(picture_of(tile), across, CV_32F, 0, 1);
  EXPECT_GT(cv::norm(across), 1.7 * cv::norm(along));
}

TEST(Floor, ColouredLightChangesWhatDiffersInColour) {
  for (const std::string material : {"terrazzo", "wood", "tiles"}) {
    Tile white = tile_of(*floor_of(setup_of(material)), {1, 1});
    auto lit = make_procedural_floor(setup_of(material), 0.6);
    ASSERT_TRUE(lit);
    Tile red = tile_of(**lit, {1, 1});
    cv::Mat score;
    cv::matchTemplate(picture_of(white), picture_of(red), score, cv::TM_CCOEFF_NORMED);
    EXPECT_LT(score.at<float>(0, 0), 0.995F) << material;
    EXPECT_GT(score.at<float>(0, 0), 0.5F) << material;
  }
}

TEST(Floor, AnotherSeedIsAnotherFloor) {
  FloorSetup other = setup_of("concrete");
  other.seed = 2;
  Tile a = tile_of(*floor_of(setup_of("concrete")), {0, 0});
  Tile b = tile_of(*floor_of(other), {0, 0});
  EXPECT_LT(best_match(a, b), 0.65);
}

TEST(Floor, AnUnknownMaterialIsRefusedWithThoseThereAre) {
  const auto floor = make_procedural_floor(setup_of("marble"));
  ASSERT_FALSE(floor);
  EXPECT_THAT(floor.error().message, HasSubstr("concrete, asphalt"));
}

TEST(TileCache, KeepsItsBoundAndMakesTilesAgain) {
  constexpr std::size_t kLimit = 6'000'000;
  TileCache cache(floor_of(setup_of("concrete")), kLimit);
  const std::vector<std::uint8_t> first = cache.tile({0, 0}).levels[0];
  for (int i = 1; i < 12; ++i) {
    cache.tile({i, 0});
    EXPECT_LE(cache.bytes(), kLimit);
  }
  EXPECT_EQ(cache.made(), 12U);
  EXPECT_EQ(cache.tile({0, 0}).levels[0], first);
  EXPECT_EQ(cache.made(), 13U);
  cache.tile({0, 0});
  EXPECT_EQ(cache.made(), 13U);
}

TEST(TileCache, LevelsAreAreaMeans) {
  TileCache cache(floor_of(setup_of("concrete")), 6'000'000);
  const FloorTile& tile = cache.tile({1, 1});
  double sum = 0.0;
  for (int j = 0; j < 16; ++j) {
    for (int i = 0; i < 16; ++i) {
      sum += tile.levels[0][static_cast<std::size_t>((j + 160) * kTileTexels + i + 320)];
    }
  }
  EXPECT_NEAR(sum / 256, tile.levels[4][10 * 64 + 20], 1.0);
}

TEST(FloorWindow, KeepsItsBudgetWhateverIsLookedAt) {
  constexpr std::size_t kBudget = 128'000'000;
  FloorWindow window(floor_of(setup_of("epoxy")), {1.8, 4.0, 4.0, 0.0, 0.0}, kBudget);
  for (int i = -10; i < 40; ++i) {
    window.need(0, {i, i / 3});
    window.need(2, {i, i / 3});
    EXPECT_LE(window.bytes(), kBudget);
  }
}

TEST(FloorWindow, WrapsWithoutSeams) {
  const auto floor = floor_of(setup_of("concrete"));
  FloorWindow window(floor, {0.0, 4.0, 0.0, 0.0, 0.0}, 64'000'000);
  // Around a corner where both coordinates wrap (8 tiles a side), sampled as if from tile (7, 7).
  for (const TileKey key : {TileKey{7, 7}, {8, 7}, {7, 8}, {8, 8}}) {
    window.need(1, key);
  }
  const LevelPixels pixels = window.level(1, {7, 7});
  FloorFromRay plain;
  plain.m[0] = plain.m[4] = plain.m[8] = 1.0F;
  std::vector<float> x(64);
  std::vector<float> y(64);
  std::vector<float> out(64);
  TileCache cache(floor, 16'000'000);
  for (int row = -3; row < 3; ++row) {
    RowJob job;
    for (int i = 0; i < 64; ++i) {
      x[static_cast<std::size_t>(i)] = static_cast<float>(kTileM + (i - 32 + 0.5) * 2 * kTexelM);
      y[static_cast<std::size_t>(i)] = static_cast<float>(kTileM + (row + 0.5) * 2 * kTexelM);
    }
    job.ray_x = x.data();
    job.ray_y = y.data();
    job.count = 64;
    job.out = out.data();
    for (int k = 0; k < kSubsamples; ++k) {
      job.floor_from_ray[k] = &plain;
      job.level[k] = &pixels;
    }
    kernels().sample_row(job);
    for (int i = 0; i < 64; ++i) {
      const TileKey key{i < 32 ? 7 : 8, row < 0 ? 7 : 8};
      const int at = ((row + 512) % 512) * 512 + (i - 32 + 512) % 512;
      EXPECT_NEAR(out[static_cast<std::size_t>(i)], cache.tile(key).levels[1][static_cast<std::size_t>(at)], 0.2);
    }
  }
}

TEST(Kernels, BothBuildsGiveTheSameNumbers) {
  if (!__builtin_cpu_supports("avx2")) {
    GTEST_SKIP() << "this machine has no AVX2";
  }
  const Kernels a = plain::make_kernels();
  const Kernels b = avx2::make_kernels();
  FloorWindow window(floor_of(setup_of("concrete")), {0.0, 4.0, 0.0, 0.0, 0.0}, 64'000'000);
  window.need(1, {0, 0});
  const LevelPixels pixels = window.level(1, {0, 0});
  const FloorFromRay h{{0.5F, 0.1F, 0.2F, -0.1F, 0.5F, 0.2F, 0.01F, 0.3F, 1.0F}, 1e-3F};
  std::vector<float> x;
  std::vector<float> y;
  for (int i = 0; i < 256; ++i) {
    x.push_back(static_cast<float>(i) / 400.0F);
    y.push_back(static_cast<float>((i * 37) % 100) / 200.0F);
  }
  std::vector<float> from_a(256);
  std::vector<float> from_b(256);
  RowJob job;
  job.ray_x = x.data();
  job.ray_y = y.data();
  job.count = 256;
  for (int k = 0; k < kSubsamples; ++k) {
    job.floor_from_ray[k] = &h;
    job.level[k] = &pixels;
  }
  job.out = from_a.data();
  a.sample_row(job);
  job.out = from_b.data();
  b.sample_row(job);
  EXPECT_EQ(from_a, from_b);
  std::fill(from_a.begin(), from_a.end(), 0.0F);
  from_b = from_a;
  a.add_noise_row(-100, 7, 99, 256, 3.0F, from_a.data());
  b.add_noise_row(-100, 7, 99, 256, 3.0F, from_b.data());
  EXPECT_EQ(from_a, from_b);
}

TEST(Kernels, BothBuildsShadeAlikeAndCut) {
  if (!__builtin_cpu_supports("avx2")) {
    GTEST_SKIP() << "this machine has no AVX2";
  }
  constexpr int kCount = 32;
  const std::vector<float> gain_above = {1.0F, 0.7F, 1.3F, 0.9F, 1.1F};
  const std::vector<float> gain_below = {0.8F, 1.2F, 0.6F, 1.0F, 2.0F};
  const std::vector<float> add_above = {0.0F, 30.0F, 2.0F, 0.5F, 7.0F};
  const std::vector<float> add_below = {9.0F, 1.0F, 4.0F, 60.0F, 0.0F};
  std::vector<float> albedo;
  std::vector<float> noise;
  for (int i = 0; i < kCount; ++i) {
    albedo.push_back(static_cast<float>((i * 41) % 256));
    noise.push_back(static_cast<float>((i * 29) % 64 - 32));
  }
  ShadeJob job;
  job.albedo = albedo.data();
  job.gain_above = gain_above.data();
  job.gain_below = gain_below.data();
  job.add_above = add_above.data();
  job.add_below = add_below.data();
  job.below = 0.375F;
  job.noise = noise.data();
  job.noise_scale = 3.1F;
  job.count = kCount;
  std::vector<std::uint8_t> by_plain(kCount);
  std::vector<std::uint8_t> by_avx2(kCount);
  job.out = by_plain.data();
  plain::make_kernels().shade_row(job);
  job.out = by_avx2.data();
  avx2::make_kernels().shade_row(job);
  EXPECT_EQ(by_plain, by_avx2);
  EXPECT_EQ(*std::min_element(by_plain.begin(), by_plain.end()), 0);
  EXPECT_EQ(*std::max_element(by_plain.begin(), by_plain.end()), 255);
}

TEST(Kernels, BothBuildsPaintFacesAlike) {
  if (!__builtin_cpu_supports("avx2")) {
    GTEST_SKIP() << "this machine has no AVX2";
  }
  constexpr int kCount = 67;  // the last pixels stand alone
  std::vector<double> along;
  std::vector<double> up;
  std::vector<double> pixel;
  for (int i = 0; i < kCount; ++i) {
    along.push_back(-1.3 + 0.037 * i);
    up.push_back(0.01 + 0.026 * i);
    pixel.push_back(0.0011 * (i % 11 + 1));
  }
  for (const FaceLook look : {FaceLook::rack, FaceLook::plain, FaceLook::wall, FaceLook::pillar}) {
    const auto painted_by = [&](const Kernels& kernels) {
      FaceMemo memo;
      std::vector<float> out(kCount);
      kernels.face_row({look, 19, along.data(), up.data(), pixel.data(), kCount, &memo, out.data()});
      return out;
    };
    const std::vector<float> together = painted_by(avx2::make_kernels());
    EXPECT_EQ(painted_by(plain::make_kernels()), together);
    for (int i = 0; i < kCount; ++i) {
      FaceMemo memo;
      float alone = 0.0F;
      kernels().face_row({look, 19, &along[static_cast<std::size_t>(i)], &up[static_cast<std::size_t>(i)],
                          &pixel[static_cast<std::size_t>(i)], 1, &memo, &alone});
      EXPECT_EQ(alone, together[static_cast<std::size_t>(i)]) << i;
    }
    const auto [least, most] = std::minmax_element(together.begin(), together.end());
    EXPECT_GE(*most - *least, 5.0F);
  }
}

}  // namespace
}  // namespace weft::agents::sim
