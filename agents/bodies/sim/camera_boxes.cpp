// What stands on the floor, drawn over the sampled floor: rays only where a line of sight passes over a box, and four
// of them only where an edge runs through a pixel.
#include <algorithm>
#include <cmath>

#include "agents/bodies/sim/camera.hpp"

namespace weft::agents::sim {
namespace {

constexpr double kFarthestBoxM = 6.0;

float light_at_wall(const Light& light, const Eigen::Vector3d& p) {
  const Eigen::Vector3f at = p.cast<float>();
  float gain = 0.0F;
  light.on_wall({&at.x(), 1}, {&at.y(), 1}, {&at.z(), 1}, {&gain, 1});
  return gain;
}

}  // namespace

Camera::Surface Camera::surface_at(const BoxHit& hit, const Eye& eye, const Eigen::Vector3f& direction) {
  const Box& box = scene_->boxes()[static_cast<std::size_t>(hit.box)];
  const Eigen::Vector3d p = eye.at + (direction * hit.distance).cast<double>();
  const Eigen::Vector2d in_box = scene_->in_box(hit.box, p.x(), p.y());
  const double along = hit.face == 4 || hit.face % 2 == 1 ? in_box.x() : in_box.y();
  const double up = hit.face == 4 ? in_box.y() : p.z();
  const float albedo = face_albedo(box, hit.box, hit.face, along, up, hit.distance / camera_.fx, face_memo_);
  // Faces turned to different sides differ a little, as under any real light.
  constexpr std::array<float, 5> kSide = {1.0F, 0.88F, 0.95F, 0.82F, 1.1F};
  return {albedo * kSide[static_cast<std::size_t>(hit.face)], p};
}

/// Where a box may be seen: a line of sight to a node in or next to the cell passes over one; an edge may pass
/// between two nodes.
void Camera::mark_cells(const Eigen::Vector3d& eye) {
  shows_.clear();
  const std::vector<std::int32_t> near = scene_->boxes_near(eye.x(), eye.y(), kFarthestBoxM);
  std::vector<std::uint8_t> nodes(nodes_.x.size(), 0);
  bool any = false;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    nodes[n] = std::any_of(near.begin(), near.end(), [&](std::int32_t box) {
      return scene_->crosses(box, eye.x(), eye.y(), nodes_.x[n], nodes_.y[n]);
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
void Camera::cast_nodes(const Pose3& site_from_camera) {
  const Eye eye(site_from_camera);
  const int across = columns_ - 1;
  const int down = rows_ - 2;
  node_hits_.resize(nodes_.x.size());
  std::array<Eigen::Vector3f, Scene::kPacket> directions;
  for (int j = 0; j <= down; ++j) {
    const int v = std::min(j * kShadeCell, camera_.height - 1);
    for (int first = 0; first <= across; first += static_cast<int>(Scene::kPacket)) {
      const int count = std::min(static_cast<int>(Scene::kPacket), across + 1 - first);
      for (int i = 0; i < count; ++i) {
        const std::size_t at = pixel(std::min((first + i) * kShadeCell, camera_.width - 1), v);
        directions[static_cast<std::size_t>(i)] =
            eye.site_from_camera * Eigen::Vector3f(rays_.x[at], rays_.y[at], 1.0F);
      }
      const auto n = static_cast<std::size_t>(count);
      scene_->cast(eye.at, std::span(directions).first(n),
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

void Camera::cast_cells(const Pose3& site_from_camera) {
  const Eye eye(site_from_camera);
  std::array<Eigen::Vector3f, Scene::kPacket> directions;
  std::array<BoxHit, Scene::kPacket> hits;
  for (int v = 0; v < camera_.height; v += 2) {
    for (int u = 0; u < camera_.width; u += kShadeCell) {
      const Shows cell = shows(u, v);
      if (cell == Shows::floor) continue;
      for (std::size_t i = 0; i < Scene::kPacket; ++i) {
        const std::size_t at = pixel(u + static_cast<int>(i % 8), v + static_cast<int>(i / 8));
        directions[i] = eye.site_from_camera * Eigen::Vector3f(rays_.x[at], rays_.y[at], 1.0F);
      }
      if (cell == Shows::mixed) {
        scene_->cast(eye.at, directions, hits);
      } else {
        const BoxHit& corner = node_hits_[static_cast<std::size_t>((v / kShadeCell) * columns_ + u / kShadeCell)];
        for (std::size_t i = 0; i < Scene::kPacket; ++i) {
          hits[i] = {corner.box, corner.face, scene_->to_face(corner.box, corner.face, eye.at, directions[i])};
        }
      }
      for (std::size_t i = 0; i < Scene::kPacket; ++i) {
        hits_[pixel(u + static_cast<int>(i % 8), v + static_cast<int>(i / 8))] = hits[i];
      }
    }
  }
}

void Camera::find_boxes(const Exposure& exposure) {
  mark_cells(exposure.site_from_camera_mid.translation);
  if (shows_.empty()) return;
  cast_nodes(exposure.site_from_camera_mid);
  cast_cells(exposure.site_from_camera_mid);
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
  if (shows_.empty()) return;
  const Eye eye(exposure.site_from_camera_mid);
  edges_.clear();
  for (int v = 0; v < camera_.height; ++v) {
    for (int u = 0; u < camera_.width; u += kShadeCell) {
      const Shows cell = shows(u, v);
      if (cell == Shows::inside) {
        draw_run(eye, exposure.gain, u, v, kShadeCell);
      } else if (cell != Shows::floor) {
        for (int i = u; i < u + kShadeCell; ++i) {
          if (at_edge(i, v)) {
            edges_.push_back({i, v});
          } else if (hits_[pixel(i, v)].box >= 0) {
            draw_run(eye, exposure.gain, i, v, 1);
          }
        }
      }
    }
  }
  draw_edges(exposure);
  forget_boxes();
}

/// Pixels side by side on one face: along so few, the light changes evenly.
void Camera::draw_run(const Eye& eye, double exposure_gain, int u, int v, int count) {
  std::array<Surface, kShadeCell> surfaces;
  for (int i = 0; i < count; ++i) {
    const std::size_t at = pixel(u + i, v);
    const Eigen::Vector3f direction = eye.site_from_camera * Eigen::Vector3f(rays_.x[at], rays_.y[at], 1.0F);
    surfaces[static_cast<std::size_t>(i)] = surface_at(hits_[at], eye, direction);
  }
  const float first = light_at_wall(light_, surfaces[0].at);
  const float step = count < 2 ? 0.0F
                               : (light_at_wall(light_, surfaces[static_cast<std::size_t>(count - 1)].at) - first) /
                                     static_cast<float>(count - 1);
  for (int i = 0; i < count; ++i) {
    const PixelLight light = light_at(u + i, v, exposure_gain);
    const float grey =
        light.camera_gain * surfaces[static_cast<std::size_t>(i)].albedo * (first + step * static_cast<float>(i));
    // Development puts the floor's light on every pixel; here it is taken out beforehand.
    albedo_[pixel(u + i, v)] = (grey - light.add) / light.gain;
  }
}

/// Where an edge runs through a pixel, each subsample looks for itself; four pixels make a packet of rays.
void Camera::draw_edges(const Exposure& exposure) {
  constexpr std::size_t together = Scene::kPacket / kSubsamples;
  const double per_focal = 1.0 / camera_.fx;
  std::array<Eye, kSubsamples> eyes;
  std::transform(exposure.site_from_camera.begin(), exposure.site_from_camera.end(), eyes.begin(),
                 [](const Pose3& pose) { return Eye(pose); });
  std::array<Eigen::Vector3f, Scene::kPacket> from;
  std::array<Eigen::Vector3f, Scene::kPacket> directions;
  std::array<BoxHit, Scene::kPacket> hits;
  for (std::size_t first = 0; first < edges_.size(); first += together) {
    const std::size_t count = std::min(together, edges_.size() - first);
    for (std::size_t i = 0; i < count * kSubsamples; ++i) {
      const std::size_t k = i % kSubsamples;
      const std::size_t at = pixel(edges_[first + i / kSubsamples].u, edges_[first + i / kSubsamples].v);
      const Eigen::Vector3f inside(rays_.x[at] + static_cast<float>(kSubsampleRight[k] * per_focal),
                                   rays_.y[at] + static_cast<float>(kSubsampleDown[k] * per_focal), 1.0F);
      from[i] = eyes[k].at.cast<float>();
      directions[i] = eyes[k].site_from_camera * inside;
    }
    const std::size_t rays = count * kSubsamples;
    scene_->cast(std::span(from).first(rays), std::span(directions).first(rays), std::span(hits).first(rays));
    for (std::size_t n = 0; n < count; ++n) {
      const auto [u, v] = edges_[first + n];
      const PixelLight light = light_at(u, v, exposure.gain);
      float& albedo = albedo_[pixel(u, v)];
      float sum = 0.0F;
      for (std::size_t k = 0; k < kSubsamples; ++k) {
        const std::size_t i = n * kSubsamples + k;
        if (hits[i].box < 0) {
          sum += albedo * light.gain + light.add;
          continue;
        }
        const Surface surface = surface_at(hits[i], eyes[k], directions[i]);
        sum += light.camera_gain * surface.albedo * light_at_wall(light_, surface.at);
      }
      albedo = (sum / kSubsamples - light.add) / light.gain;
    }
  }
}

/// Between images nothing is hit: clearing what was cast is cheaper than a whole picture.
void Camera::forget_boxes() {
  for (int v = 0; v < camera_.height; ++v) {
    for (int u = 0; u < camera_.width; u += kShadeCell) {
      if (shows(u, v) != Shows::floor) {
        std::fill_n(hits_.begin() + static_cast<std::ptrdiff_t>(pixel(u, v)), kShadeCell, BoxHit{});
      }
    }
  }
}

}  // namespace weft::agents::sim
