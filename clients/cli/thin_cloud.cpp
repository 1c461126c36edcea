#include "clients/cli/thin_cloud.hpp"

#include <numeric>

#include "agents/perception/clouds/pcl_check.hpp"

namespace weft::cli {
namespace {

template <class Each>
std::vector<Each> picked(const std::vector<Each>& all, const std::vector<std::uint32_t>& indices) {
  std::vector<Each> some;
  if (all.empty()) return some;
  some.reserve(indices.size());
  for (const std::uint32_t index : indices) some.push_back(all[index]);
  return some;
}

std::vector<std::uint32_t> indices_left(const formats::Cloud& cloud, const Thinning& thinning) {
  if (thinning.alone_m > 0.0) {
    return agents::pcl_check::with_neighbours(cloud.points, thinning.alone_m, thinning.neighbours);
  }
  std::vector<std::uint32_t> indices(cloud.points.size());
  std::iota(indices.begin(), indices.end(), 0U);
  std::erase_if(indices, [&](std::uint32_t index) { return !cloud.points[index].allFinite(); });
  return indices;
}

}  // namespace

Result<formats::Cloud> thinned(const formats::Cloud& cloud, const Thinning& thinning) {
  const std::vector<std::uint32_t> indices = indices_left(cloud, thinning);
  formats::Cloud left;
  left.world_from_sensor = cloud.world_from_sensor;
  left.points = picked(cloud.points, indices);
  if (thinning.voxel_m > 0.0) {
    auto means = agents::pcl_check::voxel_grid(left.points, thinning.voxel_m);
    if (!means) return fail(means.error());
    left.points = std::move(*means);
  } else {
    left.intensities = picked(cloud.intensities, indices);
    left.colours = picked(cloud.colours, indices);
    left.normals = picked(cloud.normals, indices);
  }
  left.width = left.points.size();
  return left;
}

}  // namespace weft::cli
