#include "clients/evaluate/taught_map.hpp"

#include <string>

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
  WindowDefinition whole;
  whole.cap = 100'000;
  window_ = make_window(snapshot_, whole);
  return {};
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
