#include "clients/evaluate/floor/alignment.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace weft::evaluate::floor {
namespace {

constexpr std::size_t kFewest = 10;
constexpr double kLeastM = 0.1;

double yaw_of(const Eigen::Quaterniond& rotation) {
  const Eigen::Vector3d forward = rotation * Eigen::Vector3d::UnitX();
  return std::atan2(forward.y(), forward.x());
}

Eigen::Vector3d centre_of(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

}  // namespace

std::optional<Pose3> at_time(const formats::Trajectory& trajectory, double time_s, double gap_s) {
  const auto& samples = trajectory.samples;
  const auto after = std::lower_bound(samples.begin(), samples.end(), time_s,
                                      [](const auto& sample, double time) { return sample.time_s < time; });
  if (after == samples.end()) return std::nullopt;
  if (after->time_s == time_s) return after->frame_from_body;
  if (after == samples.begin() || after->time_s - (after - 1)->time_s > gap_s) return std::nullopt;
  const auto& before = *(after - 1);
  const double share = (time_s - before.time_s) / (after->time_s - before.time_s);
  Pose3 pose;
  pose.translation = (1.0 - share) * before.frame_from_body.translation + share * after->frame_from_body.translation;
  pose.rotation = before.frame_from_body.rotation.slerp(share, after->frame_from_body.rotation);
  return pose;
}

Pose3 a_from_b_of(const std::vector<Eigen::Vector3d>& in_a, const std::vector<Eigen::Vector3d>& in_b) {
  const Eigen::Vector3d mean_a = centre_of(in_a);
  const Eigen::Vector3d mean_b = centre_of(in_b);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < in_a.size(); ++i) covariance += (in_a[i] - mean_a) * (in_b[i] - mean_b).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity();
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0) mirror(2, 2) = -1.0;
  Pose3 a_from_b;
  a_from_b.rotation = Eigen::Quaterniond(svd.matrixU() * mirror * svd.matrixV().transpose()).normalized();
  a_from_b.translation = mean_a - a_from_b.rotation * mean_b;
  return a_from_b;
}

std::optional<Associated> associate(const Trace& trace, const formats::Trajectory& trajectory) {
  Associated associated;
  std::vector<Pose3> truth;
  std::vector<Eigen::Vector3d> in_start;
  std::vector<Eigen::Vector3d> in_truth;
  for (const Moment& moment : trace.moments) {
    const std::optional<Pose3> pose = at_time(trajectory, moment.sensor_s);
    if (!pose) continue;
    associated.trace.moments.push_back(moment);
    truth.push_back(*pose);
    in_start.emplace_back(moment.start_from_robot.x, moment.start_from_robot.y, 0.0);
    in_truth.push_back(pose->translation);
  }
  const auto moves = [&](const Eigen::Vector3d& point) { return (point - in_truth.front()).norm() > kLeastM; };
  if (truth.size() < kFewest || std::none_of(in_truth.begin(), in_truth.end(), moves)) return std::nullopt;
  const Pose3 start_from_truth = a_from_b_of(in_start, in_truth);

  double squares = 0.0;
  double heights = 0.0;
  Eigen::Vector2d offset = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < truth.size(); ++i) {
    Moment& moment = associated.trace.moments[i];
    const Pose3 pose = start_from_truth * truth[i];
    moment.true_s = moment.sensor_s;
    moment.site_from_robot = {pose.translation.x(), pose.translation.y(), yaw_of(pose.rotation)};
    squares += (pose.translation - in_start[i]).squaredNorm();
    heights += pose.translation.z() * pose.translation.z();
    const double off = moment.start_from_robot.heading - moment.site_from_robot.heading;
    offset += Eigen::Vector2d(std::cos(off), std::sin(off));
  }
  associated.heading_offset_rad = std::atan2(offset.y(), offset.x());
  for (Moment& moment : associated.trace.moments) {
    moment.site_from_robot.heading = wrap_angle(moment.site_from_robot.heading + associated.heading_offset_rad);
  }
  const auto count = static_cast<double>(truth.size());
  associated.rmse_m = std::sqrt(squares / count);
  associated.out_of_plane_m = std::sqrt(heights / count);
  associated.start_from_truth = start_from_truth;
  return associated;
}

Trace in_frame_of(const Associated& associated, const Trace& trace, const formats::Trajectory& trajectory) {
  Trace placed;
  for (const Moment& moment : trace.moments) {
    const std::optional<Pose3> found = at_time(trajectory, moment.sensor_s);
    if (!found) continue;
    const Pose3 pose = associated.start_from_truth * *found;
    placed.moments.push_back(moment);
    placed.moments.back().true_s = moment.sensor_s;
    placed.moments.back().site_from_robot = {pose.translation.x(), pose.translation.y(),
                                             wrap_angle(yaw_of(pose.rotation) + associated.heading_offset_rad)};
  }
  return placed;
}

}  // namespace weft::evaluate::floor
