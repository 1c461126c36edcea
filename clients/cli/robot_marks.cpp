#include "clients/cli/robot_marks.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "clients/cli/table.hpp"

namespace weft::cli {
namespace {

/// Reads the ends of what a robot holds: "PLACE", or "PLACE to PLACE". None: the text is of neither form.
std::optional<std::pair<PlaceId, PlaceId>> ends_of(std::string_view occupies) {
  constexpr std::string_view between = " to ";
  const std::size_t at = occupies.find(between);
  const auto from = parse_place_id(occupies.substr(0, at));
  const auto to = at == std::string_view::npos ? from : parse_place_id(occupies.substr(at + between.size()));
  if (!from || !to) return std::nullopt;
  return std::pair{*from, *to};
}

/// Returns the places of the route from the one to the other; empty when it does not lead there.
std::vector<PlaceId> part_of(const Route& route, const PlaceId& from, const PlaceId& to) {
  const auto first = std::ranges::find(route.places, from);
  const auto last = std::find(first, route.places.end(), to);
  if (last == route.places.end()) return {};
  return {first, last + 1};
}

class MarkMaker {
 public:
  MarkMaker(const Layout& layout, const std::vector<Goal>& goals, const std::vector<Route>& routes)
      : layout_(layout), goals_(goals), routes_(routes) {}

  RobotMark mark_of(const msg::RobotRow& row) const {
    RobotMark mark;
    mark.name = row.description.name;
    mark.look = look_of(row);
    mark.words = mark.name + ", " + mode_of(row);
    mark.radius_m = row.description.footprint_radius_m;
    const auto found = layout_.drawing_from_place.find(row.state.place);
    if (row.state.place && found != layout_.drawing_from_place.end())
      mark.drawing_from_robot = found->second * planar(row.state.place_from_robot);
    hold(row, mark);
    if (const Route* const route = under_way(row.description.header.sender); route != nullptr && !route->ended) {
      const std::size_t released = std::min<std::size_t>(route->released, route->places.size());
      mark.ahead.assign(route->places.begin() + static_cast<std::ptrdiff_t>(released), route->places.end());
      drop_strange(mark.ahead);
    }
    return mark;
  }

 private:
  static RobotMark::Look look_of(const msg::RobotRow& row) {
    if (!row.is_heard) return RobotMark::Look::silent;
    return row.state.localised ? RobotMark::Look::heard : RobotMark::Look::lost;
  }

  static std::string mode_of(const msg::RobotRow& row) {
    if (!row.is_heard) return "silent for " + fixed(row.silent_s, 0) + " s";
    const std::string mode = msg::to_string(row.state.mode);
    return row.state.localised || row.state.mode == msg::RobotMode::lost ? mode : mode + ", not localised";
  }

  void hold(const msg::RobotRow& row, RobotMark& mark) const {
    const auto ends = ends_of(row.occupies);
    if (!ends) return;
    const auto& [from, to] = *ends;
    if (from == to) mark.held = {from};
    const RobotId& robot = row.description.header.sender;
    if (const Route* const route = under_way(robot); mark.held.empty() && route != nullptr)
      mark.held = part_of(*route, from, to);
    for (auto route = routes_.rbegin(); route != routes_.rend() && mark.held.empty(); ++route) {
      if (route->robot == robot) mark.held = part_of(*route, from, to);
    }
    // A route that has been planned anew since is not told any more.
    mark.is_held_whole = !mark.held.empty();
    if (!mark.is_held_whole) mark.held = {from, to};
    drop_strange(mark.held);
  }

  /// Returns the route of the robot's goal that is under way; null when there is none.
  const Route* under_way(const RobotId& robot) const {
    for (const Goal& goal : goals_) {
      if (goal.robot != robot || is_terminal(goal.state)) continue;
      const auto found = std::ranges::find(routes_, goal.id, &Route::goal);
      if (found != routes_.end() && found->robot == robot) return &*found;
    }
    return nullptr;
  }

  void drop_strange(std::vector<PlaceId>& places) const {
    std::erase_if(places, [&](const PlaceId& id) { return !layout_.drawing_from_place.contains(id); });
  }

  const Layout& layout_;
  const std::vector<Goal>& goals_;
  const std::vector<Route>& routes_;
};

}  // namespace

RobotsOnMap robots_on_map(const Layout& layout, std::vector<msg::RobotRow> rows, const std::vector<Goal>& goals,
                          const std::vector<Route>& routes) {
  std::ranges::stable_sort(rows, {}, [](const msg::RobotRow& row) { return row.description.name; });
  const MarkMaker maker(layout, goals, routes);
  RobotsOnMap robots;
  for (const msg::RobotRow& row : rows) {
    RobotMark mark = maker.mark_of(row);
    if (!mark.drawing_from_robot.has_value()) {
      robots.not_drawn.push_back({mark.name, row.state.place ? "its place is not in this picture"
                                             : row.is_heard  ? "it does not know where it is"
                                                             : "it is silent and has not said where it is"});
    }
    if (mark.drawing_from_robot.has_value() || !mark.held.empty()) robots.drawn.push_back(std::move(mark));
  }
  return robots;
}

}  // namespace weft::cli
