// On real rectified pairs, where they are: WEFT_DATA names the folder that holds stereo-pairs.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <opencv2/imgproc.hpp>

#include "clients/evaluate/stereo/sgbm.hpp"
#include "images/read.hpp"

namespace weft::agents {
namespace {

namespace fs = std::filesystem;

/// Returns an image at half its size, or `parts` times smaller: its disparities are within what is searched then.
Image smaller(const images::Picture& picture, int parts) {
  const cv::Mat whole(picture.height, picture.width, CV_8UC1, const_cast<std::uint8_t*>(picture.samples.data()));
  Image image{picture.width / parts, picture.height / parts, nullptr};
  Bytes pixels(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  cv::Mat out(image.height, image.width, CV_8UC1, pixels.data());
  cv::resize(whole, out, out.size(), 0.0, 0.0, cv::INTER_AREA);
  image.pixels = std::make_shared<const Bytes>(std::move(pixels));
  return image;
}

struct Case {
  const char* name;
  int disparities;
};

class RealPair : public testing::TestWithParam<Case> {};

TEST_P(RealPair, IsMatchedAsSgbmMatchesIt) {
  const char* const named = std::getenv("WEFT_DATA");
  const fs::path folder = fs::path(named != nullptr ? named : WEFT_DATA_BESIDE) / "stereo-pairs";
  const std::string name = GetParam().name;
  const auto left = images::read(folder / (name + "_left.pgm"), images::Shades::grey);
  const auto right = images::read(folder / (name + "_right.pgm"), images::Shades::grey);
  if (!left || !right)
    GTEST_SKIP() << "SKIPPED: no pair at " << folder << "; set WEFT_DATA to the folder that holds stereo-pairs";
  const StereoPair pair{smaller(*left, 2), smaller(*right, 2)};
  DisparityConfig config;
  config.disparities = GetParam().disparities;
  const auto ours = match_disparity(config, pair);
  ASSERT_TRUE(ours) << ours.error().reason;
  const DisparityMap theirs = evaluate::stereo::sgbm(pair, config.disparities);
  std::size_t both = 0;
  std::size_t alike = 0;
  for (std::size_t i = 0; i < theirs.sixteenths.size(); ++i) {
    if (ours->sixteenths[i] == DisparityMap::none || theirs.sixteenths[i] == DisparityMap::none) continue;
    ++both;
    alike += std::abs(ours->sixteenths[i] - theirs.sixteenths[i]) <= 16 ? 1U : 0U;
  }
  const double share = static_cast<double>(alike) / static_cast<double>(both);
  RecordProperty("within_1px", std::to_string(share));
  EXPECT_GE(share, 0.92);
  EXPECT_GE(density(*ours), density(theirs) - 0.01);
}
INSTANTIATE_TEST_SUITE_P(Stereo, RealPair, testing::Values(Case{"cones", 64}, Case{"aloe", 128}),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace weft::agents
