#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "clients/cli/map_clouds.hpp"

namespace weft::cli {
namespace {

constexpr double kMostCells = 16e6;
constexpr float kLowestM = 0.12F;  // what is lower is floor, or driven over
constexpr float kHighestM = 1.8F;  // what is higher is above a robot
constexpr int kFloorGrey = 235;
constexpr int kDarker = 45;  // by each point
constexpr int kDarkest = 20;

}  // namespace

Mosaic from_above(const std::vector<Eigen::Vector3f>& points, double cell_m) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3f& point : points) box.extend(point.head<2>().cast<double>());
  Mosaic picture;
  picture.metres_per_pixel = std::max(cell_m, std::sqrt(box.volume() / kMostCells));
  picture.corner_in_drawing = {box.min().x(), box.max().y()};
  const auto cells = [&](double metres) {
    return static_cast<std::size_t>(std::floor(metres / picture.metres_per_pixel)) + 1;
  };
  picture.columns = cells(box.sizes().x());
  picture.rows = cells(box.sizes().y());
  picture.greys.assign(picture.rows * picture.columns, 0);
  for (const Eigen::Vector3f& point : points) {
    if (point.z() > kHighestM) continue;
    const std::size_t column = cells(static_cast<double>(point.x()) - picture.corner_in_drawing.x()) - 1;
    const std::size_t row = cells(picture.corner_in_drawing.y() - static_cast<double>(point.y())) - 1;
    std::uint8_t& grey = picture.greys[row * picture.columns + column];
    const int before = grey == 0 ? kFloorGrey : grey;
    grey = static_cast<std::uint8_t>(point.z() < kLowestM ? before : std::max(kDarkest, before - kDarker));
  }
  return picture;
}

}  // namespace weft::cli
