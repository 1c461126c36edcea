#include "agents/perception/plane/consensus.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"

namespace weft::agents {
namespace {

/// Returns the pose a_from_b in SE(2) that takes two points of b to two of a.
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

/// Counts how many matches a motion explains: asked for hundreds of motions, so their points lie side by side.
class Counter {
 public:
  Counter(const std::vector<Match>& matches, const std::vector<Eigen::Vector2d>& at_a,
          const std::vector<Eigen::Vector2d>& at_b, double within_m)
      : a_(matches.size(), 2), b_(matches.size(), 2), squares_(matches.size()), most_(within_m * within_m) {
    for (std::size_t i = 0; i < matches.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      a_.row(row) = at_a[matches[i].a].transpose();
      b_.row(row) = at_b[matches[i].b].transpose();
    }
  }

  std::size_t count(const Pose2& a_from_b) {
    const double cosine = std::cos(a_from_b.heading);
    const double sine = std::sin(a_from_b.heading);
    squares_ = (cosine * b_.col(0) - sine * b_.col(1) + a_from_b.x - a_.col(0)).square() +
               (sine * b_.col(0) + cosine * b_.col(1) + a_from_b.y - a_.col(1)).square();
    return static_cast<std::size_t>((squares_ < most_).count());
  }

  /// Returns how much better than without any agreement the motion last counted is, by truncated distances: 1 for a
  /// match that agrees to the point, 0 for one that does not (Lucas et al., II.C: sum min(D, t)).
  double gained() const { return (1.0 - squares_.min(most_) / most_).sum(); }

 private:
  Eigen::ArrayX2d a_, b_;
  Eigen::ArrayXd squares_;
  double most_;
};

}  // namespace

Consensus find_consensus(const ConsensusBounds& bounds, const std::vector<Match>& matches,
                         const std::vector<Eigen::Vector2d>& at_a, const std::vector<Eigen::Vector2d>& at_b) {
  Random random(0x666C6F6F72ULL);
  Counter counter(matches, at_a, at_b, bounds.within_m);
  Consensus best;
  double most_gained = 0.0;
  auto hypotheses = static_cast<std::size_t>(bounds.hypotheses);
  const std::size_t most_tries = 20 * hypotheses;
  const std::size_t widening = hypotheses;  // the pool holds every match after as many tries
  for (std::size_t k = 0, tries = 0; k < hypotheses && tries < most_tries; ++tries) {
    const std::size_t pool = std::min(matches.size(), 20 + tries * matches.size() / widening);
    const Match& m = matches[random.below(pool)];
    const Match& n = matches[random.below(pool)];
    const double base_a = (at_a[m.a] - at_a[n.a]).norm();
    const double base_b = (at_b[m.b] - at_b[n.b]).norm();
    if (base_b < bounds.shortest_base_m || std::abs(base_a - base_b) > 1.5 * bounds.within_m) continue;
    ++k;
    const Pose2 pose = pose_of_two(at_a[m.a], at_a[n.a], at_b[m.b], at_b[n.b]);
    const std::size_t count = counter.count(pose);
    if (bounds.score == ConsensusScore::truncated) {
      const double gained = counter.gained();
      if (gained <= most_gained) continue;
      most_gained = gained;
    } else if (count <= best.count) {
      continue;
    }
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
