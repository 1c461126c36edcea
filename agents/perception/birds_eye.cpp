#include "agents/perception/birds_eye.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "agents/perception/attitude.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/opencv_view.hpp"
#include "agents/perception/plane/geometry.hpp"
#include "agents/perception/spread_corners.hpp"

namespace weft::agents {

struct BirdsEye::Tables {
  BirdsEyeArea area;
  double near_m = 0.0;
  int first_near_row = 0;        ///< rows from here on are read from the image at half size
  cv::Mat far_xy, far_fraction;  ///< fixed-point remap tables
  cv::Mat near_xy, near_fraction;
  cv::Mat seen;       ///< 255 where the camera sees the plane
  cv::Mat described;  ///< the same, less the border that descriptors need

  Eigen::Vector2d on_plane(double column, double row) const {
    return {area.far_m - row * area.metres_per_pixel, area.half_width_m - column * area.metres_per_pixel};
  }
};

namespace {

constexpr int descriptor_border_px = 20;

/// Returns metres a pixel spans across, at a point of the plane: below about half a map pixel the half-size image is
/// enough.
double finest_m_per_px(const CameraModel& camera, const Eigen::Vector2d& on_plane, double above_floor_m) {
  const Pose3 camera_from_robot = camera.robot_from_camera.inverse();
  const Eigen::Vector3d p = camera_from_robot * Eigen::Vector3d(on_plane.x(), on_plane.y(), above_floor_m);
  return p.z() / focal_px(camera);
}

/// Returns a detector of corners at one scale: the map's plane is always equally far away.
cv::Ptr<cv::ORB> detector(int count) {
  return cv::ORB::create(3 * count, 1.2F, 1, 16, 0, 2, cv::ORB::HARRIS_SCORE, 31, 8);
}

/// Returns the standard deviation of the grey values about a pixel that lies within the border of descriptors.
double contrast_about(const cv::Mat& map, const cv::Point2f& at) {
  constexpr int reach_px = 4;  // what a corner is made of: beyond lies what is beside it
  constexpr int side_px = 2 * reach_px + 1;
  const int left = cvRound(at.x) - reach_px;
  const int top = cvRound(at.y) - reach_px;
  int sum = 0;
  int squares = 0;
  for (int r = top; r < top + side_px; ++r) {
    const std::uint8_t* const row = map.ptr<std::uint8_t>(r) + left;
    for (int c = 0; c < side_px; ++c) {
      sum += row[c];
      squares += row[c] * row[c];
    }
  }
  const double mean = static_cast<double>(sum) / (side_px * side_px);
  return std::sqrt(std::max(0.0, static_cast<double>(squares) / (side_px * side_px) - mean * mean));
}

/// Leaves out the corners that equalising has made of the pixels' noise.
void leave_out_noise(const cv::Mat& map, double least_contrast, std::vector<cv::KeyPoint>& corners) {
  if (least_contrast <= 0.0) return;
  std::erase_if(corners,
                [&](const cv::KeyPoint& corner) { return contrast_about(map, corner.pt) <= least_contrast; });
}

/// Turns a direction in the map's image (x right, y down), degrees, into a heading in the robot frame, rad: image
/// right is robot -y, image down is robot -x.
double heading_of(float angle_deg) {
  const double image = angle_deg * M_PI / 180.0;
  return std::atan2(-std::cos(image), -std::sin(image));
}

/// Rounds ratios that are nearly whole, as 0.018 / 0.003 is: OpenCV shrinks by whole numbers several times as fast.
double whole_if_nearly(double ratio) {
  const double whole = std::round(ratio);
  return std::abs(ratio - whole) < 1e-9 ? whole : ratio;
}

}  // namespace

BirdsEye::BirdsEye(const CameraModel& camera, const BirdsEyeArea& area) {
  const auto t = std::make_shared<Tables>();
  t->area = area;
  t->near_m = area.far_m;
  for (const Eigen::Vector2d& p : footprint(camera, Attitude{}, area.far_m, area.above_floor_m))
    t->near_m = std::min(t->near_m, p.x());
  t->near_m = std::max(t->near_m, area.near_m);
  const int columns = static_cast<int>(2.0 * area.half_width_m / area.metres_per_pixel);
  const int rows = std::max(64, static_cast<int>((area.far_m - t->near_m) / area.metres_per_pixel));
  cv::Mat x(rows, columns, CV_32F);
  cv::Mat y(rows, columns, CV_32F);
  t->seen = cv::Mat::zeros(rows, columns, CV_8U);
  t->first_near_row = rows;
  const Eigen::Matrix3d homography = camera_from_plane(camera, Attitude{}, area.above_floor_m);
  for (int r = 0; r < rows; ++r) {
    if (finest_m_per_px(camera, t->on_plane(0.5 * columns, r), area.above_floor_m) < 0.55 * area.metres_per_pixel)
      t->first_near_row = std::min(t->first_near_row, r);
    for (int c = 0; c < columns; ++c) {
      const Eigen::Vector3d ray = homography * t->on_plane(c, r).homogeneous();
      const Eigen::Vector2d pixel =
          ray.z() > 1e-6 ? pixel_from_normalised(camera, ray.hnormalized()) : Eigen::Vector2d(-1e4, -1e4);
      x.at<float>(r, c) = static_cast<float>(pixel.x());
      y.at<float>(r, c) = static_cast<float>(pixel.y());
      const bool inside =
          pixel.x() >= 1.0 && pixel.y() >= 1.0 && pixel.x() <= camera.width - 2.0 && pixel.y() <= camera.height - 2.0;
      t->seen.at<std::uint8_t>(r, c) = inside ? 255 : 0;
    }
  }
  const auto split = [&](int from, int to, double scale, cv::Mat& xy, cv::Mat& fraction) {
    if (from >= to) return;
    // A half-size pixel covers two: its centre lies at 2 i + 0.5.
    const double shift = scale == 1.0 ? 0.0 : -0.25;
    cv::convertMaps(x.rowRange(from, to) * scale + shift, y.rowRange(from, to) * scale + shift, xy, fraction,
                    CV_16SC2);
  };
  split(0, t->first_near_row, 1.0, t->far_xy, t->far_fraction);
  split(t->first_near_row, rows, 0.5, t->near_xy, t->near_fraction);
  const int border = 2 * descriptor_border_px + 1;
  const cv::Mat framed = cv::Mat::zeros(rows, columns, CV_8U);
  const cv::Rect inner(descriptor_border_px, descriptor_border_px, columns - border, rows - border);
  t->seen(inner).copyTo(framed(inner));
  cv::erode(framed, t->described, cv::Mat::ones(border, border, CV_8U));
  tables_ = t;
}

RectifiedPlane BirdsEye::rectify(const Image& image, int count, double patch_metres_per_pixel) const {
  const Tables& t = *tables_;
  const cv::Mat grey = as_mat(image);
  cv::Mat map(t.seen.size(), CV_8U);  // NOLINT(misc-const-correctness): written through its rows
  if (!t.far_xy.empty())
    cv::remap(grey, map.rowRange(0, t.first_near_row), t.far_xy, t.far_fraction, cv::INTER_LINEAR,
              cv::BORDER_REPLICATE);
  if (!t.near_xy.empty()) {
    cv::Mat half;
    cv::resize(grey, half, {grey.cols / 2, grey.rows / 2}, 0, 0, cv::INTER_AREA);
    cv::remap(half, map.rowRange(t.first_near_row, map.rows), t.near_xy, t.near_fraction, cv::INTER_LINEAR,
              cv::BORDER_REPLICATE);
  }
  RectifiedPlane out;
  cv::Mat equal;
  cv::createCLAHE(3.0, {8, 8})->apply(map, equal);

  std::vector<cv::KeyPoint> keypoints;
  const cv::Ptr<cv::ORB> orb = detector(count);
  // Most floors have plenty of strong corners; weak ones cost time and are asked for only where they are needed.
  for (const int threshold : {36, 18, 8}) {
    orb->setFastThreshold(threshold);
    orb->detect(equal, keypoints, t.described);
    leave_out_noise(map, t.area.least_contrast, keypoints);
    if (keypoints.size() >= static_cast<std::size_t>(2 * count)) break;
  }
  keypoints = spread_corners(std::move(keypoints), equal.size(), 12, 9, count);
  cv::Mat descriptors;
  orb->compute(equal, keypoints, descriptors);
  for (std::size_t i = 0; i < keypoints.size(); ++i) {
    PlaneFeature feature;
    feature.on_plane = t.on_plane(keypoints[i].pt.x, keypoints[i].pt.y);
    feature.above_floor_m = t.area.above_floor_m;
    feature.heading_rad = heading_of(keypoints[i].angle);
    std::memcpy(feature.descriptor.data(), descriptors.ptr(static_cast<int>(i)), sizeof(Descriptor));
    out.features.push_back(feature);
  }

  const double shrink = 1.0 / whole_if_nearly(patch_metres_per_pixel / t.area.metres_per_pixel);
  cv::Mat visible;
  cv::bitwise_and(equal, t.seen, visible);
  cv::Mat small;
  cv::resize(visible, small, {}, shrink, shrink, cv::INTER_AREA);
  out.patch.width = small.cols;
  out.patch.height = small.rows;
  out.patch.metres_per_pixel = patch_metres_per_pixel;
  const double half = 0.5 * (1.0 / shrink - 1.0);
  out.patch.first_pixel_on_plane = t.on_plane(half, half);
  out.patch.pixels.assign(small.datastart, small.dataend);
  return out;
}

}  // namespace weft::agents
