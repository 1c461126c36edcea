#include "agents/bodies/sim/blacked_out_camera.hpp"

#include <algorithm>
#include <utility>

namespace weft::agents::sim {
namespace {

constexpr double kLightInTheDark = 1e-4;  // share of all light that is left
constexpr double kCoverGrey = 30.0;       // grey levels of what is right before a lens
constexpr std::uint64_t kNoiseOfCover = 0xC0FE2EDULL;

/// Returns an image of what is right before the lens: evenly grey, with the sensor's noise.
Image covered(const Image& like, double noise_grey, Random random) {
  auto pixels = std::make_shared<Bytes>(like.pixels->size());
  for (std::uint8_t& pixel : *pixels)
    pixel = static_cast<std::uint8_t>(std::clamp(random.normal(kCoverGrey, noise_grey) + 0.5, 0.0, 255.0));
  return {like.width, like.height, std::move(pixels)};
}

class BlackedOutCamera final : public SimulatedCamera {
 public:
  BlackedOutCamera(std::unique_ptr<SimulatedCamera> camera, const Site& site)
      : camera_(std::move(camera)), blackouts_(site.blackouts), noise_grey_(site.disturbances.noise_grey) {}

  const Sensor& sensor() const override { return camera_->sensor(); }
  void light_up(Random random) override { camera_->light_up(random); }
  std::optional<Exposure> exposed() const override { return camera_->exposed(); }
  bool expose(const Exposure& exposure) override { return camera_->expose(exposure); }

  Seen look(const Moment& moment) override {
    const Pose2& robot = moment.site_from_robot;
    const auto now = std::find_if(blackouts_.begin(), blackouts_.end(), [&](const Blackout& blackout) {
      return blackout.holds(moment.time_s, robot.x, robot.y);
    });
    const bool is_frozen = now != blackouts_.end() && now->kind == Blackout::Kind::frozen;
    if (!is_frozen || !last_) last_ = now == blackouts_.end() ? camera_->look(moment) : look_into(now->kind, moment);
    return *last_;
  }

 private:
  Seen look_into(Blackout::Kind kind, const Moment& moment) {
    Moment seen_at = moment;
    if (kind == Blackout::Kind::dark) seen_at.brightness *= kLightInTheDark;
    Seen seen = camera_->look(seen_at);
    if (kind == Blackout::Kind::covered || kind == Blackout::Kind::left_covered) cover(kind, moment.noise_seed, seen);
    return seen;
  }
  void cover(Blackout::Kind kind, std::uint64_t noise_seed, Seen& seen) const {
    Random noise(noise_seed ^ kNoiseOfCover);
    if (auto* const pair = std::get_if<StereoPair>(&seen)) {
      pair->left = covered(pair->left, noise_grey_, noise.fork(1));
      if (kind == Blackout::Kind::covered) pair->right = covered(pair->right, noise_grey_, noise.fork(2));
    } else if (auto* const image = std::get_if<Image>(&seen); image != nullptr && kind == Blackout::Kind::covered) {
      *image = covered(*image, noise_grey_, noise.fork(1));
    }
  }

  std::unique_ptr<SimulatedCamera> camera_;
  std::vector<Blackout> blackouts_;
  double noise_grey_;
  std::optional<Seen> last_;
};

}  // namespace

std::unique_ptr<SimulatedCamera> with_blackouts(std::unique_ptr<SimulatedCamera> camera, const Site& site) {
  if (site.blackouts.empty()) return camera;
  return std::make_unique<BlackedOutCamera>(std::move(camera), site);
}

}  // namespace weft::agents::sim
