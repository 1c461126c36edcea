// What stands on the floor, drawn over the sampled floor: four rays only where an edge runs through a pixel.
#include <algorithm>
#include <cmath>

#include "agents/bodies/sim/camera.hpp"

namespace weft::agents::sim {
namespace {

/// Scales the brightness of a box's faces: turned to different sides they differ a little, as under any real light.
constexpr std::array<float, 5> kSide = {1.0F, 0.88F, 0.95F, 0.82F, 1.1F};

FaceLook look_of(Box::Kind kind, std::int32_t face) {
  switch (kind) {
    case Box::Kind::rack:
      return face == 4 ? FaceLook::plain : FaceLook::rack;
    case Box::Kind::wall:
      return FaceLook::wall;
    case Box::Kind::pillar:
      break;
  }
  return FaceLook::pillar;
}

}  // namespace

void Camera::paint(const BoxHit& face, const PaintPlaces& places, int count, float* out) {
  FaceJob job;
  job.look = look_of(scene_->boxes()[static_cast<std::size_t>(face.box)].kind, face.face);
  job.salt = face.box * 8 + face.face;
  job.along_m = places.along_m.data();
  job.up_m = places.up_m.data();
  job.pixel_m = places.pixel_m.data();
  job.count = count;
  job.memo = &face_memo_;
  job.out = out;
  kernels().face_row(job);
  for (int i = 0; i < count; ++i) out[i] *= kSide[static_cast<std::size_t>(face.face)];
}

Camera::Surface Camera::surface_at(const BoxHit& hit, const Viewpoint& viewpoint, const Eigen::Vector3f& direction) {
  const Eigen::Vector3d p = viewpoint.at + (direction * hit.distance).cast<double>();
  PaintPlaces places;
  places.set(0, scene_->plane_of(hit.box, hit.face, viewpoint.at).in_face(p), hit.distance / camera_.fx);
  Surface surface{0.0F, p.cast<float>()};
  paint(hit, places, 1, &surface.albedo);
  return surface;
}

bool Camera::at_edge(int u, int v) {
  // Cells within a face were not cast pixel by pixel: their corner tells.
  const auto hit_at = [this](int a, int b) -> const BoxHit& {
    return shows(a, b) == Shows::inside ? corner_hit(a, b) : hits_[pixel(a, b)];
  };
  const BoxHit& here = hits_[pixel(u, v)];
  const auto differs = [&](int a, int b) {
    const BoxHit& there = hit_at(std::clamp(a, 0, camera_.width - 1), std::clamp(b, 0, camera_.height - 1));
    return there.box != here.box || there.face != here.face;
  };
  return differs(u + 1, v) || differs(u - 1, v) || differs(u, v + 1) || differs(u, v - 1);
}

void Camera::draw_boxes(const FloorShot& shot) {
  if (shows_.empty()) return;
  edges_.clear();
  lone_.clear();
  for (int v = 0; v < camera_.height; ++v) {
    draw_insides(Viewpoint(shot.mid_of_row(v)), shot.gain, v);
    for (int u = 0; u < camera_.width; u += kShadeCell) {
      const Shows cell = shows(u, v);
      if (cell == Shows::inside || cell == Shows::floor) continue;
      for (int i = u; i < u + kShadeCell; ++i) {
        if (at_edge(i, v)) {
          edges_.push_back({i, v});
        } else if (hits_[pixel(i, v)].box >= 0) {
          lone_.push_back({i, v});
        }
      }
    }
  }
  draw_lone(shot);
  draw_edges(shot);
  forget_boxes();
}

/// Draws the cells of one row of pixels that lie within faces. Along a cell the light changes evenly.
void Camera::draw_insides(const Viewpoint& viewpoint, double exposure_gain, int v) {
  inside_.clear();
  ends_.clear();
  BoxHit face;
  FacePlane plane;
  for (int u = 0; u < camera_.width; u += kShadeCell) {
    if (shows(u, v) != Shows::inside) continue;
    inside_.push_back({u, v});
    if (const BoxHit& here = corner_hit(u, v); here.box != face.box || here.face != face.face) {
      face = here;
      plane = scene_->plane_of(face.box, face.face, viewpoint.at);
    }
    PaintPlaces places;
    for (int i = 0; i < kShadeCell; ++i) {
      const Eigen::Vector3f direction = direction_of(viewpoint, pixel(u + i, v));
      const float distance = plane.distance(direction);
      const Eigen::Vector3d p = viewpoint.at + (direction * distance).cast<double>();
      places.set(static_cast<std::size_t>(i), plane.in_face(p), distance / camera_.fx);
      if (i == 0 || i == kShadeCell - 1) ends_.add(p.cast<float>());
    }
    paint(face, places, kShadeCell, &albedo_[pixel(u, v)]);
  }
  ends_.look(light_);
  for (std::size_t n = 0; n < inside_.size(); ++n) {
    const float first = ends_.gain[2 * n];
    const float step = (ends_.gain[2 * n + 1] - first) / static_cast<float>(kShadeCell - 1);
    const CellLight light = light_in_cell(inside_[n].u, v, exposure_gain);
    float* const albedo = &albedo_[pixel(inside_[n].u, v)];
#pragma GCC unroll 1  // several at a time rather than one after the other
    for (int i = 0; i < kShadeCell; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const float lamps = first + step * static_cast<float>(i);
      // Development puts the floor's light on every pixel; here it is taken out beforehand.
      albedo[i] = (light.camera_gain[at] * albedo[i] * lamps - light.add[at]) / light.gain[at];
    }
  }
}

/// Draws pixels that show one face, in cells that are not wholly within it.
void Camera::draw_lone(const FloorShot& shot) {
  ends_.clear();
  Viewpoint viewpoint;
  int row = -1;
  for (const auto& [u, v] : lone_) {
    if (v != row) viewpoint = Viewpoint(shot.mid_of_row(v));
    row = v;
    const std::size_t at = pixel(u, v);
    const Surface surface = surface_at(hits_[at], viewpoint, direction_of(viewpoint, at));
    albedo_[at] = surface.albedo;
    ends_.add(surface.at);
  }
  ends_.look(light_);
  for (std::size_t n = 0; n < lone_.size(); ++n) {
    const auto [u, v] = lone_[n];
    const PixelLight light = light_at(u, v, shot.gain);
    float& albedo = albedo_[pixel(u, v)];
    albedo = (light.camera_gain * albedo * ends_.gain[n] - light.add) / light.gain;
  }
}

/// Draws the pixels through which an edge runs: each subsample looks for itself; four pixels make a packet of rays.
void Camera::draw_edges(const FloorShot& shot) {
  constexpr std::size_t together = Scene::kPacket / kSubsamples;
  const double per_focal = 1.0 / camera_.fx;
  std::array<std::array<Viewpoint, kSubsamples>, together> viewpoints;  // of each pixel
  std::array<Eigen::Vector3f, Scene::kPacket> from;
  std::array<Eigen::Vector3f, Scene::kPacket> directions;
  std::array<BoxHit, Scene::kPacket> hits;
  std::array<Surface, Scene::kPacket> surfaces;
  for (std::size_t first = 0; first < edges_.size(); first += together) {
    const std::size_t count = std::min(together, edges_.size() - first);
    for (std::size_t n = 0; n < count; ++n) {
      const std::array<Pose3, kSubsamples>& poses = shot.poses_of_row(edges_[first + n].v);
      std::transform(poses.begin(), poses.end(), viewpoints[n].begin(),
                     [](const Pose3& pose) { return Viewpoint(pose); });
    }
    for (std::size_t i = 0; i < count * kSubsamples; ++i) {
      const std::size_t k = i % kSubsamples;
      const std::size_t at = pixel(edges_[first + i / kSubsamples].u, edges_[first + i / kSubsamples].v);
      const Eigen::Vector3f inside(rays_.x[at] + static_cast<float>(kSubsampleRight[k] * per_focal),
                                   rays_.y[at] + static_cast<float>(kSubsampleDown[k] * per_focal), 1.0F);
      const Viewpoint& viewpoint = viewpoints[i / kSubsamples][k];
      from[i] = viewpoint.at.cast<float>();
      directions[i] = viewpoint.site_from_camera * inside;
    }
    const std::size_t rays = count * kSubsamples;
    scene_->cast(std::span(from).first(rays), std::span(directions).first(rays), std::span(hits).first(rays));
    ends_.clear();
    for (std::size_t i = 0; i < rays; ++i) {
      surfaces[i] = hits[i].box < 0
                        ? Surface{}
                        : surface_at(hits[i], viewpoints[i / kSubsamples][i % kSubsamples], directions[i]);
      ends_.add(surfaces[i].at);
    }
    ends_.look(light_);
    for (std::size_t n = 0; n < count; ++n) {
      const auto [u, v] = edges_[first + n];
      const PixelLight light = light_at(u, v, shot.gain);
      float& albedo = albedo_[pixel(u, v)];
      float sum = 0.0F;
      for (std::size_t k = 0; k < kSubsamples; ++k) {
        const std::size_t i = n * kSubsamples + k;
        if (hits[i].box < 0) {
          sum += albedo * light.gain + light.add;
          continue;
        }
        sum += light.camera_gain * surfaces[i].albedo * ends_.gain[i];
      }
      albedo = (sum / kSubsamples - light.add) / light.gain;
    }
  }
}

}  // namespace weft::agents::sim
