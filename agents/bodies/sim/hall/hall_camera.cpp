#include "agents/bodies/sim/hall/hall_camera.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "agents/bodies/sim/hall/movers.hpp"
#include "agents/bodies/sim/hall/obstacles.hpp"
#include "agents/perception/lens.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {
namespace {

constexpr std::size_t kNoise = 1U << 18U;

}  // namespace

HallCamera::HallCamera(const CameraModel& camera, const HallCameraOptions& options, std::shared_ptr<const Hall> hall,
                       Comings comings, const HallLight& light)
    : camera_(camera),
      options_(options),
      hall_(std::move(hall)),
      comings_(std::move(comings)),
      light_(light),
      rays_(camera, options.vignetting, options.widest_rad),
      carried_(rays_, camera, options.carried),
      bloom_(static_cast<std::size_t>(camera.width / kHallBand), static_cast<std::size_t>(camera.height / kHallBand),
             options.bloom) {
  seen_.resize(rays_.length.size());
  for (std::size_t block = 0; block < seen_.size() / kRays; ++block) is_dark_.push_back(sees_nothing(block));
  Random random(0x68616c6cULL);
  for (std::size_t i = 0; i < kNoise + static_cast<std::size_t>(camera_.width); ++i)
    noise_.push_back(static_cast<float>(random.normal()));
  set_light(light);
}

/// Returns whether no light comes through a block of pixels: beyond the lens's circle, or behind what is carried.
bool HallCamera::sees_nothing(std::size_t block) const {
  for (std::size_t from = block * kRays; from < (block + 1) * kRays; ++from) {
    const bool is_covered = !carried_.cover.empty() && carried_.cover[from] >= 1.0F;
    if (rays_.vignette[from] > 0.0F && !is_covered) return false;
  }
  return true;
}

void HallCamera::set_light(const HallLight& light) {
  light_ = light;
  still_light_ = UnsteadyLight(light_, hall_->quads(), &hall_->scene());
  faces_ = faces_of(hall_->quads(), still_light_.at(0.0));
}

/// Lights what stands still as it is lit at a time, s, by lamps that flicker or end.
void HallCamera::relight(double time_s) {
  if (still_light_.is_steady()) return;
  const std::vector<QuadLight> light = still_light_.at(time_s);
  for (std::size_t i = 0; i < faces_.size(); ++i) std::copy(light[i].at.begin(), light[i].at.end(), faces_[i].light);
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
  // A pixel of a pinhole camera covers as much of a plane across its axis anywhere; one of a fisheye as much of a
  // sphere.
  const bool is_fisheye = camera_.lens == LensModel::equidistant;
  for (std::size_t half = 0; half < kRays; half += kShaded) {
    std::uint32_t left = which >> half & ((1U << kShaded) - 1U);
    while (left != 0) {
      const std::int32_t quad = rays.quad[half + static_cast<std::size_t>(std::countr_zero(left))];
      shade_face_({rays.x.data() + half, rays.y.data() + half, rays.z.data() + half, rays.u.data() + half,
                   rays.v.data() + half, rays.distance.data() + half, rays_.length.data() + from + half,
                   rays_.off_axis2.data() + from + half, 0.5F / static_cast<float>(camera_.fx),
                   static_cast<float>(options_.headlight), &faces[static_cast<std::size_t>(quad)], grey.data(),
                   is_fisheye ? rays_.length.data() + from + half : nullptr});
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
                  site_from_camera[k].rotation.toRotationMatrix().cast<float>(), k};
  }
  return samples;
}

void HallCamera::look(const HallShot& shot, const Moving& moving) {
  std::array<Sample, kHallSamples> samples = samples_from(shot.site_from_camera);
  std::fill(seen_.begin(), seen_.end(), 0.0F);
  const auto blocks_across = static_cast<std::size_t>(camera_.width / kHallBand);
  // Block by block: what its four looks need is at hand.
  for (std::size_t block = 0; block < seen_.size() / kRays; ++block) {
    if (!shot.bands.empty() && block % blocks_across == 0) samples = samples_from(shot.bands[block / blocks_across]);
    if (is_dark_[block]) continue;
    for (const Sample& sample : samples) look_through(block * kRays, sample, moving);
  }
}

