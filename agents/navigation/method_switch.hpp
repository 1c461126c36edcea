#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "agents/navigation/config.hpp"
#include "agents/navigation/navigator.hpp"
#include "core/network/window.hpp"

/// Holds the rules by which a robot that sees by several methods changes from one to another (docs/decisions/027).
namespace weft::agents {

/// Returns the method of an edge between a place of each of two methods: a robot needs both to drive it, either way.
/// A name like any method's: who can drive it says so, nobody else has to know that it is two.
std::string change_between(std::string_view one, std::string_view other);

/// Returns where the robot is by the map of another method: relative to the nearest place of `method`, if that is
/// near enough to be seen from here and some hops of the window join it to the believed one. None: the two maps are
/// not joined there.
std::optional<Estimate> as_seen_by(std::string_view method, const NavigationConfig& config, const Window& window,
                                   const Estimate& known);

/// Returns whether two estimates of the same moment may both be right, by the window's way from one to the other. A
/// place that no way leads to agrees with nothing.
bool agree(const NavigationConfig& config, const Window& window, const Estimate& one, const Estimate& other);

/// Returns the method of the route's next place after `at`, at the route's end that of the last one; empty where the
/// window does not have it.
std::string_view next_method(const Window& window, const Route& route, std::uint32_t at);

/// Makes the edges between two experiences that one robot is taught at once, by two methods: where it was by the one
/// when it kept a place of the other. A value.
class Joins {
 public:
  explicit Joins(const StitchConfig& config) : config_(config) {}

  void clear() { *this = Joins(config_); }
  /// Returns the edge to `kept`, just kept where the robot is known to be at `older`. None: that one is joined
  /// already.
  std::optional<Edge> join(const Estimate& older, std::string_view older_method, const Place& kept);

 private:
  StitchConfig config_;
  std::optional<PlaceId> last_;  ///< older place of the last edge
};

}  // namespace weft::agents
