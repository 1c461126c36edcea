#include "agents/perception/plane/agreement.hpp"

#include "agents/perception/lens.hpp"
#include "agents/perception/plane/consensus.hpp"

namespace weft::agents {

RefinedMotion refine_motion(const TwoCameras& cameras, const std::vector<PlanePair>& all,
                            const std::vector<std::size_t>& start, const AttitudePrior& prior,
                            const PlanarState& from, double inlier_sigmas) {
  RefinedMotion out;
  for (const std::size_t i : start) out.pairs.push_back(all[i]);
  PlanarState state = from;
  for (const double widened : {2.0, 1.0, 1.0}) {
    out.fit = fit_planar_motion(cameras.a, cameras.b, out.pairs, prior, state);
    state = out.fit.state;
    out.pairs.clear();
    out.residual_px.clear();
    const Reprojector reproject_here(cameras.a, cameras.b, state);
    for (const PlanePair& pair : all) {
      const Reprojection there = reproject_here(pair);
      const double error = focal_px(cameras.b) * (pair.in_b - there.in_b).norm();
      if (!there.in_front || error > widened * inlier_sigmas * pair.sigma_px) continue;
      out.pairs.push_back(pair);
      out.residual_px.push_back(error);
    }
    if (out.pairs.size() < 8) break;
  }
  return out;
}

bool contains(const Polygon& anticlockwise, const Eigen::Vector2d& point) {
  for (std::size_t i = 0; i < anticlockwise.size(); ++i) {
    const Eigen::Vector2d& from = anticlockwise[i];
    const Eigen::Vector2d side = anticlockwise[(i + 1) % anticlockwise.size()] - from;
    if (side.x() * (point.y() - from.y()) - side.y() * (point.x() - from.x()) < 0.0) return false;
  }
  return !anticlockwise.empty();
}

double spread_of_agreement(const std::vector<Match>& matches, const Pose2& a_from_b,
                           const std::vector<Eigen::Vector2d>& at_a, const std::vector<Eigen::Vector2d>& at_b,
                           const Polygon& seen_by_a, double within_m) {
  std::vector<Eigen::Vector2d> shared;
  for (const Eigen::Vector2d& point : at_b)
    if (contains(seen_by_a, a_from_b * point)) shared.push_back(point);
  std::vector<Eigen::Vector2d> agreeing;
  for (const Match& match : matches)
    if ((a_from_b * at_b[match.b] - at_a[match.a]).norm() < within_m) agreeing.push_back(at_b[match.b]);
  const double whole = area_of(shared);
  return whole > 0.0 ? area_of(agreeing) / whole : 0.0;
}

std::vector<std::uint32_t> shared_stretch(const std::vector<Eigen::Vector2d>& at_a, const Polygon& seen_by_b,
                                          const Pose2& a_from_b) {
  const Pose2 b_from_a = a_from_b.inverse();
  std::vector<std::uint32_t> stretch;
  for (std::uint32_t i = 0; i < at_a.size(); ++i)
    if (contains(seen_by_b, b_from_a * at_a[i])) stretch.push_back(i);
  return stretch;
}

}  // namespace weft::agents
