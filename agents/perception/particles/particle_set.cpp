#include "agents/perception/particles/particle_set.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "agents/perception/particles/pose_cells.hpp"

namespace weft::agents {
namespace {

/// Joins the cells that touch, and returns for each the number of its cluster: that of one of its cells.
std::vector<std::size_t> clusters_of(const CellNumbers& cells, std::int32_t turns) {
  constexpr std::size_t none = CellNumbers::kNone;
  std::vector<std::size_t> cluster(cells.count(), none);
  std::vector<std::size_t> open;
  for (std::size_t first = 0; first < cells.count(); ++first) {
    if (cluster[first] != none) continue;
    cluster[first] = first;
    open.push_back(first);
    while (!open.empty()) {
      const PoseCell at = cells.cell(open.back());
      open.pop_back();
      for (int i = 0; i < 27; ++i) {
        const PoseCell beside{at.column + i % 3 - 1, at.row + i / 3 % 3 - 1, (at.turn + i / 9 - 1 + turns) % turns};
        const std::size_t number = cells.find(beside);
        if (number == none || cluster[number] != none) continue;
        cluster[number] = first;
        open.push_back(number);
      }
    }
  }
  return cluster;
}

/// Sums up what is asked of a cluster's particles.
ParticleEstimate mean_of(const ParticleSet& particles, const std::vector<std::size_t>& which) {
  ParticleEstimate estimate;
  double sine = 0.0;
  double cosine = 0.0;
  for (const std::size_t i : which) {
    const double weight = particles.weight[i];
    const Pose2 pose = particles.pose(i);
    estimate.share += weight;
    estimate.chart_from_robot.x += weight * pose.x;
    estimate.chart_from_robot.y += weight * pose.y;
    sine += weight * std::sin(pose.heading);
    cosine += weight * std::cos(pose.heading);
  }
  const double all = std::max(estimate.share, 1e-300);
  estimate.chart_from_robot.x /= all;
  estimate.chart_from_robot.y /= all;
  estimate.chart_from_robot.heading = std::atan2(sine, cosine);
  const Pose2 robot_from_chart = estimate.chart_from_robot.inverse();
  for (const std::size_t i : which) {
    const Eigen::Vector3d off = se2_log(robot_from_chart * particles.pose(i));
    estimate.covariance += particles.weight[i] / all * off * off.transpose();
  }
  return estimate;
}

}  // namespace

void weigh_equally(ParticleSet& particles) {
  std::fill(particles.weight.begin(), particles.weight.end(), 1.0 / static_cast<double>(particles.size()));
}

double effective_count(const std::vector<double>& weights) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  const double squares = std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0);
  return squares > 0.0 ? sum * sum / squares : 0.0;
}

ParticleEstimate estimate_of(const ParticleSet& particles, double cell_m, double cell_rad) {
  const PoseCells space(cell_m, cell_rad);
  CellNumbers cells(particles.size());
  std::vector<std::size_t> cell_of(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) cell_of[i] = cells.number(space.at(particles.pose(i)));
  const std::vector<std::size_t> cluster = clusters_of(cells, space.turns());
  std::vector<double> weight(cells.count(), 0.0);
  for (std::size_t i = 0; i < particles.size(); ++i) weight[cluster[cell_of[i]]] += particles.weight[i];
  const auto heaviest = static_cast<std::size_t>(std::max_element(weight.begin(), weight.end()) - weight.begin());
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (cluster[cell_of[i]] == heaviest) which.push_back(i);
  return mean_of(particles, which);
}

}  // namespace weft::agents
