#include "clients/evaluate/ceiling/sift_map.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/features2d.hpp>
#include <utility>
#include <vector>

#include "agents/perception/hamming.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/plane/consensus.hpp"
#include "agents/perception/plane/geometry.hpp"

namespace weft::evaluate::ceiling {
namespace {

using namespace agents;

constexpr int kSiftFeatures = 300;
constexpr double kSiftWidestRad = 1.0;  // off the axis

/// Holds features of one image on the ceiling, in the robot's frame.
struct OnCeiling {
  std::vector<Eigen::Vector2d> in_robot;
  cv::Mat descriptors;
};

OnCeiling sift_of(const CameraModel& camera, const Image& image, double ceiling_m) {
  const cv::Mat grey(image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.pixels->data()));
  std::vector<cv::KeyPoint> points;
  cv::Mat descriptors;
  cv::SIFT::create(kSiftFeatures)->detectAndCompute(grey, cv::noArray(), points, descriptors);
  const Eigen::Matrix3d robot_from_view = camera_from_plane(camera, Attitude{}, ceiling_m).inverse();
  OnCeiling features;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d in_view = normalised_from_pixel(camera, {points[i].pt.x, points[i].pt.y});
    if (std::atan(in_view.norm()) > kSiftWidestRad) continue;
    features.in_robot.push_back(apply(robot_from_view, in_view));
    features.descriptors.push_back(descriptors.row(static_cast<int>(i)));
  }
  return features;
}

}  // namespace

struct SiftMap::Features {
  std::vector<Eigen::Vector2d> in_map;
  cv::Mat descriptors;
};

SiftMap::SiftMap(double ceiling_m) : ceiling_m_(ceiling_m), features_(std::make_unique<Features>()) {}
SiftMap::~SiftMap() = default;
SiftMap::SiftMap(SiftMap&&) noexcept = default;
SiftMap& SiftMap::operator=(SiftMap&&) noexcept = default;

void SiftMap::add(const CameraModel& camera, const Image& image, const Pose2& map_from_robot) {
  const OnCeiling seen = sift_of(camera, image, ceiling_m_);
  for (const Eigen::Vector2d& point : seen.in_robot) features_->in_map.push_back(map_from_robot * point);
  if (!seen.descriptors.empty()) features_->descriptors.push_back(seen.descriptors);
}

std::optional<Pose2> SiftMap::find(const CameraModel& camera, const Image& image) const {
  constexpr float ratio = 0.8F;  // Lowe 2004
  constexpr std::size_t fewest = 12;
  constexpr double within_m = 0.1;
  const OnCeiling seen = sift_of(camera, image, ceiling_m_);
  if (seen.in_robot.size() < fewest || features_->in_map.size() < fewest) return std::nullopt;
  std::vector<std::vector<cv::DMatch>> nearest;
  cv::BFMatcher(cv::NORM_L2).knnMatch(seen.descriptors, features_->descriptors, nearest, 2);
  std::vector<Match> matches;
  for (const std::vector<cv::DMatch>& two : nearest) {
    if (two.size() < 2 || two[0].distance > ratio * two[1].distance) continue;
    matches.push_back({static_cast<std::uint32_t>(two[0].trainIdx), static_cast<std::uint32_t>(two[0].queryIdx),
                       static_cast<int>(two[0].distance)});
  }
  if (matches.size() < fewest) return std::nullopt;
  std::sort(matches.begin(), matches.end(),
            [](const Match& x, const Match& y) { return std::pair(x.distance, x.b) < std::pair(y.distance, y.b); });
  const Consensus consensus = find_consensus(
      {.within_m = within_m, .hypotheses = 2000, .shortest_base_m = 0.5, .score = ConsensusScore::truncated}, matches,
      features_->in_map, seen.in_robot);
  return consensus.count < fewest ? std::nullopt : std::optional(consensus.a_from_b);
}

}  // namespace weft::evaluate::ceiling
