#include "agents/perception/clouds/voxel_grid.hpp"

#include "agents/perception/clouds/cell_table.hpp"

namespace weft::agents {

std::vector<Eigen::Vector3f> voxel_means(std::span<const Eigen::Vector3f> points, double voxel_m) {
  struct Sum {
    Eigen::Vector3d of_points = Eigen::Vector3d::Zero();
    double count = 0.0;
  };
  const double per_m = 1.0 / voxel_m;
  CellTable table(points.size() / 4);
  std::vector<Sum> sums;
  for (const Eigen::Vector3f& seen : points) {
    const Eigen::Vector3d point = seen.cast<double>();
    if (!is_on_grid(point, per_m)) continue;
    const std::uint32_t number = table.number_of(cell_of(point, per_m));
    if (number == sums.size()) sums.emplace_back();
    sums[number].of_points += point;
    sums[number].count += 1.0;
  }
  std::vector<Eigen::Vector3f> means;
  means.reserve(sums.size());
  for (const Sum& sum : sums) means.emplace_back((sum.of_points / sum.count).cast<float>());
  return means;
}

}  // namespace weft::agents
