#pragma once
#include <Eigen/SVD>
#include <map>

#include "agents/methods/dead_reckoning.hpp"
#include "agents/methods/method.hpp"
#include "agents/perception/rig.hpp"
#include "tests/agents/methods/tiny/ramp.hpp"

namespace weft::agents::tiny {

/// Relates points of a stereo pair by the rigid motion between them. Relations are Metric3, with z and pitch.
class RampStereo {
 public:
  static constexpr std::string_view name = "ramp-stereo";
  static constexpr std::uint32_t content_format = 1;
  static constexpr SensorNeed needs = {SensorKind::stereo, Gaze::up, 1};
  /// Holds points by mark, in the robot's frame.
  using Content = std::map<std::uint64_t, Eigen::Vector3d>;
  struct Odometry {
    Content last;
    Pose3 last_from_now;
  };

  Step observe(Odometry& odometry, const View* view, const Motion& motion) const {
    Step step = dead_reckon({}, motion, "no_view");
    const auto reckoned = std::get<Metric2>(step.previous_from_current);
    step.previous_from_current = Metric3{lift(reckoned.a_from_b), covariance(0.02)};
    odometry.last_from_now = odometry.last_from_now * lift(reckoned.a_from_b);
    if (view == nullptr) return step;
    const OrRefusal<Content> seen = extract(odometry, *view);
    const OrRefusal<Related> related =
        seen ? relate(odometry.last, *seen, std::nullopt) : tl::unexpected(seen.error());
    constexpr double most_up_m = 0.1;  // no floor rises as much between two samples
    const Pose3 last_from_now = related ? std::get<Metric3>(related->a_from_b).a_from_b : Pose3{};
    if (related && std::abs(last_from_now.translation.z()) > most_up_m) {
      step.blind_reason = "jumps";
    } else if (related) {
      const Pose3 previous_from_last = (odometry.last_from_now * lift(reckoned.a_from_b).inverse()).inverse();
      step.previous_from_current =
          Metric3{previous_from_last * last_from_now, std::get<Metric3>(related->a_from_b).covariance};
      step.seen = true;
      step.blind_reason = {};
    } else {
      step.blind_reason = related.error().reason;
    }
    if (seen) odometry = {*seen, Pose3{}};
    return step;
  }

  OrRefusal<Content> extract(const Odometry&, const View& view) const {
    const auto* const pair = std::get_if<StereoPair>(&view.data);
    if (pair == nullptr) return tl::unexpected(Refusal{"not_a_pair"});
    Content content;
    const auto right = dots(pair->right);
    for (const auto& [mark, at] : dots(pair->left)) {
      const auto other = right.find(mark);
      if (other == right.end()) continue;
      const double disparity = at.y() - other->second.y();
      if (disparity < 8.0) continue;
      const double depth = StereoUp::focal_px * StereoUp::baseline_m / disparity;
      content.emplace(
          mark, Eigen::Vector3d(at.x() * depth / StereoUp::focal_px, at.y() * depth / StereoUp::focal_px, depth));
    }
    if (content.empty()) return tl::unexpected(Refusal{"no_marks", 0.0, 1.0});
    return content;
  }

  Bytes encode(const Content& content) const {
    Bytes bytes;
    for (const auto& [mark, at] : content) {
      const std::array<double, 4> row = {static_cast<double>(mark), at.x(), at.y(), at.z()};
      const auto* const raw = reinterpret_cast<const std::uint8_t*>(row.data());
      bytes.insert(bytes.end(), raw, raw + sizeof(row));
    }
    return bytes;
  }
  Result<Content> decode(ByteView bytes) const {
    if (bytes.size() % 32 != 0) return fail(ErrorCode::corrupt, "ramp-stereo: not of 32 bytes a mark");
    Content content;
    for (std::size_t at = 0; at < bytes.size(); at += 32) {
      std::array<double, 4> row{};
      std::copy_n(bytes.data() + at, 32, reinterpret_cast<std::uint8_t*>(row.data()));
      content.emplace(static_cast<std::uint64_t>(row[0]), Eigen::Vector3d(row[1], row[2], row[3]));
    }
    return content;
  }
  std::optional<Signature> sign(const Content&) const { return std::nullopt; }

