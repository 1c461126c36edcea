#pragma once
#include <optional>

#include "agents/navigation/navigator.hpp"
#include "core/network/window.hpp"

namespace weft::agents {

/// The window joined with the places that this robot has taught and that the window does not hold yet. While there
/// are none it is the window itself.
class OwnMap {
 public:
  void clear();
  /// A place and edges to places of this map. `anchor`: a join that the robot believes but does not hand in.
  void add(const Place& place, const std::vector<Edge>& edges);
  void anchor(const Edge& edge);
  /// One of the places that were added.
  bool has(const PlaceId& place) const;
  /// To be called with each new window before `map`. Once the window holds the last own place and teaching is over
  /// (`done`), the own places are forgotten.
  void update(const Window& window, bool done);
  const Window& map(const Window& window) const { return joined_ ? *joined_ : window; }

 private:
  void join(const Window& window);

  std::vector<Place> places_;
  std::vector<Edge> edges_;
  std::optional<Window> joined_;
  struct Seen {
    Revision revision;
    std::size_t places = 0;
    std::size_t edges = 0;
    bool operator==(const Seen&) const = default;
  } seen_;  // the window that joined_ is made of
};

}  // namespace weft::agents
