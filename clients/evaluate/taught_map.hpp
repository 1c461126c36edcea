#pragma once
#include <map>
#include <memory>
#include <string_view>
#include <vector>

#include "agents/navigation/navigator.hpp"
#include "core/network/change.hpp"
#include "core/network/window.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

/// Does what the server does for navigation, without wire and store: takes in what was taught, checked as intake
/// checks it, hands out the whole network as a window, plans routes on it.
class TaughtMap final : public agents::Contents {
 public:
  /// Takes in a batch. internal: one that the server would refuse.
  Result<void> take(ExperienceId experience, RobotId robot, std::string_view method,
                    const std::vector<agents::Kept>& kept);

  /// Replaces the place's content if it is still the one that this was learned upon; returns whether it was.
  bool take(const agents::LearnedPlace& learned_place);

  std::shared_ptr<const Bytes> find(const ContentHash& hash) const override;
  agents::MapView view() const { return {window_, *this}; }
  const Snapshot& snapshot() const { return snapshot_; }

  /// Returns the shortest route, released to its end. Errors of shortest_path.
  Result<Route> route(const PlaceId& from, const PlaceId& to, std::string_view method) const;

 private:
  void look_at_all();

  Snapshot snapshot_;
  Window window_;
  std::map<ContentHash, std::shared_ptr<const Bytes>> contents_;
  std::map<ExperienceId, std::uint64_t> sequences_;
};

}  // namespace weft::evaluate
