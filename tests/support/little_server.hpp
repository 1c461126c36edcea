#pragma once
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "agents/navigation/navigator.hpp"
#include "core/network/change.hpp"
#include "core/network/search.hpp"

namespace weft::test {

/// Does what a server does for navigation: takes what was taught and hands out the whole network as a window.
class LittleServer final : public agents::Contents {
 public:
  void take(ExperienceId experience, RobotId robot, std::string_view method, const std::vector<agents::Kept>& kept) {
    if (kept.empty()) return;
    Batch batch;
    batch.experience = experience;
    batch.sequence = ++sequence_[experience];
    batch.robot = robot;
    batch.method = std::string(method);
    for (const agents::Kept& one : kept) {
      batch.places.push_back(one.place);
      batch.edges.insert(batch.edges.end(), one.edges.begin(), one.edges.end());
      contents_[one.place.content.hash] = std::make_shared<const Bytes>(one.content);
    }
    for (const Error& error : check(snapshot_, batch)) ADD_FAILURE() << error.message;
    snapshot_ = with(snapshot_, batch);
    WindowDefinition whole;
    whole.cap = 100'000;
    window_ = make_window(snapshot_, whole);
  }

  std::shared_ptr<const Bytes> find(const ContentHash& hash) const override {
    const auto found = contents_.find(hash);
    return found == contents_.end() || missing.contains(hash) ? nullptr : found->second;
  }
  agents::MapView map() const { return {window_, *this}; }
  const Window& window() const { return window_; }
  const Snapshot& snapshot() const { return snapshot_; }

  /// Returns the shortest route, released to its end.
  Route route(const PlaceId& from, const PlaceId& to, const std::string& method) const {
    return route(from, to, std::set<std::string>{method});
  }
  Route route(const PlaceId& from, const PlaceId& to, const std::set<std::string>& methods) const {
    const Result<Path> path = shortest_path(snapshot_, from, to, methods);
    if (!path) {
      ADD_FAILURE() << path.error().message;
      return {};
    }
    Route route;
    route.id.bytes[0] = 1;
    route.places = path->places;
    route.relations = path->relations;
    route.released = static_cast<std::uint32_t>(path->places.size() - 1);
    return route;
  }

  std::set<ContentHash> missing;  ///< contents that have not arrived at the robot

 private:
  Snapshot snapshot_;
  Window window_;
  std::map<ContentHash, std::shared_ptr<const Bytes>> contents_;
  std::map<ExperienceId, std::uint64_t> sequence_;
};

}  // namespace weft::test
