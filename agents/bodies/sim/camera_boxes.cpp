// Where the image shows what stands on the floor: rays only where a line of sight passes over a box, and only four
// for a cell that lies within one face.
#include <algorithm>
#include <cmath>

#include "agents/bodies/sim/camera.hpp"

namespace weft::agents::sim {
namespace {

constexpr double kFarthestBoxM = 6.0;

}  // namespace

/// Marks the cells in which a box may be seen: a line of sight to a node in or next to the cell passes over one; an
/// edge may pass between two nodes.
void Camera::mark_cells(const FloorShot& shot) {
  shows_.clear();
  const Eigen::Vector3d& middle = shot.site_from_camera_mid.translation;
  const std::vector<std::int32_t> near = scene_->boxes_near(middle.x(), middle.y(), kFarthestBoxM);
  std::vector<std::uint8_t> nodes(nodes_.x.size(), 0);
  bool any = false;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const Eigen::Vector3d& viewpoint = shot.mid_of_row(row_of_node(static_cast<int>(n) / columns_)).translation;
    nodes[n] = std::any_of(near.begin(), near.end(), [&](std::int32_t box) {
      return scene_->crosses(box, viewpoint.x(), viewpoint.y(), nodes_.x[n], nodes_.y[n]);
    });
    any = any || nodes[n] != 0;
  }
  if (!any) return;
  const int across = columns_ - 1;
  const int down = rows_ - 2;
  shows_.assign(static_cast<std::size_t>(across) * static_cast<std::size_t>(down), Shows::floor);
  for (int j = 0; j < down; ++j) {
    for (int i = 0; i < across; ++i) {
      for (int b = std::max(0, j - 1); b <= std::min(rows_ - 1, j + 2); ++b) {
        for (int a = std::max(0, i - 1); a <= std::min(columns_ - 1, i + 2); ++a) {
          if (nodes[static_cast<std::size_t>(b * columns_ + a)] != 0)
            shows(i * kShadeCell, j * kShadeCell) = Shows::mixed;
        }
      }
    }
  }
}

/// Marks what four corners agree on: most of a rack is the inside of one of its faces.
void Camera::cast_nodes(const FloorShot& shot) {
  const int across = columns_ - 1;
  const int down = rows_ - 2;
  node_hits_.resize(nodes_.x.size());
  std::array<Eigen::Vector3f, Scene::kPacket> directions;
  for (int j = 0; j <= down; ++j) {
    const int v = row_of_node(j);
    const Viewpoint viewpoint(shot.mid_of_row(v));
    for (int first = 0; first <= across; first += static_cast<int>(Scene::kPacket)) {
      const int count = std::min(static_cast<int>(Scene::kPacket), across + 1 - first);
      for (int i = 0; i < count; ++i) {
        const int u = std::min((first + i) * kShadeCell, camera_.width - 1);
        directions[static_cast<std::size_t>(i)] = direction_of(viewpoint, pixel(u, v));
      }
      const auto n = static_cast<std::size_t>(count);
      scene_->cast(viewpoint.at, std::span(directions).first(n),
                   std::span(node_hits_).subspan(static_cast<std::size_t>(j * columns_ + first), n));
    }
  }
  const auto face_of = [&](int i, int j) -> const BoxHit& {
    return node_hits_[static_cast<std::size_t>(std::clamp(j, 0, down) * columns_ + std::clamp(i, 0, across))];
  };
  const auto alike = [&](int i, int j, int beyond) {
    const BoxHit& first = face_of(i, j);
    for (int b = j - beyond; b <= j + 1 + beyond; ++b) {
      for (int a = i - beyond; a <= i + 1 + beyond; ++a) {
        if (face_of(a, b).box != first.box || face_of(a, b).face != first.face) return false;
      }
    }
    return true;
  };
  for (int j = 0; j < down; ++j) {
    for (int i = 0; i < across; ++i) {
      Shows& cell = shows(i * kShadeCell, j * kShadeCell);
      if (cell == Shows::floor || !alike(i, j, 0)) continue;
      const bool around = alike(i, j, 1);
      if (face_of(i, j).box >= 0) {
        cell = around ? Shows::inside : Shows::face;
      } else if (around) {
        cell = Shows::floor;
      }
    }
  }
}

void Camera::cast_cells(const FloorShot& shot) {
  std::array<Eigen::Vector3f, Scene::kPacket> directions;
  std::array<BoxHit, Scene::kPacket> hits;
  for (int v = 0; v < camera_.height; v += 2) {
    const Viewpoint viewpoint(shot.mid_of_row(v));  // of the row below it as well, which is taken next
    for (int u = 0; u < camera_.width; u += kShadeCell) {
      const Shows cell = shows(u, v);
      if (cell == Shows::floor || cell == Shows::inside) continue;
      for (std::size_t i = 0; i < Scene::kPacket; ++i) {
        directions[i] = direction_of(viewpoint, pixel(u + static_cast<int>(i % 8), v + static_cast<int>(i / 8)));
      }
      if (cell == Shows::mixed) {
        scene_->cast(viewpoint.at, directions, hits);
      } else {
        const BoxHit& corner = corner_hit(u, v);
        const FacePlane plane = scene_->plane_of(corner.box, corner.face, viewpoint.at);
        for (std::size_t i = 0; i < Scene::kPacket; ++i) {
          hits[i] = {corner.box, corner.face, plane.distance(directions[i])};
        }
      }
      for (std::size_t i = 0; i < Scene::kPacket; ++i) {
        hits_[pixel(u + static_cast<int>(i % 8), v + static_cast<int>(i / 8))] = hits[i];
      }
    }
  }
}

void Camera::find_boxes(const FloorShot& shot) {
  mark_cells(shot);
  if (shows_.empty()) return;
  cast_nodes(shot);
  cast_cells(shot);
}

/// Clears what was hit, so that between images nothing is: cheaper than to clear a whole picture.
void Camera::forget_boxes() {
  for (int v = 0; v < camera_.height; ++v) {
    for (int u = 0; u < camera_.width; u += kShadeCell) {
      const Shows cell = shows(u, v);
      if (cell == Shows::mixed || cell == Shows::face) {
        std::fill_n(hits_.begin() + static_cast<std::ptrdiff_t>(pixel(u, v)), kShadeCell, BoxHit{});
      }
    }
  }
}

}  // namespace weft::agents::sim
