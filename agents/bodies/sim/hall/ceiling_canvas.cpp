#include "agents/bodies/sim/hall/ceiling_canvas.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace weft::agents::sim {
namespace {

constexpr int kShift = 4;  // bits of a coordinate beyond the texel

}  // namespace

CeilingCanvas::CeilingCanvas(double width_m, double depth_m, double texel_m)
    : width_m_(width_m),
      depth_m_(depth_m),
      texel_m_(texel_m),
      grey_(static_cast<int>(std::ceil(depth_m / texel_m)), static_cast<int>(std::ceil(width_m / texel_m)), CV_8U) {}

/// Returns a length in sixteenths of a texel, as OpenCV draws.
int CeilingCanvas::texels(double metres) const {
  return static_cast<int>(std::lround(metres / texel_m_ * (1 << kShift)));
}

void CeilingCanvas::fill(std::initializer_list<Cloud> clouds, Random random) {
  cv::Mat sum(grey_.size(), CV_32F, cv::Scalar(128.0));
  for (const Cloud& cloud : clouds) {
    const int columns = std::max(2, static_cast<int>(width_m_ / cloud.size_m));
    const int rows = std::max(2, static_cast<int>(depth_m_ / cloud.size_m));
    cv::Mat coarse(rows, columns, CV_32F);
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x) coarse.at<float>(y, x) = static_cast<float>(cloud.grey * random.normal());
    cv::Mat fine;
    cv::resize(coarse, fine, grey_.size(), 0, 0, cv::INTER_CUBIC);
    sum += fine;
  }
  sum.convertTo(grey_, CV_8U);
}

void CeilingCanvas::shade(double x, double y, double width_m, double depth_m, double grey) {
  const cv::Rect all(0, 0, grey_.cols, grey_.rows);
  const cv::Rect part(texels(x) >> kShift, texels(y) >> kShift, texels(width_m) >> kShift, texels(depth_m) >> kShift);
  cv::Mat there = grey_(part & all);
  there.convertTo(there, CV_8U, 1.0, grey);
}

void CeilingCanvas::rectangle(double x, double y, double width_m, double depth_m, double grey) {
  cv::rectangle(grey_, cv::Point(texels(x), texels(y)), cv::Point(texels(x + width_m), texels(y + depth_m)),
                cv::Scalar(grey), cv::FILLED, cv::LINE_8, kShift);
}

void CeilingCanvas::disc(double x, double y, double radius_m, double grey) {
  cv::circle(grey_, {texels(x), texels(y)}, std::max(8, texels(radius_m)), cv::Scalar(grey), cv::FILLED, cv::LINE_AA,
             kShift);
}

void CeilingCanvas::line(double x0, double y0, double x1, double y1, double width_m, double grey) {
  const int thick = std::max(1, static_cast<int>(std::lround(width_m / texel_m_)));
  cv::line(grey_, {texels(x0), texels(y0)}, {texels(x1), texels(y1)}, cv::Scalar(grey), thick, cv::LINE_AA, kShift);
}

void CeilingCanvas::stain(double x, double y, double radius_m, double grey, Random random) {
  const auto side = static_cast<int>(3.0 * radius_m / texel_m_);
  const cv::Rect wanted((texels(x) >> kShift) - side / 2, (texels(y) >> kShift) - side / 2, side, side);
  if ((wanted & cv::Rect(0, 0, grey_.cols, grey_.rows)) != wanted || side < 4) return;
  constexpr int corners = 18;
  std::vector<cv::Point> rim;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * CV_PI * i / corners;
    const double reach = side / 3.0 * random.uniform(0.65, 1.2);
    rim.emplace_back(side / 2 + static_cast<int>(reach * std::cos(angle)),
                     side / 2 + static_cast<int>(reach * std::sin(angle)));
  }
  cv::Mat depth(side, side, CV_32F, cv::Scalar(0.0));
  cv::fillPoly(depth, std::vector<std::vector<cv::Point>>{rim}, cv::Scalar(0.6 * grey));
  cv::polylines(depth, std::vector<std::vector<cv::Point>>{rim}, true, cv::Scalar(grey), std::max(1, side / 24));
  const int soft = std::max(1, side / 40);
  cv::blur(depth, depth, {soft, soft});
  cv::Mat there = grey_(wanted);
  cv::Mat darker;
  cv::subtract(there, depth, darker, cv::noArray(), CV_32F);
  darker.convertTo(there, CV_8U);
}

cv::Mat CeilingCanvas::done() const {
  cv::Mat picture;
  grey_.convertTo(picture, CV_8U, 128.0 / std::max(1.0, cv::mean(grey_)[0]));
  return picture;
}

}  // namespace weft::agents::sim