  /// Fits by least squares over the common points (Arun et al. 1987), twice: to all, then to those that fit.
  OrRefusal<Related> relate(const Content& a, const Content& b, const std::optional<Relation>&) const {
    constexpr std::size_t least = 6;
    constexpr double gate_m = 0.12;
    std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> common;
    for (const auto& [mark, in_b] : b)
      if (const auto in_a = a.find(mark); in_a != a.end()) common.emplace_back(in_a->second, in_b);
    Pose3 a_from_b;
    double squared = 0.0;
    for (int round = 0; round < 2; ++round) {
      if (round > 0)
        std::erase_if(common,
                      [&](const auto& pair) { return (a_from_b * pair.second - pair.first).norm() > gate_m; });
      if (common.size() < least)
        return tl::unexpected(Refusal{"few_points", static_cast<double>(common.size()), static_cast<double>(least)});
      a_from_b = rigid(common);
      squared = 0.0;
      for (const auto& [in_a, in_b] : common) squared += (a_from_b * in_b - in_a).squaredNorm();
    }
    const auto count = static_cast<double>(common.size());
    Related related;
    related.a_from_b = Metric3{a_from_b, covariance(0.03 / std::sqrt(count))};
    related.inliers = static_cast<std::uint32_t>(common.size());
    related.overlap = count / static_cast<double>(b.size());
    related.residual = std::sqrt(squared / count);
    constexpr double least_overlap = 0.3;
    if (related.overlap < least_overlap)
      return tl::unexpected(Refusal{"little_overlap", related.overlap, least_overlap});
    return related;
  }

 private:
  static Matrix6d covariance(double sigma) { return sigma * sigma * Matrix6d::Identity(); }

  /// Returns row and column of each mark against the middle, in pixels.
  static std::map<std::uint64_t, Eigen::Vector2d> dots(const Image& image) {
    std::map<std::uint64_t, Eigen::Vector2d> found;
    const Bytes& pixels = *image.pixels;
    const auto within = [&pixels](std::size_t at) { return (pixels[at] - 0.5) / 254.0; };
    for (std::size_t i = 0; i + 3 < pixels.size(); ++i) {
      if (pixels[i] == 0) continue;
      const auto width = static_cast<std::size_t>(image.width);
      const std::uint64_t mark = std::uint64_t{255} * (pixels[i] - 1U) + pixels[i + 1] - 1U;
      const std::size_t row = i / width;
      const std::size_t column = i % width;
      found[mark] = {static_cast<double>(row) + within(i + 2) - 0.5 * image.height,
                     static_cast<double>(column) + within(i + 3) - 0.5 * image.width};
      i += 3;
    }
    return found;
  }

  static Pose3 rigid(const std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>& common) {
    Eigen::Vector3d mean_a = Eigen::Vector3d::Zero();
    Eigen::Vector3d mean_b = Eigen::Vector3d::Zero();
    for (const auto& [a, b] : common) {
      mean_a += a / static_cast<double>(common.size());
      mean_b += b / static_cast<double>(common.size());
    }
    Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
    for (const auto& [a, b] : common) moment += (b - mean_b) * (a - mean_a).transpose();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moment, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector3d signs(1.0, 1.0, (svd.matrixV() * svd.matrixU().transpose()).determinant());
    const Eigen::Matrix3d rotation = svd.matrixV() * signs.asDiagonal() * svd.matrixU().transpose();
    return {Eigen::Quaterniond(rotation).normalized(), mean_a - rotation * mean_b};
  }
};
static_assert(Method<RampStereo>);

}  // namespace weft::agents::tiny