void HallCamera::look_through(std::size_t from, const Sample& sample, const Moving& moving) {
  RayPacket rays;
  const float* const x = rays_.x[sample.look].data() + from;
  const float* const y = rays_.y[sample.look].data() + from;
  const Eigen::Matrix3f& turn = sample.site_from_camera;
  for (std::size_t i = 0; i < kRays; ++i) {
    rays.x[i] = turn(0, 0) * x[i] + turn(0, 1) * y[i] + turn(0, 2);
    rays.y[i] = turn(1, 0) * x[i] + turn(1, 1) * y[i] + turn(1, 2);
    rays.z[i] = turn(2, 0) * x[i] + turn(2, 1) * y[i] + turn(2, 2);
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

/// Turns what the looks through each pixel saw into the light that arrives there; returns its mean.
double HallCamera::gather_light(const HallShot& shot) {
  double sum = 0.0;
  for (std::size_t from = 0; from < seen_.size(); ++from) {
    seen_[from] = seen_[from] * (1.0F / kHallSamples) * rays_.vignette[from];
    sum += static_cast<double>(seen_[from]);
  }
  if (!carried_.cover.empty()) {
    Quad here;  // level, at the camera
    here.corner = shot.site_from_camera.front().translation.cast<float>();
    here.up = Eigen::Vector3f::UnitY();
    const float light = light_.at_time(shot.time_s).on(std::vector{here}, nullptr).front().at.front();
    for (std::size_t from = 0; from < seen_.size(); ++from)
      seen_[from] += rays_.vignette[from] * light * carried_.grey[from] - carried_.cover[from] * seen_[from];
  }
  bloom_.scatter(seen_);
  return sum / static_cast<double>(seen_.size());
}

HallImage HallCamera::develop(const HallShot& shot) {
  HallImage image;
  image.mean_light = gather_light(shot);
  image.grey.resize(seen_.size());
  const BlockPixels pixels{camera_.width};
  const auto gain = static_cast<float>(shot.gain);
  const auto noise_grey = static_cast<float>(shot.noise_grey);
  Random random(shot.noise_seed);
  std::uint64_t sum = 0;
  for (std::size_t block = 0; block < seen_.size() / kRays; ++block) {
    const float* const noise = noise_.data() + random.below(kNoise);
    for (std::size_t i = 0; i < kRays; ++i) {
      const float light = seen_[block * kRays + i];
      const float grey = std::clamp(gain * light + noise_grey * noise[i] + 0.5F, 0.0F, 255.0F);
      const auto pixel = static_cast<std::uint8_t>(grey);
      image.grey[pixels.at(block, i)] = pixel;
      sum += pixel;
    }
  }
  image.mean_grey = static_cast<double>(sum) / static_cast<double>(seen_.size());
  return image;
}

double HallCamera::distance_m(const Pose3& site_from_camera, int column, int row) const {
  const Eigen::Vector2d ray = normalised_from_pixel(camera_, {column, row});
  const Eigen::Vector3d way = site_from_camera.rotation * Eigen::Vector3d(ray.x(), ray.y(), 1.0).normalized();
  return static_cast<double>(
      hall_->scene().distance_m(site_from_camera.translation.cast<float>(), way.cast<float>()));
}

/// Sets up what moves, or stands there for a while, as it is when an image is taken.
HallCamera::Moving HallCamera::moving_at(const HallShot& shot) const {
  constexpr std::uint32_t first_obstacle = 1000;  // beyond all movers
  std::vector<Quad> quads;
  std::vector<Moving::Sphere> around;
  const auto add = [&](const auto& draw) {
    const std::size_t first = quads.size();
    draw();
    around.push_back(Moving::around_of(std::span(quads).subspan(first)));
  };
  for (std::size_t i = 0; i < comings_.movers.size(); ++i) {
    const double waited_s = shot.waited_s.empty() ? 0.0 : shot.waited_s[i];
    const double at_s = std::max(0.0, shot.time_s - waited_s);
    add([&] { add_mover(comings_.movers[i], static_cast<std::uint32_t>(i + 1), at_s, quads); });
  }
  for (std::size_t i = 0; i < comings_.obstacles.size(); ++i) {
    const Obstacle& obstacle = comings_.obstacles[i];
    if (!obstacle.stands_at(shot.time_s)) continue;
    add([&] { add_obstacle(obstacle, first_obstacle + static_cast<std::uint32_t>(i), quads); });
  }
  return {faces_of(quads, light_.at_time(shot.time_s).on(quads, nullptr)), QuadScene(quads), around};
}

HallImage HallCamera::take(const HallShot& shot) {
  relight(shot.time_s);
  look(shot, moving_at(shot));
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
