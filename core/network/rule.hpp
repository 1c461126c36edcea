#pragma once
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/ids.hpp"
#include "core/network/area.hpp"

namespace weft {

enum class RuleKind : std::uint8_t {
  closed = 1,    ///< nobody is released into it
  speed = 2,     ///< at most `value` metres a second
  one_way = 3,   ///< only from the first place of each span towards the last
  priority = 4,  ///< goals there have at least class `value`
  capacity = 5,  ///< at most `value` robots
  parking = 6,   ///< where idle robots go
  charging = 7,  ///< where robots charge
  hold = 8       ///< releases stop growing within it
};
const char* to_string(RuleKind kind);
/// Returns nothing when no kind has that name.
std::optional<RuleKind> rule_kind(std::string_view name);

/// Names a way along the floor: along a run from one place to another one, which may be the one before, or over the
/// edge that joins places of two runs.
struct Span {
  PlaceId from;
  PlaceId to;
  auto operator<=>(const Span&) const = default;
};

inline constexpr std::size_t kRuleSpans = 100;       ///< most spans of one rule
inline constexpr double kRuleWithin_m = 1000.0;      ///< farthest from its label
inline constexpr double kFastestLimit_m_s = 10.0;    ///< highest speed limit
inline constexpr std::uint8_t kHighestPriority = 9;  ///< the most urgent class of goals
inline constexpr double kMostRobots = 1000.0;        ///< largest capacity
inline constexpr std::size_t kMostRules = 1000;      ///< of one map

/// Holds what operators have laid down for a piece of the map. Holds where its spans lead and around its label.
struct Rule {
  std::string name;  ///< by the rule for labels (core/names.hpp); no other rule has it
  RuleKind kind = RuleKind::closed;
  double value = 0.0;          ///< speed, priority, capacity; 0 otherwise
  bool one_direction = false;  ///< closed: only from the first place of each span towards the last
  std::vector<Span> spans{};
  std::string label{};    ///< empty: none
  double within_m = 0.0;  ///< around the label, along the ways that lead from and to it; 0: the label's place alone
  std::optional<Area> area{};  ///< where the spans were taken from, all of them; none: they were named
  bool operator==(const Rule&) const = default;
};

/// Says it for people: "speed 0.3 m/s on 00000000000000a1:4..9 and within 2 m of dock", and "(4 corners on plan
/// hall)" of one with an area.
std::string to_string(const Rule& rule);
/// Says it as operators write it: "E:I..J", or "E:I..F:J" over the edge between two runs.
std::string to_string(const Span& span);

}  // namespace weft
