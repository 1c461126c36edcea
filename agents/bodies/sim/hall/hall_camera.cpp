#include "agents/bodies/sim/hall/hall_camera.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "agents/bodies/sim/hall/movers.hpp"
#include "agents/bodies/sim/pixel_rays.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {
namespace {

constexpr int kBlock = 4;  // pixels a side that one packet looks through
static_assert(kBlock * kBlock == kRays);
constexpr std::size_t kNoise = 1U << 18U;
// Places within the pixel, each at its own moment: orthogonal to time and to each other.
constexpr std::array<float, kHallSamples> kRight = {0.25F, -0.25F, -0.25F, 0.25F};
constexpr std::array<float, kHallSamples> kDown = {-0.125F, 0.375F, -0.375F, 0.125F};

/// Pixel of the i-th ray of a block.
struct BlockPixels {
  int columns;
  std::size_t at(std::size_t block, std::size_t i) const {
    const auto across = static_cast<std::size_t>(columns / kBlock);
    const std::size_t row = block / across * kBlock + i / kBlock;
    return row * static_cast<std::size_t>(columns) + block % across * kBlock + i % kBlock;
  }
};

}  // namespace

HallCamera::HallCamera(const CameraModel& camera, const HallCameraOptions& options, std::shared_ptr<const Hall> hall,
                       std::vector<Mover> movers, const HallLight& light)
    : camera_(camera), options_(options), hall_(std::move(hall)), movers_(std::move(movers)), light_(light) {
  assert(camera_.width % kBlock == 0 && camera_.height % kBlock == 0);
  const PixelRays rays(camera_);
  const BlockPixels pixels{camera_.width};
  const double corner = std::hypot(camera_.width / 2.0, camera_.height / 2.0);
  for (std::size_t block = 0; block < rays.x.size() / kRays; ++block) {
    for (std::size_t i = 0; i < kRays; ++i) {
      const std::size_t pixel = pixels.at(block, i);
      ray_x_.push_back(rays.x[pixel]);
      ray_y_.push_back(rays.y[pixel]);
      const auto width = static_cast<std::size_t>(camera_.width);
      const std::size_t row = pixel / width;
      const double r =
          std::hypot(static_cast<double>(pixel - row * width) - camera_.cx, static_cast<double>(row) - camera_.cy) /
          corner;
      vignette_.push_back(static_cast<float>(1.0 - options_.vignetting * r * r));
    }
  }
  seen_.resize(ray_x_.size());
  Random random(0x68616c6cULL);
  for (std::size_t i = 0; i < kNoise + static_cast<std::size_t>(camera_.width); ++i)
    noise_.push_back(static_cast<float>(random.normal()));
  set_light(light);
}

void HallCamera::set_light(const HallLight& light) {
  light_ = light;
  faces_ = faces_of(hall_->quads(), light_.on(hall_->quads(), &hall_->scene()));
}

std::vector<HallCamera::Face> HallCamera::faces_of(const std::vector<Quad>& quads,
                                                   const std::vector<QuadLight>& light) {
  std::vector<Face> faces;
  faces.reserve(quads.size());
  for (std::size_t i = 0; i < quads.size(); ++i)
    faces.push_back({&quads[i], quads[i].across.norm(), quads[i].up.norm(), quads[i].normal(), light[i]});
  return faces;
}

float HallCamera::seen(const Face& face, const RayPacket& rays, std::size_t i, float off_axis2) const {
  const Eigen::Vector3f way(rays.x[i], rays.y[i], rays.z[i]);
  const float length = way.norm();
  const float facing = std::abs(face.normal.dot(way)) / length;
  const float distance_m = rays.distance[i] * length;
  // Four rays share a pixel; at a slant it covers more.
  const float pixel_m = 0.5F * rays.distance[i] / static_cast<float>(camera_.fx) / std::sqrt(std::max(0.1F, facing));
  const Quad& quad = *face.quad;
  const float texel = hall_->textures().at(quad, face.across_m, face.up_m, rays.u[i], rays.v[i], pixel_m);
  float light = face.light.between(rays.u[i], rays.v[i]);
  if (options_.headlight > 0.0) {
    const float beam = 1.0F / (1.0F + off_axis2 / 0.12F);
    light += static_cast<float>(options_.headlight) * facing * beam * beam * 4.0F /
             std::max(0.25F, distance_m * distance_m);
  }
  return quad.grey * (1.0F / 128.0F) * texel * light;
}

