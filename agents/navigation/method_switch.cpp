#include "agents/navigation/method_switch.hpp"

#include <algorithm>
#include <cmath>

#include "agents/navigation/belief.hpp"
#include "agents/navigation/route_ahead.hpp"
#include "core/network/search.hpp"

namespace weft::agents {
namespace {

constexpr std::uint32_t kHops = 12;
constexpr std::uint32_t kPlaces = 400;

/// Returns a pose to begin with for a method that needs one: how far to the side is not known, a lane's width is
/// assumed.
Relation as_pose(const Relation& relation) {
  const auto* const along = std::get_if<AlongPath>(&relation);
  if (along == nullptr) return relation;
  constexpr double aside_sigma_m = 0.15;
  Metric2 pose{laid_out(relation)};
  pose.covariance.diagonal() << along->distance_variance_m2, aside_sigma_m * aside_sigma_m,
      along->heading_variance_rad2;
  return pose;
}

}  // namespace

std::string change_between(std::string_view one, std::string_view other) {
  return std::string(std::min(one, other)) + "+" + std::string(std::max(one, other));
}

std::optional<Estimate> as_seen_by(std::string_view method, const NavigationConfig& config, const Window& window,
                                   const Estimate& known) {
  std::optional<Estimate> nearest;
  double least = config.locate.reach_m;
  for (const Reached& reached : breadth_first(window, known.place, kHops, kPlaces)) {
    if (window.place(reached.id)->method != method) continue;
    const double edges = std::sqrt(static_cast<double>(reached.depth));
    const Relation known_from_place =
        with_noise(reached.centre_from_place, edges * config.belief.map_sigma_m, edges * config.belief.map_sigma_rad);
    const Relation place_from_robot = compose(inverse(known_from_place), known.place_from_robot);
    if (norm(place_from_robot) > least) continue;
    least = norm(place_from_robot);
    nearest = Estimate{reached.id, as_pose(place_from_robot), known.blind_m};
  }
  return nearest;
}

bool agree(const NavigationConfig& config, const Window& window, const Estimate& one, const Estimate& other) {
  const auto other_from_one = between(config.belief, window, other.place, one.place, kHops);
  if (!other_from_one) return false;
  constexpr double most_m = 0.5;
  constexpr double most_rad = 0.3;
  const Relation here = compose(inverse(compose(*other_from_one, one.place_from_robot)), other.place_from_robot);
  return distance_m(here) <= most_m && std::abs(heading_rad(here)) <= most_rad;
}

std::string_view next_method(const Window& window, const Route& route, std::uint32_t at) {
  if (route.places.empty()) return {};
  const std::size_t next = std::min<std::size_t>(at + 1, route.places.size() - 1);
  const Place* const place = window.place(route.places[next]);
  return place != nullptr ? std::string_view(place->method) : std::string_view{};
}

std::optional<Edge> Joins::join(const Estimate& older, std::string_view older_method, const Place& kept) {
  if (last_ == older.place) return std::nullopt;  // one is enough for each older place
  last_ = older.place;
  Edge edge;
  edge.id = {older.place, kept.id};
  edge.a_from_b = older.place_from_robot;
  edge.origin = Origin::stitch;
  edge.method = change_between(older_method, kept.method);
  edge.drivable = can_cross(config_, older.place_from_robot) ? Drivable::both : Drivable::none;
  return edge;
}

}  // namespace weft::agents
