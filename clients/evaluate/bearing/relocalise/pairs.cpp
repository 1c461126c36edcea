#include "clients/evaluate/bearing/relocalise/pairs.hpp"

#include <optional>
#include <vector>

namespace weft::evaluate::bearing {
namespace {

constexpr double kFarM = 2.0;

bool are_different(const Pose2& a, const Pose2& b) {
  return (a.inverse() * b).translation().norm() > kFarM;
}

}  // namespace

Result<Pairs> hold_pairs(const agents::CameraModel& camera, const TaughtAisles& taught, std::size_t count,
                         std::uint64_t seed) {
  const Result<agents::Bearing> method = agents::Bearing::make({}, camera);
  if (!method) return fail(method.error());
  std::vector<PlaceId> places;
  for (const auto& [id, pose] : taught.site_from_place) places.push_back(id);
  const auto content_of = [&](const PlaceId& id) {
    return method->decode(*taught.map.find(taught.map.view().window.place(id)->content.hash));
  };
  constexpr std::uint64_t kPairs = 78;  // stream of randomness
  Random random = Random(seed).fork(kPairs);
  Pairs pairs;
  while (pairs.tried < count) {
    const PlaceId a = places[random.below(places.size())];
    const PlaceId b = places[random.below(places.size())];
    if (!are_different(taught.site_from_place.at(a), taught.site_from_place.at(b))) continue;
    const auto first = content_of(a);
    if (!first) return fail(first.error());
    const auto second = content_of(b);
    if (!second) return fail(second.error());
    ++pairs.tried;
    const agents::BearingConfig& config = method->config();
    if (vote_heading(first->features, second->features, config.width_px, config.vote)) ++pairs.voted;
    if (method->relate(*first, *second, std::nullopt)) ++pairs.related;
  }
  return pairs;
}

}  // namespace weft::evaluate::bearing
