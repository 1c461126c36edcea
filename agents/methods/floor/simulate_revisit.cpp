#include <algorithm>
#include <cmath>
#include <utility>

#include "agents/methods/floor/floor.hpp"
#include "agents/methods/image_of.hpp"
#include "agents/perception/revisited_view.hpp"
#include "core/random.hpp"

namespace weft::agents {

OrRefusal<View> Floor::simulate_view(const View& view, const Revisit& revisit) const {
  const OrRefusal<const Image*> image = image_of(view, camera_);
  if (!image) return tl::unexpected(image.error());
  Random random(revisit.seed);
  OtherLook look;
  look.robot_from_other = revisit.robot_from_other;
  const FloorConfig others;  // this robot's camera may be better known than theirs
  const double tilt_rad = std::max(config_.mount_tilt_rad, others.mount_tilt_rad);
  const double height_m = std::max(config_.mount_height_m, others.mount_height_m);
  look.attitude = {random.normal(0.0, tilt_rad), random.normal(0.0, tilt_rad),
                   random.normal(0.0, std::hypot(height_m, config_.load_m))};
  // Lamps age, windows and the camera's exposure drift: another day is a little darker, if it is not brighter.
  look.light = random.uniform(0.7, 1.0) * (revisit.condition == half_light ? 0.5 : 1.0);
  if (revisit.condition == worn) look.wear = FloorWear{.far_m = config_.far_m};
  look.seed = random.next();
  View other = view;
  other.data = revisited_view(**image, camera_, look);
  return other;
}

OrRefusal<Revisited<FloorContent>> Floor::simulate_revisit(const Odometry& odometry, const View& view,
                                                           const Revisit& revisit) const {
  const OrRefusal<View> other = simulate_view(view, revisit);
  if (!other) return tl::unexpected(other.error());
  OrRefusal<FloorContent> content = extract(odometry, *other);
  if (!content) return tl::unexpected(content.error());
  return Revisited<FloorContent>{std::move(*content), revisit.robot_from_other};
}

}  // namespace weft::agents
