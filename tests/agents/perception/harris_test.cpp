#include "agents/perception/harris.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace weft::agents {
namespace {

/// Returns a dark image with a bright square from (20, 20) on, `size` pixels wide.
cv::Mat square(int size) {
  cv::Mat grey(64, 64, CV_8UC1, cv::Scalar(40));
  grey(cv::Rect(20, 20, size, size)).setTo(200);
  return grey;
}

float response_at(const cv::Mat& grey, int column, int row) {
  return harris_response(grey, {}).at<float>(row, column);
}

TEST(Harris, TheResponseIsThatOfTheFormula) {
  const cv::Mat grey = square(24);
  const HarrisConfig config;
  // One pixel by hand: gradients and Gaussian window summed up around it.
  constexpr int column = 21;
  constexpr int row = 22;
  const auto value = [&](int c, int r) { return static_cast<double>(grey.at<std::uint8_t>(r, c)); };
  double a = 0.0, b = 0.0, c = 0.0, all = 0.0;
  for (int dr = -8; dr <= 8; ++dr) {
    for (int dc = -8; dc <= 8; ++dc) {
      const double w = std::exp(-(dr * dr + dc * dc) / (2.0 * config.window_px * config.window_px));
      const int x = column + dc;
      const int y = row + dr;
      const double dx =
          (3.0 * (value(x + 1, y - 1) - value(x - 1, y - 1)) + 10.0 * (value(x + 1, y) - value(x - 1, y)) +
           3.0 * (value(x + 1, y + 1) - value(x - 1, y + 1))) /
          32.0;
      const double dy =
          (3.0 * (value(x - 1, y + 1) - value(x - 1, y - 1)) + 10.0 * (value(x, y + 1) - value(x, y - 1)) +
           3.0 * (value(x + 1, y + 1) - value(x + 1, y - 1))) /
          32.0;
      a += w * dx * dx;
      b += w * dy * dy;
      c += w * dx * dy;
      all += w;
    }
  }
  a /= all;
  b /= all;
  c /= all;
  const double expected = a * b - c * c - config.sensitivity * (a + b) * (a + b);
  EXPECT_NEAR(response_at(grey, column, row), expected, 0.02 * std::abs(expected));
}

/// Returns the response as Lucas et al. print it, with C = (I_x I_y)^2 * w.
double printed_at(const cv::Mat& grey, int column, int row) {
  const HarrisConfig config;
  cv::Mat dx, dy, a, b, c;
  cv::Scharr(grey, dx, CV_32F, 1, 0, 1.0 / 32.0);
  cv::Scharr(grey, dy, CV_32F, 0, 1, 1.0 / 32.0);
  const cv::Mat product = dx.mul(dy);
  cv::GaussianBlur(dx.mul(dx), a, {}, config.window_px);
  cv::GaussianBlur(dy.mul(dy), b, {}, config.window_px);
  cv::GaussianBlur(product.mul(product), c, {}, config.window_px);
  const auto at = [&](const cv::Mat& of) { return static_cast<double>(of.at<float>(row, column)); };
  return at(a) * at(b) - at(c) * at(c) - config.sensitivity * (at(a) + at(b)) * (at(a) + at(b));
}

TEST(Harris, AsPrintedACornerWouldBeNone) {
  const cv::Mat grey = square(24);
  EXPECT_GT(response_at(grey, 20, 20), 0.0F);
  EXPECT_LT(printed_at(grey, 20, 20), 0.0);
}

TEST(Harris, ADiagonalEdgeIsNoCorner) {
  cv::Mat grey(64, 64, CV_8UC1, cv::Scalar(40));
  for (int row = 0; row < 64; ++row)
    for (int column = 0; column < row; ++column) grey.at<std::uint8_t>(row, column) = 200;
  EXPECT_LT(response_at(grey, 32, 32), 0.0F);
}

TEST(Harris, ASquareHasFourCorners) {
  const std::vector<cv::KeyPoint> corners = harris_corners(square(24), {.least_share = 0.1});
  ASSERT_EQ(corners.size(), 4U);
  for (const cv::KeyPoint& corner : corners) {
    const double x = std::min(std::abs(corner.pt.x - 19.5F), std::abs(corner.pt.x - 43.5F));
    const double y = std::min(std::abs(corner.pt.y - 19.5F), std::abs(corner.pt.y - 43.5F));
    EXPECT_LE(x, 2.0);
    EXPECT_LE(y, 2.0);
  }
}

TEST(Harris, AFlatImageHasNone) {
  EXPECT_TRUE(harris_corners(cv::Mat(64, 64, CV_8UC1, cv::Scalar(90)), {}).empty());
}

}  // namespace
}  // namespace weft::agents
