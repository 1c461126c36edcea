#pragma once
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include "tests/support/marks.hpp"

namespace weft::agents::tiny {

/// Locates by PnP: marks hang from a ceiling at heights of their own, a camera in the robot's origin looks up. A
/// content holds 3D points and their image; a robot is located by the points of the two nearest places together.
/// Relations are Metric3.
class TwoPlacePnp {
 public:
  static constexpr std::string_view name = "two-place-pnp";
  static constexpr std::uint32_t content_format = 1;
  static constexpr ChartSize chart_size = {12, 200};
  using Content = MarksMethod::Content;
  using Odometry = MarksMethod::Odometry;
  using Chart = std::vector<ChartPlace<Content>>;
  struct Belief {
    Pose3 centre_from_robot;
  };

  Step observe(Odometry& odometry, const View* view, const Motion& motion) const {
    Step step = marks_.observe(odometry, view, motion);
    step.previous_from_current = raised(std::get<Metric2>(step.previous_from_current));
    return step;
  }
  OrRefusal<Content> extract(const Odometry& odometry, const View& view) const {
    return marks_.extract(odometry, view);
  }
  Bytes encode(const Content& content) const { return marks_.encode(content); }
  Result<Content> decode(ByteView bytes) const { return marks_.decode(bytes); }
  std::optional<Signature> sign(const Content&) const { return std::nullopt; }

  OrRefusal<Related> relate(const Content& a, const Content& b, const std::optional<Relation>& guess) const {
    // A first pose from the plan, as a planar matcher would give it, where there is no guess.
    const OrRefusal<Related> start = marks_.relate(a, b, std::nullopt);
    if (!start && !guess) return start;
    Points points;
    add(points, Pose3{}, a);
    return solve(points, b, lift(planar(start ? start->a_from_b : *guess)));
  }

  Chart chart(const Chart& around) const { return around; }
  Belief believed(const Chart&, const Belief& belief, const Estimate&) const { return belief; }
  Belief begin(const Chart& chart, const Estimate& seed) const {
    for (const auto& place : chart) {
      if (place.id == seed.place) return {spatial(compose(place.centre_from_place, seed.place_from_robot))};
    }
    return {};
  }

  Located<Belief> locate(const Chart& chart, Belief belief, const Step& step, const Content& seen) const {
    belief.centre_from_robot = belief.centre_from_robot * spatial(step.previous_from_current);
    std::vector<const ChartPlace<Content>*> near;
    for (const auto& place : chart) {
      if (place.content) near.push_back(&place);
    }
    const auto apart = [&](const ChartPlace<Content>* place) {
      return norm(Metric3{spatial(place->centre_from_place).inverse() * belief.centre_from_robot, {}});
    };
    std::stable_sort(near.begin(), near.end(), [&](const auto* a, const auto* b) { return apart(a) < apart(b); });
    if (near.size() < 2) return {belief, std::nullopt, {{"one_place_only", static_cast<double>(near.size()), 2.0}}};
    Points points;
    for (std::size_t i = 0; i < 2; ++i) add(points, spatial(near[i]->centre_from_place), *near[i]->content);
    const OrRefusal<Related> solved = solve(points, seen, belief.centre_from_robot);
    if (!solved) return {belief, std::nullopt, {solved.error()}};
    const auto& found = std::get<Metric3>(solved->a_from_b);
    belief.centre_from_robot = found.a_from_b;
    const Metric3 place_from_robot{spatial(near[0]->centre_from_place).inverse() * found.a_from_b, found.covariance};
    return {belief, Fix{near[0]->id, place_from_robot, *solved}, {}};
  }

 private:
  using Points = std::map<std::uint64_t, Eigen::Vector3d>;

