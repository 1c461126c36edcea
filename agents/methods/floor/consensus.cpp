#include "agents/methods/floor/consensus.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"

namespace weft::agents {
namespace {

/// SE(2) that takes two points of b to two of a.
Pose2 pose_of_two(const Eigen::Vector2d& a1, const Eigen::Vector2d& a2, const Eigen::Vector2d& b1,
                  const Eigen::Vector2d& b2) {
  const Eigen::Vector2d da = a2 - a1;
  const Eigen::Vector2d db = b2 - b1;
  Pose2 pose;
  pose.heading = wrap_angle(std::atan2(da.y(), da.x()) - std::atan2(db.y(), db.x()));
  const Eigen::Vector2d turned = pose * Eigen::Vector2d(0.5 * (b1 + b2));
  const Eigen::Vector2d offset = 0.5 * (a1 + a2) - turned;
  pose.x = offset.x();
  pose.y = offset.y();
  return pose;
}

}  // namespace

Consensus find_consensus(const FloorConfig& c, const std::vector<Match>& matches,
                         const std::vector<Eigen::Vector2d>& at_a, const std::vector<Eigen::Vector2d>& at_b) {
  constexpr double shortest_base_m = 0.15;
  Random random(0x666C6F6F72ULL);
  Consensus best;
  auto hypotheses = static_cast<std::size_t>(c.hypotheses);
  const std::size_t most_tries = 20 * hypotheses;
  const std::size_t widening = hypotheses;  // the pool holds every match after as many tries
  for (std::size_t k = 0, tries = 0; k < hypotheses && tries < most_tries; ++tries) {
    const std::size_t pool = std::min(matches.size(), 20 + tries * matches.size() / widening);
    const Match& m = matches[random.below(pool)];
    const Match& n = matches[random.below(pool)];
    const double base_a = (at_a[m.a] - at_a[n.a]).norm();
    const double base_b = (at_b[m.b] - at_b[n.b]).norm();
    if (base_b < shortest_base_m || std::abs(base_a - base_b) > 1.5 * c.consensus_m) continue;
    ++k;
    const Pose2 pose = pose_of_two(at_a[m.a], at_a[n.a], at_b[m.b], at_b[n.b]);
    const double cosine = std::cos(pose.heading);
    const double sine = std::sin(pose.heading);
    std::size_t count = 0;
    for (const Match& match : matches) {
      const Eigen::Vector2d& p = at_b[match.b];
      const double dx = cosine * p.x() - sine * p.y() + pose.x - at_a[match.a].x();
      const double dy = sine * p.x() + cosine * p.y() + pose.y - at_a[match.a].y();
      count += dx * dx + dy * dy < c.consensus_m * c.consensus_m ? 1U : 0U;
    }
    if (count <= best.count) continue;
    best = {pose, count};
    // Enough are drawn once a pair of right ones was missed with probability 1e-4 (Fischler & Bolles 1981); at least
    // 50, because the first ones come from a small pool.
    const double share = static_cast<double>(count) / static_cast<double>(matches.size());
    const double needed = std::log(1e-4) / std::log(1.0 - std::min(share * share, 0.99));
    hypotheses = std::min(hypotheses, std::max<std::size_t>(50, static_cast<std::size_t>(needed)));
  }
  return best;
}

double area_of(const std::vector<Eigen::Vector2d>& points) {
  if (points.size() < 3) return 0.0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& point : points) mean += point;
  mean /= static_cast<double>(points.size());
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& point : points) scatter += (point - mean) * (point - mean).transpose();
  return std::sqrt(std::max(0.0, scatter.determinant())) / static_cast<double>(points.size());
}

}  // namespace weft::agents
