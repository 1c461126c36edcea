#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "agents/agent/content_cache.hpp"
#include "agents/agent/proposals.hpp"
#include "agents/agent/reanchoring.hpp"
#include "agents/agent/replica.hpp"
#include "agents/agent/window_focus.hpp"
#include "agents/navigation/navigator.hpp"
#include "core/protocol/messages.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// Holds all that the choice of the window depends on, besides the map.
struct MapContext {
  Navigator& navigator;
  const std::optional<Route>& route;
  std::optional<ExperienceId> taught;  ///< being taught
};

/// Holds the part of the map that this agent has, with its contents: decides which part that is, and in which order
/// the contents come.
class MapWindow {
 public:
  struct Limits {
    WindowSize size;
    std::uint64_t cache_bytes = 256ULL << 20U;
    std::uint64_t bytes_per_second = 4ULL << 20U;
  };
  /// Begins with nothing held. `first_id`: as Replica wants it.
  MapWindow(const Limits& limits, std::uint64_t first_id, SteadyTime now);

  MapView view() const { return {replica_.window(), cache_, replica_.generation()}; }
  const Replica& replica() const { return replica_; }
  const Window& window() const { return replica_.window(); }
  const ContentCache& contents() const { return cache_; }
  const Proposals& proposals() const { return proposals_; }

  /// Takes in a patch. `goes_elsewhere`: the window moves away from the estimate on purpose. Returns a note for the
  /// log; empty: none.
  std::string on_patch(const msg::WindowPatch& patch, const MapContext& context, bool goes_elsewhere, SteadyTime now);
  void on_chunk(const msg::Chunk& chunk, SteadyTime now) { cache_.on_chunk(chunk, now); }
  /// Takes in a content of this robot's own, just taught.
  void put(const ContentHash& hash, Bytes bytes) { cache_.put(hash, std::move(bytes)); }
  void server_restarted(SteadyTime now);

  /// Return requests without their headers, when it is time for them.
  std::optional<msg::WindowRequest> window_due(SteadyTime now) { return replica_.due(now); }
  std::optional<msg::ContentRequest> contents_due(SteadyTime now) { return cache_.due(now); }
  SteadyTime next() const;

  /// Holds the places of the route, or no longer those of the last one.
  void hold_route(const MapContext& context, SteadyTime now);
  /// Ends looking at proposed places, and centres the window on a seed if there is one.
  void leave_proposals(const std::optional<PlaceId>& seed, const MapContext& context, SteadyTime now);
  /// Asks for any part of the network when nothing is held.
  void look_anywhere(SteadyTime now);
  void look_at(std::vector<PlaceId> proposed, const MapContext& context, SteadyTime now);
  bool is_news(const std::string& note) { return proposals_.is_news(note); }
  void forget_proposals() { proposals_.forget(); }
  /// Goes on after a sample: a fix ends looking at proposed places, a suspected place moves the window.
  void follow_search(bool has_fix, const MapContext& context, SteadyTime now);
  /// Moves along with the robot. `durable`: see WindowFocus.
  void recentre(const std::optional<PlaceId>& durable, const MapContext& context, SteadyTime now);

 private:
  std::string keep_anchor(const MapContext& context, SteadyTime now);
  void define_for_proposed(const MapContext& context, SteadyTime now);
  void want_contents(const MapContext& context, SteadyTime now);

  std::uint32_t cap_;
  Replica replica_;
  ContentCache cache_;
  Proposals proposals_;
  WindowFocus focus_;
  Reanchoring reanchoring_;
};

}  // namespace weft::agents
