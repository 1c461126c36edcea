#include <utility>

#include "agents/methods/topometric/sight.hpp"
#include "agents/methods/topometric/topometric.hpp"
#include "agents/perception/revisited_view.hpp"
#include "core/random.hpp"

namespace weft::agents {

static_assert(SimulatesRevisits<Topometric>);

OrRefusal<Revisited<TopometricContent>> Topometric::simulate_revisit(const Odometry& s, const View& view,
                                                                     const Revisit& revisit) const {
  const OrRefusal<const StereoPair*> pair = pair_to_store(s, view);
  if (!pair) return tl::unexpected(pair.error());
  Random random(revisit.seed);
  const double light = random.uniform(0.7, 1.0) * (revisit.condition == half_light ? 0.5 : 1.0);
  const StereoPair other{darker((*pair)->left, light, random.next()), darker((*pair)->right, light, random.next())};

  OrUnseen<Sight> sight =
      look_with(config_, rig(), odometry_.stereo().rectifier().rectified(other), s.level_from_robot);
  if (!sight) return tl::unexpected(Refusal{sight.error().reason, sight.error().measured, sight.error().bound});
  // This frame alone: those before it made the place, and what errs alike in both would be found again.
  CloudWindow window(config_.window, depth_noise());
  window.add({s.odometry_from_robot, std::move(sight->in_robot), rig().robot_from_camera.translation.cast<float>()});
  OrRefusal<TopometricContent> content = made_of(window, s, other);
  if (!content) return tl::unexpected(content.error());
  content->scan = std::move(sight->scan);
  return Revisited<TopometricContent>{std::move(*content), Pose2{}};
}

}  // namespace weft::agents
