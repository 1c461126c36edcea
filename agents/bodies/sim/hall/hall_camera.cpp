#include "agents/bodies/sim/hall/hall_camera.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

#include "agents/bodies/sim/hall/movers.hpp"
#include "agents/bodies/sim/pixel_rays.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {
namespace {

constexpr int kBlock = kHallBand;  // pixels a side that one packet looks through
static_assert(kBlock * kBlock == kRays);
constexpr std::size_t kNoise = 1U << 18U;
// Places within the pixel, each at its own moment: orthogonal to time and to each other.
constexpr std::array<float, kHallSamples> kRight = {0.25F, -0.25F, -0.25F, 0.25F};
constexpr std::array<float, kHallSamples> kDown = {-0.125F, 0.375F, -0.375F, 0.125F};

/// Finds the pixel of the i-th ray of a block.
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
      off_axis2_.push_back(ray_x_.back() * ray_x_.back() + ray_y_.back() * ray_y_.back());
      length_.push_back(std::sqrt(1.0F + off_axis2_.back()));
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

std::vector<ShadedFace> HallCamera::faces_of(const std::vector<Quad>& quads,
                                             const std::vector<QuadLight>& light) const {
  std::vector<ShadedFace> faces;
  faces.reserve(quads.size());
  for (std::size_t i = 0; i < quads.size(); ++i) {
    faces.push_back(hall_->textures().of(quads[i]));
    std::copy(light[i].at.begin(), light[i].at.end(), faces.back().light);
  }
  return faces;
}

/// Adds what the rays of `which` (a bit each) see of what they meet; face by face, eight rays at once.
void HallCamera::shade(const std::vector<ShadedFace>& faces, const RayPacket& rays, std::size_t from,
                       std::uint32_t which) {
  std::array<float, kShaded> grey{};
  for (std::size_t half = 0; half < kRays; half += kShaded) {
    std::uint32_t left = which >> half & ((1U << kShaded) - 1U);
    while (left != 0) {
      const std::int32_t quad = rays.quad[half + static_cast<std::size_t>(std::countr_zero(left))];
      shade_face_({rays.x.data() + half, rays.y.data() + half, rays.z.data() + half, rays.u.data() + half,
                   rays.v.data() + half, rays.distance.data() + half, length_.data() + from + half,
                   off_axis2_.data() + from + half, 0.5F / static_cast<float>(camera_.fx),
                   static_cast<float>(options_.headlight), &faces[static_cast<std::size_t>(quad)], grey.data()});
      for (std::size_t i = 0; i < kShaded; ++i) {
        if ((left >> i & 1U) == 0 || rays.quad[half + i] != quad) continue;
        seen_[from + half + i] += grey[i];
        left &= ~(1U << i);
      }
    }
  }
}

std::array<HallCamera::Sample, kHallSamples> HallCamera::samples_from(
    const std::array<Pose3, kHallSamples>& site_from_camera) const {
  std::array<Sample, kHallSamples> samples;
  for (std::size_t k = 0; k < kHallSamples; ++k) {
    samples[k] = {site_from_camera[k].translation.cast<float>(),
                  site_from_camera[k].rotation.toRotationMatrix().cast<float>(),
                  kRight[k] / static_cast<float>(camera_.fx), kDown[k] / static_cast<float>(camera_.fy)};
  }
  return samples;
}

void HallCamera::look(const HallShot& shot, const Moving& moving) {
  std::array<Sample, kHallSamples> samples = samples_from(shot.site_from_camera);
  std::fill(seen_.begin(), seen_.end(), 0.0F);
  const auto blocks_across = static_cast<std::size_t>(camera_.width / kBlock);
  // Block by block: what its four looks need is at hand.
  for (std::size_t block = 0; block < ray_x_.size() / kRays; ++block) {
    if (!shot.bands.empty() && block % blocks_across == 0) samples = samples_from(shot.bands[block / blocks_across]);
    for (const Sample& sample : samples) look_through(block * kRays, sample, moving);
  }
}

void HallCamera::look_through(std::size_t from, const Sample& sample, const Moving& moving) {
  RayPacket rays;
  std::array<float, kRays> x{};
  std::array<float, kRays> y{};
  std::copy_n(ray_x_.data() + from, kRays, x.data());
  std::copy_n(ray_y_.data() + from, kRays, y.data());
  const Eigen::Matrix3f& turn = sample.site_from_camera;
  for (std::size_t i = 0; i < kRays; ++i) {
    rays.x[i] = turn(0, 0) * (x[i] + sample.right) + turn(0, 1) * (y[i] + sample.down) + turn(0, 2);
    rays.y[i] = turn(1, 0) * (x[i] + sample.right) + turn(1, 1) * (y[i] + sample.down) + turn(1, 2);
    rays.z[i] = turn(2, 0) * (x[i] + sample.right) + turn(2, 1) * (y[i] + sample.down) + turn(2, 2);
  }
  hall_->scene().cast(sample.eye, rays);
  constexpr std::size_t middle = 5;
  const bool may_move =
      moving.may_be_met(sample.eye, {rays.x[middle], rays.y[middle], rays.z[middle]}, static_cast<float>(camera_.fx));
  RayPacket to_moving;
  if (may_move) {
    to_moving = rays;
    moving.scene.cast(sample.eye, to_moving);
  }
  std::uint32_t still = 0;
  std::uint32_t moves = 0;
  for (std::size_t i = 0; i < kRays; ++i) {
    const bool is_before =
        may_move && to_moving.quad[i] >= 0 && (rays.quad[i] < 0 || to_moving.distance[i] < rays.distance[i]);
    (is_before ? moves : still) |= static_cast<std::uint32_t>(is_before || rays.quad[i] >= 0) << i;
  }
  shade(faces_, rays, from, still);
  if (moves != 0) shade(moving.faces, to_moving, from, moves);
}

/// Returns whether rays of a block about this one may meet something that moves.
bool HallCamera::Moving::may_be_met(const Eigen::Vector3f& eye, const Eigen::Vector3f& way, float focal_px) const {
  constexpr float block_px = 4.0F;  // from its middle ray to its corners, and a little
  const float length2 = way.squaredNorm();
  return std::any_of(around.begin(), around.end(), [&](const Sphere& sphere) {
    const Eigen::Vector3f to_middle = sphere.middle - eye;
    const float along = to_middle.dot(way);
    const float reach = sphere.radius_m + block_px / focal_px * to_middle.norm();
    const float aside2 = to_middle.squaredNorm() - along * std::abs(along) / length2;
    return aside2 < reach * reach;
  });
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
  std::vector<Moving::Sphere> around;
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    const std::size_t first = quads.size();
    add_mover(movers_[i], static_cast<std::uint32_t>(i + 1), shot.time_s, quads);
    around.push_back(Moving::around_of(std::span(quads).subspan(first)));
  }
  look(shot, {faces_of(quads, light_.on(quads, nullptr)), QuadScene(quads), around});
  return develop(shot);
}

HallCamera::Moving::Sphere HallCamera::Moving::around_of(std::span<const Quad> quads) {
  Sphere sphere;
  for (const Quad& quad : quads) sphere.middle += quad.at(0.5F, 0.5F) / static_cast<float>(quads.size());
  for (const Quad& quad : quads)
    for (const float u : {0.0F, 1.0F})
      for (const float v : {0.0F, 1.0F})
        sphere.radius_m = std::max(sphere.radius_m, (quad.at(u, v) - sphere.middle).norm());
  return sphere;
}

}  // namespace weft::agents::sim
