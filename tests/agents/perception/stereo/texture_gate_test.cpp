#include "agents/perception/stereo/texture_gate.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "core/random.hpp"

namespace weft::agents {
namespace {

std::vector<std::uint8_t> gated(const cv::Mat& image, double least) {
  cv::Mat rimmed;
  cv::copyMakeBorder(image, rimmed, 2, 2, 2, 2, cv::BORDER_REPLICATE);
  TextureGate gate(image.cols, image.rows, least);
  std::vector<std::uint8_t> all;
  const auto tell = [&] {
    if (const std::uint8_t* row = gate.told()) all.insert(all.end(), row, row + image.cols);
  };
  for (int row = 0; row < image.rows; ++row) {
    FiveRows five;
    for (int i = 0; i < 5; ++i) five.row[i] = rimmed.ptr<std::uint8_t>(row + i) + 2;
    gate.take(five);
    tell();
  }
  for (int i = 0; i < 5; ++i) tell();
  return all;
}

/// Returns a plain wall with a wall of cards in its right half.
cv::Mat half_plain(int width, int height) {
  cv::Mat image(height, width, CV_8U, cv::Scalar(120));
  cv::RNG rng(3);
  for (int i = 0; i < 400; ++i)
    cv::rectangle(image, {width / 2 + rng.uniform(0, width / 2), rng.uniform(0, height), 6, 6}, rng.uniform(40, 220),
                  -1);
  return image;
}

TEST(TextureGate, IsTheMeanSquareOfSobelsGradient) {
  const cv::Mat image = half_plain(160, 90);
  constexpr double least = 60.0;
  cv::Mat wide;
  image.convertTo(wide, CV_64F);
  cv::Mat gradient;
  cv::blur(wide, wide, {3, 3}, {-1, -1}, cv::BORDER_REPLICATE);
  cv::Sobel(wide, gradient, CV_64F, 1, 0, 3, 1.0, 0.0, cv::BORDER_REPLICATE);
  cv::Mat mean;
  cv::boxFilter(gradient.mul(gradient), mean, CV_64F, {11, 11});
  const std::vector<std::uint8_t> ours = gated(image, least);
  ASSERT_EQ(ours.size(), image.total());
  int differ = 0;
  for (int y = 7; y < image.rows - 7; ++y)
    for (int x = 7; x < image.cols - 7; ++x) {
      const double rms = std::sqrt(mean.at<double>(y, x));
      if (std::abs(rms - least) < 0.5) continue;  // squares are kept in sixteenths
      differ += (rms >= least) != (ours[static_cast<std::size_t>(y * image.cols + x)] == 1) ? 1 : 0;
    }
  EXPECT_EQ(differ, 0);
}

TEST(TextureGate, APlainWallHasNone) {
  const cv::Mat image = half_plain(160, 90);
  const std::vector<std::uint8_t> ours = gated(image, 8.0);
  for (int y = 0; y < image.rows; ++y) {
    EXPECT_EQ(ours[static_cast<std::size_t>(y * image.cols + 40)], 0) << "row " << y;
    EXPECT_EQ(ours[static_cast<std::size_t>(y * image.cols + 120)], 1) << "row " << y;
  }
}

TEST(TextureGate, EdgesAlongTheRowsAreNone) {
  cv::Mat stripes(60, 80, CV_8U, cv::Scalar(60));
  for (int y = 0; y < stripes.rows; y += 8) cv::line(stripes, {0, y}, {79, y}, 200, 3);
  for (const std::uint8_t pixel : gated(stripes, 8.0)) ASSERT_EQ(pixel, 0);
}

}  // namespace
}  // namespace weft::agents