  static double height_m(std::uint64_t mark) { return 1.0 + 0.3 * static_cast<double>(mark % 5); }
  static Eigen::Vector3d in_robot(const Marks::Sighting& seen) {
    return {seen.robot_from_mark.x, seen.robot_from_mark.y, height_m(seen.mark)};
  }
  static Pose3 spatial(const Relation& relation) {
    const auto* const metric = std::get_if<Metric3>(&relation);
    return metric != nullptr ? metric->a_from_b : lift(planar(relation));
  }
  static Metric3 raised(const Metric2& flat) {
    Matrix6d covariance = 1e-8 * Matrix6d::Identity();
    covariance(0, 0) = flat.covariance(0, 0);
    covariance(1, 1) = flat.covariance(1, 1);
    covariance(5, 5) = flat.covariance(2, 2);
    return {lift(flat.a_from_b), covariance};
  }
  static void add(Points& points, const Pose3& frame_from_robot, const Content& content) {
    for (const Marks::Sighting& seen : content.sightings) {
      points.emplace(seen.mark, frame_from_robot * in_robot(seen));
    }
  }

  /// Solves by Gauss-Newton on the image error of b's marks, twice: of all, then of those that fit.
  OrRefusal<Related> solve(const Points& points, const Content& seen, Pose3 frame_from_robot) const {
    constexpr double sigma = 0.007;  // of an image coordinate in units of the focal length, points' noise included
    constexpr double gate = 0.06;
    Matrix6d information;
    std::uint32_t used = 0;
    double squared = 0.0;
    for (int round = 0; round < 8; ++round) {
      information.setZero();
      Vector6d gradient = Vector6d::Zero();
      used = 0;
      squared = 0.0;
      for (const Marks::Sighting& mark : seen.sightings) {
        const auto found = points.find(mark.mark);
        if (found == points.end()) continue;
        const Eigen::Vector3d p = frame_from_robot.inverse() * found->second;
        if (p.z() < 0.2) continue;
        const Eigen::Vector3d truly = in_robot(mark);
        const Eigen::Vector2d error = p.head<2>() / p.z() - truly.head<2>() / truly.z();
        if (round >= 4 && error.norm() > gate) continue;
        Eigen::Matrix<double, 2, 3> projection;
        projection << 1 / p.z(), 0, -p.x() / (p.z() * p.z()), 0, 1 / p.z(), -p.y() / (p.z() * p.z());
        Eigen::Matrix<double, 3, 6> motion;  // of p when frame_from_robot is moved on by se3_exp(xi)
        motion.leftCols<3>() = -Eigen::Matrix3d::Identity();
        motion.rightCols<3>() << 0, -p.z(), p.y(), p.z(), 0, -p.x(), -p.y(), p.x(), 0;
        const Eigen::Matrix<double, 2, 6> jacobian = projection * motion;
        const double weight = error.norm() > gate ? gate / error.norm() : 1.0;
        information += weight * jacobian.transpose() * jacobian;
        gradient += weight * jacobian.transpose() * error;
        squared += error.squaredNorm();
        ++used;
      }
      constexpr std::uint32_t least = 5;
      if (used < least) return tl::unexpected(Refusal{"few_points", static_cast<double>(used), least});
      // The robot stands on a floor: a weak pull to it keeps few points from tilting the pose.
      Matrix6d level = Matrix6d::Zero();
      level.diagonal().segment<3>(2) = Eigen::Vector3d::Constant(1.0);
      Vector6d tilt = Vector6d::Zero();
      tilt.segment<3>(2) = se3_log(lift(project(frame_from_robot)).inverse() * frame_from_robot).segment<3>(2);
      information += level;
      gradient += level * tilt;
      frame_from_robot = frame_from_robot * se3_exp(-information.ldlt().solve(gradient));
      frame_from_robot.rotation.normalize();
    }
    Related related;
    const Matrix6d covariance = sigma * sigma * information.inverse();
    related.a_from_b = Metric3{frame_from_robot, 0.5 * (covariance + covariance.transpose())};
    related.inliers = used;
    related.overlap = static_cast<double>(used) / static_cast<double>(seen.sightings.size());
    related.residual = std::sqrt(squared / used) / sigma;
    constexpr double least_overlap = 0.3;
    constexpr double most_residual = 4.0;
    if (related.overlap < least_overlap) {
      return tl::unexpected(Refusal{"little_overlap", related.overlap, least_overlap});
    }
    if (related.residual > most_residual) {
      return tl::unexpected(Refusal{"points_do_not_fit", related.residual, most_residual});
    }
    return related;
  }

  MarksMethod marks_;
};

static_assert(ChartsItself<TwoPlacePnp>);

}  // namespace weft::agents::tiny
