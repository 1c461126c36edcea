#include "clients/evaluate/taught_map.hpp"

#include <string>

#include "core/network/codec.hpp"
#include "core/network/search.hpp"

namespace weft::evaluate {

Result<void> TaughtMap::take(ExperienceId experience, RobotId robot, std::string_view method,
                             const std::vector<agents::Kept>& kept) {
  if (kept.empty()) return {};
  Batch batch;
  batch.experience = experience;
  batch.sequence = ++sequences_[experience];
  batch.robot = robot;
  batch.method = std::string(method);
  for (const agents::Kept& one : kept) {
    batch.places.push_back(one.place);
    batch.edges.insert(batch.edges.end(), one.edges.begin(), one.edges.end());
    contents_[one.place.content.hash] = std::make_shared<const Bytes>(one.content);
  }
  if (const std::vector<Error> wrong = check(snapshot_, batch); !wrong.empty()) return fail(wrong.front());
  snapshot_ = with(snapshot_, batch);
  look_at_all();
  return {};
}

bool TaughtMap::take(const agents::LearnedPlace& learned_place) {
  const Place* const place = snapshot_.place(learned_place.place);
  if (place == nullptr || place->content.hash != learned_place.made_of) return false;
  Experience learned = *snapshot_.experience(learned_place.place.experience);
  std::vector<Place> places(learned.places.begin(), learned.places.end());
  for (Place& one : places) {
    if (one.id != learned_place.place) continue;
    ++one.entity_version;
    one.content_format = learned_place.content_format;
    one.content = {hash_bytes(learned_place.content), learned_place.content.size()};
    contents_[one.content.hash] = std::make_shared<const Bytes>(learned_place.content);
  }
  learned.places = SharedRow<Place>(std::move(places));
  Snapshot::Experiences experiences = snapshot_.experiences();
  experiences[learned_place.place.experience] = std::make_shared<const Experience>(std::move(learned));
  snapshot_ = Snapshot(Revision{snapshot_.revision().value + 1}, std::move(experiences), snapshot_.shared_labels(),
                       snapshot_.shared_aparts(), snapshot_.shared_rules(), snapshot_.shared_registrations());
  look_at_all();
  return true;
}

void TaughtMap::look_at_all() {
  WindowDefinition whole;
  whole.cap = 100'000;
  window_ = make_window(snapshot_, whole);
}

std::shared_ptr<const Bytes> TaughtMap::find(const ContentHash& hash) const {
  const auto found = contents_.find(hash);
  return found == contents_.end() ? nullptr : found->second;
}

Result<Route> TaughtMap::route(const PlaceId& from, const PlaceId& to, std::string_view method) const {
  const Result<Path> path = shortest_path(snapshot_, from, to, {std::string(method)});
  if (!path) return fail(path.error());
  Route route;
  route.id.bytes[0] = 1;
  route.places = path->places;
  route.relations = path->relations;
  route.released = static_cast<std::uint32_t>(path->places.size() - 1);
  return route;
}

}  // namespace weft::evaluate
