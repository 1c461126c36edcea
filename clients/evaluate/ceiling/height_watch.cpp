#include "clients/evaluate/ceiling/height_watch.hpp"

#include <limits>
#include <optional>

#include "agents/methods/ceiling/height.hpp"

namespace weft::evaluate::ceiling {

using namespace agents;

void HeightWatch::look(std::size_t sample, const Ceiling::Odometry& odometry) {
  if (odometry.seen_by != Ceiling::SeenBy::corners) travelled_m_.clear();  // none of them is followed any more
  if (!odometry.ended) return;
  std::map<InView, double> on;
  const double moved_m = odometry.ended->a_from_b.translation().norm();
  for (const PlanePair& point : odometry.ended->points) {
    const auto before = travelled_m_.find(key_of(point.in_a));
    on[key_of(point.in_b)] = moved_m + (before == travelled_m_.end() ? 0.0 : before->second);
  }
  travelled_m_ = std::move(on);
  const std::optional<CeilingScale> scale = method_.scale(odometry);
  if (!scale) return;
  const double camera_m = method_.camera().robot_from_camera.translation.z();
  const HeightPrior prior = height_prior(method_.config(), scale->ceiling_m, camera_m);
  for (const Ceiling::Tracked& track : odometry.tracks) {
    const auto travelled = travelled_m_.find(key_of(track.in_keyframe));
    if (travelled == travelled_m_.end() || travelled->second < from_m_) continue;
    const std::optional<Height> height = height_of(prior, together(track.told, track.tells));
    if (!height) continue;
    seen_.push_back({sample, track.in_keyframe, *height});
    travelled->second = -std::numeric_limits<double>::infinity();
  }
}

}  // namespace weft::evaluate::ceiling
