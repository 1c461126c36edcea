#pragma once
#include <optional>

#include "agents/navigation/navigator.hpp"
#include "core/ids.hpp"
#include "core/network/window.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// Decides when a robot looks for itself of its own accord, at most every 10 s. A robot that does not know where it
/// is looks once in each revision of the map, and on and on while it has a route; one that may be mistaken looks
/// before a route is planned, and when its route turns out to lie elsewhere. A lost one still has an idea of where it
/// was; the navigator looks from there by itself.
class SearchPolicy {
 public:
  explicit SearchPolicy(SteadyTime now) : search_at_(now) {}

  struct Situation {
    std::optional<Estimate> estimate;
    bool has_route = false;
    bool strays = false;           ///< its route is not where it believes that it stands
    bool is_held = false;          ///< lost, or stopped by an operator
    bool is_out_of_order = false;  ///< its body has failed
  };
  /// Returns whether a search in this map is due.
  bool is_due(const Window& window, const Situation& situation, SteadyTime now) const;
  /// Notes that a search begins, for whatever reason.
  void begins(const Window& window, SteadyTime now);

 private:
  bool is_of_use(const Window& window, const Situation& situation) const;

  std::optional<Revision> searched_at_;  ///< of the map in which it last looked for itself
  SteadyTime search_at_;
};

}  // namespace weft::agents
