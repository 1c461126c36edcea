#include "clients/evaluate/stereo/score.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "agents/perception/robust.hpp"
#include "clients/evaluate/floor/alignment.hpp"

namespace weft::evaluate::stereo {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

std::vector<Eigen::Vector3d> positions_of(const std::vector<Pose3>& poses) {
  std::vector<Eigen::Vector3d> positions;
  for (const Pose3& pose : poses) positions.push_back(pose.translation);
  return positions;
}

/// Sums up how far the steps of a path are off those of the truth.
void score_steps(const std::vector<Pose3>& truth, const std::vector<Pose3>& path, PathScore& score) {
  double metres2 = 0.0;
  double radians2 = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Pose3 true_step = truth[i - 1].inverse() * truth[i];
    const Pose3 off = true_step.inverse() * (path[i - 1].inverse() * path[i]);
    metres2 += off.translation.squaredNorm();
    radians2 += std::pow(Eigen::AngleAxisd(off.rotation).angle(), 2);
  }
  const auto steps = static_cast<double>(path.size() - 1);
  score.step_mm = 1e3 * std::sqrt(metres2 / steps);
  score.step_deg = kDegrees * std::sqrt(radians2 / steps);
}

/// Scores one path, and returns its positions in the frame of the truth.
std::vector<Eigen::Vector3d> score_path(const std::vector<Pose3>& truth, const std::vector<Pose3>& path,
                                        bool is_at_rest, PathScore& score) {
  const Pose3 from_start = truth.front() * path.front().inverse();
  const std::vector<Eigen::Vector3d> positions = positions_of(path);
  const Pose3 laid_by = is_at_rest ? from_start : floor::a_from_b_of(positions_of(truth), positions);
  std::vector<Eigen::Vector3d> laid;
  double squares = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    laid.push_back(laid_by * positions[i]);
    squares += (laid.back() - truth[i].translation).squaredNorm();
  }
  score.ate_m = std::sqrt(squares / static_cast<double>(path.size()));
  score.end_m = (from_start * positions.back() - truth.back().translation).norm();
  score_steps(truth, path, score);
  return laid;
}

double way_m(const std::vector<Pose3>& poses) {
  Eigen::Vector3d low = poses.front().translation;
  Eigen::Vector3d high = low;
  double way = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    low = low.cwiseMin(poses[i].translation);
    high = high.cwiseMax(poses[i].translation);
    way += (poses[i].translation - poses[i - 1].translation).norm();
  }
  // The noise of who measured adds up to a way even at rest.
  return (high - low).norm() < RateRow::kRestM ? (high - low).norm() : way;
}

}  // namespace

std::optional<Scored> score(const Followed& followed, std::size_t every, const formats::Trajectory& truth) {
  std::vector<Pose3> known;
  std::vector<Pose3> ours;
  std::vector<Pose3> baseline;
  std::vector<double> apart_s;
  for (std::size_t i = 0; i < followed.time_s.size(); ++i) {
    if (i > 0) apart_s.push_back(followed.time_s[i] - followed.time_s[i - 1]);
    const std::optional<Pose3> pose = floor::at_time(truth, followed.time_s[i]);
    if (!pose) continue;
    known.push_back(*pose);
    ours.push_back(followed.ours.start_from_robot[i]);
    baseline.push_back(followed.baseline.start_from_robot[i]);
  }
  if (known.size() < kFewestPairs) return std::nullopt;
  Scored scored;
  RateRow& row = scored.row;
  row.every = every;
  row.hz = 1.0 / agents::median_of(apart_s);
  row.pairs = known.size();
  row.way_m = way_m(known);
  scored.laid.truth = positions_of(known);
  scored.laid.ours = score_path(known, ours, row.is_at_rest(), row.ours);
  scored.laid.baseline = score_path(known, baseline, row.is_at_rest(), row.baseline);
  const auto all = static_cast<double>(followed.time_s.size());
  for (const auto& [path, one] : {std::pair{&followed.ours, &row.ours}, {&followed.baseline, &row.baseline}}) {
    one->seen = path->seen;
    one->ms = 1e3 * path->took_s / all;
  }
  return scored;
}

}  // namespace weft::evaluate::stereo
