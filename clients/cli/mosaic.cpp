#include "clients/cli/mosaic.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

namespace weft::cli {
namespace {

constexpr double kMostPixels = 16e6;

bool is_empty(const agents::PlanePatch& patch) {
  return patch.width < 2 || patch.height < 2;
}

/// Returns the smallest box around a patch, in the drawing.
Eigen::AlignedBox2d box_around(const LaidPatch& laid) {
  const agents::PlanePatch& patch = laid.patch;
  Eigen::AlignedBox2d box;
  for (const int row : {0, patch.height - 1}) {
    for (const int column : {0, patch.width - 1}) {
      const Eigen::Vector2d in_place =
          patch.first_pixel_on_plane - patch.metres_per_pixel * Eigen::Vector2d(row, column);
      box.extend(laid.drawing_from_place * in_place);
    }
  }
  return box;
}

/// Holds what patches say of one pixel.
struct Said {
  float sum = 0.0F;
  float weight = 0.0F;
};

/// Returns what a patch says of a point of its place's frame; none: it does not show it.
std::optional<Said> said_of(const agents::PlanePatch& patch, const Eigen::Vector2d& in_place) {
  const Eigen::Vector2d at = (patch.first_pixel_on_plane - in_place) / patch.metres_per_pixel;  // row, column
  const int row = static_cast<int>(std::floor(at.x()));
  const int column = static_cast<int>(std::floor(at.y()));
  if (row < 0 || column < 0 || row + 1 >= patch.height || column + 1 >= patch.width) return std::nullopt;
  const double down = at.x() - row;
  const double right = at.y() - column;
  double grey = 0.0;
  for (const int r : {0, 1}) {
    for (const int c : {0, 1}) {
      const auto index = static_cast<std::size_t>(row + r) * static_cast<std::size_t>(patch.width) +
                         static_cast<std::size_t>(column + c);
      const std::uint8_t pixel = patch.pixels[index];
      if (pixel == 0) return std::nullopt;  // not seen
      grey += (r == 1 ? down : 1.0 - down) * (c == 1 ? right : 1.0 - right) * pixel;
    }
  }
  const double to_edge = std::min(
      {at.x() / patch.height, 1.0 - at.x() / patch.height, at.y() / patch.width, 1.0 - at.y() / patch.width});
  const double weight = 1e-3 + to_edge * to_edge;
  return Said{static_cast<float>(weight * grey), static_cast<float>(weight)};
}

void lay_on(const LaidPatch& laid, const Mosaic& mosaic, std::vector<Said>& all) {
  const Eigen::AlignedBox2d box = box_around(laid);
  const Pose2 place_from_drawing = laid.drawing_from_place.inverse();
  const double m = mosaic.metres_per_pixel;
  const Eigen::Vector2d& corner = mosaic.corner_in_drawing;
  const auto clamped = [](double at, std::size_t size) {
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(size)));
  };
  const std::size_t last_row = clamped(std::ceil((corner.y() - box.min().y()) / m), mosaic.rows);
  const std::size_t last_column = clamped(std::ceil((box.max().x() - corner.x()) / m), mosaic.columns);
  for (std::size_t row = clamped((corner.y() - box.max().y()) / m, mosaic.rows); row < last_row; ++row) {
    for (std::size_t column = clamped((box.min().x() - corner.x()) / m, mosaic.columns); column < last_column;
         ++column) {
      const Eigen::Vector2d in_drawing(corner.x() + (static_cast<double>(column) + 0.5) * m,
                                       corner.y() - (static_cast<double>(row) + 0.5) * m);
      const std::optional<Said> said = said_of(laid.patch, place_from_drawing * in_drawing);
      if (!said) continue;
      Said& pixel = all[row * mosaic.columns + column];
      pixel.sum += said->sum;
      pixel.weight += said->weight;
    }
  }
}

}  // namespace

std::array<Pose2, 2> Mosaic::extent() const {
  const double wide = static_cast<double>(columns) * metres_per_pixel;
  const double tall = static_cast<double>(rows) * metres_per_pixel;
  const Eigen::Vector2d& corner = corner_in_drawing;
  return {Pose2{corner.x(), corner.y() - tall, 0.0}, Pose2{corner.x() + wide, corner.y(), 0.0}};
}

bool Mosaic::covers(const Eigen::Vector2d& in_drawing) const {
  const auto [low, high] = extent();
  return in_drawing.x() >= low.x && in_drawing.x() <= high.x && in_drawing.y() >= low.y && in_drawing.y() <= high.y;
}

Mosaic lay_mosaic(const std::vector<LaidPatch>& patches) {
  Eigen::AlignedBox2d box;
  double finest_m = 1.0;
  for (const LaidPatch& laid : patches) {
    if (is_empty(laid.patch)) continue;
    box.extend(box_around(laid));
    finest_m = std::min(finest_m, laid.patch.metres_per_pixel);
  }
  Mosaic mosaic;
  mosaic.metres_per_pixel = std::max(finest_m, std::sqrt(box.volume() / kMostPixels));
  mosaic.corner_in_drawing = {box.min().x(), box.max().y()};
  const auto pixels = [&](double metres) {
    return static_cast<std::size_t>(std::ceil(metres / mosaic.metres_per_pixel)) + 1;
  };
  mosaic.columns = pixels(box.sizes().x());
  mosaic.rows = pixels(box.sizes().y());
  std::vector<Said> all(mosaic.rows * mosaic.columns);
  for (const LaidPatch& laid : patches) {
    if (!is_empty(laid.patch)) lay_on(laid, mosaic, all);
  }
  mosaic.greys.reserve(all.size());
  for (const Said& said : all) {
    const float grey = said.weight > 0.0F ? std::clamp(said.sum / said.weight, 1.0F, 255.0F) : 0.0F;
    mosaic.greys.push_back(static_cast<std::uint8_t>(std::lround(grey)));
  }
  return mosaic;
}

}  // namespace weft::cli
