#pragma once
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "agents/navigation/navigator.hpp"
#include "core/network/window.hpp"

namespace weft::agents {

/// Holds the map of one method: the window without what others need to see, joined with the places that this robot
/// has taught and that the window does not hold yet. Where nothing is to be left out or joined it is the window
/// itself.
class OwnMap {
 public:
  explicit OwnMap(std::string_view method) : method_(method) {}

  /// Forgets the own places.
  void clear();
  /// Add a place and edges to places of this map. `anchor`: a join that the robot believes but does not hand in.
  void add(const Place& place, const std::vector<Edge>& edges);
  void anchor(const Edge& edge);
  /// Takes out what joins the own places to those of other runs.
  void part_from_others(const Window& window);
  /// Returns whether a place is one of those that were added.
  bool has(const PlaceId& place) const;
  /// Joins the own places to a new window; to be called with each, before `map`; `generation` as in MapView. Once the
  /// window holds the last own place and teaching is over (`done`), the own places are forgotten.
  void update(const Window& window, std::uint64_t generation, bool done);
  /// Returns the same over another window: as it was, or as it will be.
  OwnMap over(const Window& window) const;
  const Window& map(const Window& window) const { return joined_ ? *joined_ : window; }

 private:
  void join(const Window& window);

  std::string_view method_;  // static text
  std::vector<Place> places_;
  std::vector<Edge> edges_;
  std::optional<Window> joined_;  // none: the window itself
  struct Seen {
    Revision revision;
    std::uint64_t generation = 0;
    bool operator==(const Seen&) const = default;
  };
  std::optional<Seen> seen_;  // the window that joined_ is made of
};

}  // namespace weft::agents
