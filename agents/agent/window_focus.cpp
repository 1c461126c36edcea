#include "agents/agent/window_focus.hpp"

#include <chrono>

#include "agents/agent/surroundings.hpp"

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr std::uint32_t kDriftHops = 8;  ///< the window moves when the robot is farther than this from its centre
constexpr Duration kBetweenMoves = 1s;   ///< of the window
}  // namespace

bool WindowFocus::follow(const std::optional<PlaceId>& place, SteadyTime now) {
  if (!place.has_value() || *place == place_ || now - taken_at_ < kBetweenMoves) return false;
  place_ = *place;
  taken_at_ = now;
  return true;
}

std::optional<PlaceId> WindowFocus::in(const Replica& replica) const {
  if (replica.window().place(place_) != nullptr) return place_;
  return replica.definition().centre;
}

std::optional<WindowDefinition> WindowFocus::recentred(const Replica& replica, const Situation& situation) {
  const Window& window = replica.window();
  WindowDefinition definition = replica.definition();
  const bool all_fits = !definition.centre.has_value() && window.places.size() < situation.cap;
  if (!replica.is_settled() || (situation.taught.has_value() && all_fits)) return std::nullopt;
  if (situation.taught.has_value() && whole_asked_for_ != *situation.taught) {
    whole_asked_for_ = *situation.taught;
    definition.centre.reset();
    return definition;
  }
  const bool is_in_map = window.place(place_) != nullptr || situation.is_beside;
  const std::optional<PlaceId> centre = is_in_map ? std::optional(place_) : situation.durable;
  if (!centre.has_value()) return std::nullopt;
  const std::optional<PlaceId>& old = definition.centre;
  if (old.has_value() && is_near(window, *old, *centre, kDriftHops)) return std::nullopt;
  definition.centre = centre;
  return definition;
}

}  // namespace weft::agents