void HallCamera::look(const HallShot& shot, const std::vector<Face>& moving, const QuadScene& scene) {
  RayPacket rays;
  RayPacket to_moving;
  for (std::size_t k = 0; k < kHallSamples; ++k) {
    const Eigen::Matrix3f turn = shot.site_from_camera[k].rotation.toRotationMatrix().cast<float>();
    const Eigen::Vector3f eye = shot.site_from_camera[k].translation.cast<float>();
    const float right = kRight[k] / static_cast<float>(camera_.fx);
    const float down = kDown[k] / static_cast<float>(camera_.fy);
    for (std::size_t from = 0; from < ray_x_.size(); from += kRays) {
      for (std::size_t i = 0; i < kRays; ++i) {
        const float x = ray_x_[from + i] + right;
        const float y = ray_y_[from + i] + down;
        rays.x[i] = turn(0, 0) * x + turn(0, 1) * y + turn(0, 2);
        rays.y[i] = turn(1, 0) * x + turn(1, 1) * y + turn(1, 2);
        rays.z[i] = turn(2, 0) * x + turn(2, 1) * y + turn(2, 2);
      }
      hall_->scene().cast(eye, rays);
      if (!moving.empty()) {
        to_moving.x = rays.x;
        to_moving.y = rays.y;
        to_moving.z = rays.z;
        scene.cast(eye, to_moving);
      }
      for (std::size_t i = 0; i < kRays; ++i) {
        const float x = ray_x_[from + i];
        const float y = ray_y_[from + i];
        const float off_axis2 = x * x + y * y;
        const bool is_moving = !moving.empty() && to_moving.quad[i] >= 0 &&
                               (rays.quad[i] < 0 || to_moving.distance[i] < rays.distance[i]);
        float light = 0.0F;
        if (is_moving) {
          light = seen(moving[static_cast<std::size_t>(to_moving.quad[i])], to_moving, i, off_axis2);
        } else if (rays.quad[i] >= 0) {
          light = seen(faces_[static_cast<std::size_t>(rays.quad[i])], rays, i, off_axis2);
        }
        seen_[from + i] = k == 0 ? light : seen_[from + i] + light;
      }
    }
  }
}

HallImage HallCamera::develop(const HallShot& shot) const {
  HallImage image;
  image.grey.resize(seen_.size());
  const BlockPixels pixels{camera_.width};
  const auto gain = static_cast<float>(shot.gain);
  const auto noise_grey = static_cast<float>(shot.noise_grey);
  Random random(shot.noise_seed);
  double sum = 0.0;
  for (std::size_t block = 0; block < seen_.size() / kRays; ++block) {
    const float* const noise = noise_.data() + random.below(kNoise);
    for (std::size_t i = 0; i < kRays; ++i) {
      const std::size_t from = block * kRays + i;
      const float light = seen_[from] * (1.0F / kHallSamples) * vignette_[from];
      sum += static_cast<double>(light);
      const float grey = std::clamp(gain * light + noise_grey * noise[i] + 0.5F, 0.0F, 255.0F);
      image.grey[pixels.at(block, i)] = static_cast<std::uint8_t>(grey);
    }
  }
  image.mean_light = sum / static_cast<double>(seen_.size());
  return image;
}

HallImage HallCamera::take(const HallShot& shot) {
  std::vector<Quad> quads;
  add_movers(movers_, shot.time_s, quads);
  const QuadScene scene(quads);
  look(shot, faces_of(quads, light_.on(quads, nullptr)), scene);
  return develop(shot);
}

}  // namespace weft::agents::sim
