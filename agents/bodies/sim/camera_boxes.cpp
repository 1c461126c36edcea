// What stands on the floor, drawn over the sampled floor: rays only where a line of sight passes over a box, and four
// of them only where an edge runs through a pixel.
#include <algorithm>
#include <cmath>

#include "agents/bodies/sim/camera.hpp"

namespace weft::agents::sim {
namespace {

constexpr double kFarthestBoxM = 6.0;

/// Directions and what lights a hit, for one pose of the camera.
struct Eye {
  Eigen::Vector3d at;
  Eigen::Matrix3f site_from_camera;
};
Eye eye_from(const Pose3& site_from_camera) {
  return {site_from_camera.translation, site_from_camera.rotation.toRotationMatrix().cast<float>()};
}

/// Grey of a hit under the site's light, before the camera's gain.
float grey_of(const BoxHit& hit, const Eye& eye, const Eigen::Vector3f& direction, const Scene& scene,
              const Light& light, double per_focal) {
  const Box& box = scene.boxes()[static_cast<std::size_t>(hit.box)];
  const Eigen::Vector3d p = eye.at + (direction * hit.distance).cast<double>();
  const Eigen::Vector2d in_box = scene.in_box(hit.box, p.x(), p.y());
  const double along = hit.face == 4 || hit.face % 2 == 1 ? in_box.x() : in_box.y();
  const double up = hit.face == 4 ? in_box.y() : p.z();
  const float albedo = face_albedo(box, hit.box, hit.face, along, up, hit.distance * per_focal);
  // Faces turned to different sides differ a little, as under any real light.
  constexpr std::array<float, 5> kSide = {1.0F, 0.88F, 0.95F, 0.82F, 1.1F};
  return albedo * kSide[static_cast<std::size_t>(hit.face)] * static_cast<float>(light.on_wall(p.x(), p.y(), p.z()));
}

}  // namespace

std::vector<std::uint8_t> Camera::cells_with_boxes(const Eigen::Vector3d& eye) const {
  const std::vector<std::int32_t> near = scene_->boxes_near(eye.x(), eye.y(), kFarthestBoxM);
  std::vector<std::uint8_t> cells;
  if (near.empty()) {
    return cells;
  }
  std::vector<std::uint8_t> nodes(nodes_.size(), 0);
  bool any = false;
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    for (const std::int32_t box : near) {
      if (scene_->crosses(box, eye.x(), eye.y(), nodes_[n].x, nodes_[n].y)) {
        nodes[n] = 1;
        any = true;
        break;
      }
    }
  }
  if (!any) {
    return cells;
  }
  // A cell is drawn when one of the nodes in or next to it sees a box: an edge may pass between two nodes.
  const int across = columns_ - 1;
  const int down = rows_ - 2;
  cells.assign(static_cast<std::size_t>(across) * static_cast<std::size_t>(down), 0);
  for (int j = 0; j < down; ++j) {
    for (int i = 0; i < across; ++i) {
      for (int b = std::max(0, j - 1); b <= std::min(rows_ - 1, j + 2); ++b) {
        for (int a = std::max(0, i - 1); a <= std::min(columns_ - 1, i + 2); ++a) {
          cells[static_cast<std::size_t>(j * across + i)] |= nodes[static_cast<std::size_t>(b * columns_ + a)];
        }
      }
    }
  }
  return cells;
}

void Camera::cast_cells(const std::vector<std::uint8_t>& cells, const Pose3& site_from_camera) {
  const Eye eye = eye_from(site_from_camera);
  const int across = columns_ - 1;
  std::array<Eigen::Vector3f, Scene::kPacket> directions;
  std::array<BoxHit, Scene::kPacket> hits;
  for (int v = 0; v < camera_.height; v += 2) {
    for (int u = 0; u < camera_.width; u += kShadeCell) {
      if (cells[static_cast<std::size_t>((v / kShadeCell) * across + u / kShadeCell)] == 0) {
        continue;
      }
      for (std::size_t i = 0; i < Scene::kPacket; ++i) {
        const std::size_t at = pixel(u + static_cast<int>(i % 8), v + static_cast<int>(i / 8));
        directions[i] = eye.site_from_camera * Eigen::Vector3f(rays_.x[at], rays_.y[at], 1.0F);
      }
      scene_->cast(eye.at, directions, hits);
      for (std::size_t i = 0; i < Scene::kPacket; ++i) {
        hits_[pixel(u + static_cast<int>(i % 8), v + static_cast<int>(i / 8))] = hits[i];
      }
    }
  }
}

