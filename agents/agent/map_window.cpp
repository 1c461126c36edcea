#include "agents/agent/map_window.hpp"

#include <algorithm>
#include <utility>

#include "agents/agent/surroundings.hpp"

namespace weft::agents {
namespace {

WindowDefinition everything(const WindowSize& size) {
  return {.centre = std::nullopt, .hops = size.hops, .cap = size.cap, .route = {}};
}

/// Returns the place around which the robot needs the map. One that is being taught lies beside the map before
/// anything joins it to that.
std::optional<PlaceId> around(const Navigator& navigator) {
  if (const std::optional<PlaceId> beside = navigator.beside()) return beside;
  const std::optional<Estimate> estimate = navigator.estimate();
  return estimate ? std::optional(estimate->place) : std::nullopt;
}

}  // namespace

MapWindow::MapWindow(const Limits& limits, std::uint64_t first_id, SteadyTime now)
    : cap_(limits.size.cap),
      replica_(everything(limits.size), first_id, now),
      cache_(limits.cache_bytes, limits.bytes_per_second),
      proposals_(limits.size) {}

std::string MapWindow::on_patch(const msg::WindowPatch& patch, const MapContext& context, bool goes_elsewhere,
                                SteadyTime now) {
  if (replica_.on_patch(patch, now) != Replica::Heard::changed) return {};
  std::string note;
  if (context.taught.has_value() || goes_elsewhere) {
    reanchoring_.reset();
  } else {
    note = keep_anchor(context, now);
  }
  want_contents(context, now);
  return note;
}

std::string MapWindow::keep_anchor(const MapContext& context, SteadyTime now) {
  std::optional<Reanchoring::Step> step = reanchoring_.on_change(replica_, context.navigator);
  if (!step.has_value()) return {};
  if (step->is_over) step->definition.route = proposals_.always_held(context.route);
  replica_.define(std::move(step->definition), now);
  return std::move(step->note);
}

void MapWindow::server_restarted(SteadyTime now) {
  replica_.server_restarted(now);
  cache_.server_restarted(now);
}

SteadyTime MapWindow::next() const {
  return std::min(replica_.next(), cache_.next().value_or(replica_.next()));
}

void MapWindow::hold_route(const MapContext& context, SteadyTime now) {
  WindowDefinition definition = replica_.definition();
  definition.route = proposals_.always_held(context.route);
  replica_.define(std::move(definition), now);
}

void MapWindow::leave_proposals(const std::optional<PlaceId>& seed, const MapContext& context, SteadyTime now) {
  proposals_.forget();
  WindowDefinition definition = proposals_.usual(replica_.definition(), context.route);
  proposals_.leave_alone();
  if (seed.has_value()) definition.centre = seed;
  replica_.define(std::move(definition), now);
}

void MapWindow::look_anywhere(SteadyTime now) {
  WindowDefinition definition = replica_.definition();
  if (window().places.empty()) definition.centre.reset();
  replica_.define(std::move(definition), now);
}

void MapWindow::look_at(std::vector<PlaceId> proposed, const MapContext& context, SteadyTime now) {
  proposals_.set(std::move(proposed));
  define_for_proposed(context, now);
}

void MapWindow::define_for_proposed(const MapContext& context, SteadyTime now) {
  const Proposals::Held held{
      .places = window().places.size(),
      .knows_something = context.navigator.estimate().has_value() || context.taught.has_value()};
  replica_.define(proposals_.wanted(replica_.definition(), context.route, held), now);
  want_contents(context, now);
}

void MapWindow::follow_search(bool has_fix, const MapContext& context, SteadyTime now) {
  if (has_fix && !proposals_.empty()) {
    proposals_.suspect(std::nullopt);
    proposals_.forget();
    WindowDefinition definition = proposals_.usual(replica_.definition(), context.route);
    if (proposals_.is_alone()) {
      if (const std::optional<Estimate> found = context.navigator.estimate()) definition.centre = found->place;
    }
    proposals_.leave_alone();
    return replica_.define(std::move(definition), now);
  }
  const std::optional<PlaceId> suspected = context.navigator.suspected();
  const bool is_another = proposals_.suspect(suspected);
  if (is_another && suspected.has_value() && !proposals_.empty()) define_for_proposed(context, now);
}

void MapWindow::recentre(const std::optional<PlaceId>& durable, const MapContext& context, SteadyTime now) {
  const bool is_beside = context.navigator.beside().has_value();
  // The window is asked for until it has what the run lies beside: there may be no other stitch before.
  const bool has_moved = focus_.follow(around(context.navigator), now);
  if (!has_moved && !is_beside) return;
  if (has_moved && cache_.missing() > 0) want_contents(context, now);
  const WindowFocus::Situation situation{
      .cap = cap_, .taught = context.taught, .is_beside = is_beside, .durable = durable};
  if (std::optional<WindowDefinition> definition = focus_.recentred(replica_, situation)) {
    replica_.define(std::move(*definition), now);
  }
}

void MapWindow::want_contents(const MapContext& context, SteadyTime now) {
  const std::vector<std::string> methods = context.navigator.teaches();
  std::vector<ContentRef> contents = nearest_first(window(), methods, focus_.in(replica_), context.route, 0);
  cache_.want(proposals_.put_first(std::move(contents), window()), now);
}

}  // namespace weft::agents
