#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/network/goal.hpp"
#include "core/network/network.hpp"
#include "core/network/window.hpp"

namespace weft::agents {

/// Bounds an agent's window while nothing else is asked for.
struct WindowSize {
  std::uint32_t hops = 25;
  std::uint32_t cap = 2000;
};

/// Keeps the places that the server says to look at, and finds the window that looking at them needs. A robot that
/// knows nothing of where it is gets a window of these places alone; one that has an idea, is being taught, or holds
/// the whole network anyway, holds them beside what it has.
class Proposals {
 public:
  explicit Proposals(const WindowSize& usual) : usual_(usual) {}

  void set(std::vector<PlaceId> places) { places_ = std::move(places); }
  /// Drops the places and the last note.
  void forget();
  bool empty() const { return places_.empty(); }
  std::size_t size() const { return places_.size(); }
  /// Returns whether a log does not have this note yet.
  bool is_news(const std::string& note);

  /// Notes where the robot may be by a fix that no second one has confirmed. Returns whether that is another place
  /// than before.
  bool suspect(const std::optional<PlaceId>& place);

  /// Returns the places to hold whatever the window is around: those of the route, then the proposed ones.
  std::vector<PlaceId> always_held(const std::optional<Route>& route) const;
  /// Returns `present` without what it has for the sake of the proposed places, except these places themselves.
  WindowDefinition usual(WindowDefinition present, const std::optional<Route>& route) const;

  /// Holds all that the choice between the two kinds of window depends on.
  struct Held {
    std::size_t places = 0;        ///< of the present window
    bool knows_something = false;  ///< where the robot is, or which run it is being taught
  };
  /// Returns the window that looking at the proposed places needs, and notes which kind of window that is.
  WindowDefinition wanted(WindowDefinition present, const std::optional<Route>& route, const Held& held);
  /// Returns whether the window is of the proposed places alone.
  bool is_alone() const { return is_alone_; }
  void leave_alone() { is_alone_ = false; }

  /// Returns the contents of what lies around the suspected place, then those of the proposed ones, then the others.
  std::vector<ContentRef> put_first(std::vector<ContentRef> contents, const Window& window) const;

 private:
  WindowSize usual_;
  std::vector<PlaceId> places_;
  std::optional<PlaceId> suspected_;
  bool is_alone_ = false;
  std::string noted_;
};

}  // namespace weft::agents