bool Camera::at_edge(int u, int v) const {
  const BoxHit& here = hits_[pixel(u, v)];
  for (const auto& [du, dv] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
    const int a = std::clamp(u + du, 0, camera_.width - 1);
    const int b = std::clamp(v + dv, 0, camera_.height - 1);
    const BoxHit& there = hits_[pixel(a, b)];
    if (there.box != here.box || there.face != here.face) {
      return true;
    }
  }
  return false;
}

void Camera::draw_boxes(const Exposure& exposure) {
  const Eigen::Vector3d& middle = exposure.site_from_camera_mid.translation;
  const std::vector<std::uint8_t> cells = cells_with_boxes(middle);
  if (cells.empty()) {
    return;
  }
  cast_cells(cells, exposure.site_from_camera_mid);
  const Eye mid_eye = eye_from(exposure.site_from_camera_mid);
  std::array<Eye, kSubsamples> eyes;
  std::transform(exposure.site_from_camera.begin(), exposure.site_from_camera.end(), eyes.begin(), eye_from);
  const double per_focal = 1.0 / camera_.fx;
  const int across = columns_ - 1;
  for (int v = 0; v < camera_.height; ++v) {
    for (int u = 0; u < camera_.width; ++u) {
      if (cells[static_cast<std::size_t>((v / kShadeCell) * across + u / kShadeCell)] == 0) {
        continue;
      }
      const std::size_t at = pixel(u, v);
      const bool edge = at_edge(u, v);
      if (!edge && hits_[at].box < 0) {
        continue;
      }
      const Eigen::Vector3f ray(rays_.x[at], rays_.y[at], 1.0F);
      const PixelLight light = light_at(u, v, exposure.gain);
      float sum = 0.0F;
      if (!edge) {
        const Eigen::Vector3f direction = mid_eye.site_from_camera * ray;
        sum = kSubsamples * light.camera_gain * grey_of(hits_[at], mid_eye, direction, *scene_, light_, per_focal);
      } else {
        for (std::size_t k = 0; k < kSubsamples; ++k) {
          const Eigen::Vector3f inside =
              ray + Eigen::Vector3f(static_cast<float>(kSubsampleRight[k] * per_focal),
                                    static_cast<float>(kSubsampleDown[k] * per_focal), 0.0F);
          const Eigen::Vector3f direction = eyes[k].site_from_camera * inside;
          BoxHit hit;
          scene_->cast(eyes[k].at, {&direction, 1}, {&hit, 1});
          sum += hit.box < 0 ? albedo_[at] * light.gain + light.add
                             : light.camera_gain * grey_of(hit, eyes[k], direction, *scene_, light_, per_focal);
        }
      }
      // Development puts the floor's light on every pixel; here it is taken out beforehand.
      albedo_[at] = (sum / kSubsamples - light.add) / light.gain;
    }
  }
  // Between images nothing is hit: clearing what was cast is cheaper than a whole picture.
  for (int v = 0; v < camera_.height; ++v) {
    for (int cell = 0; cell < across; ++cell) {
      if (cells[static_cast<std::size_t>((v / kShadeCell) * across + cell)] != 0) {
        std::fill_n(hits_.begin() + static_cast<std::ptrdiff_t>(pixel(cell * kShadeCell, v)), kShadeCell, BoxHit{});
      }
    }
  }
}

}  // namespace weft::agents::sim
