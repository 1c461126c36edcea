#include "core/network/rule.hpp"

#include <array>

namespace weft {
namespace {

constexpr std::array kKinds = {RuleKind::closed,   RuleKind::speed,   RuleKind::one_way,  RuleKind::priority,
                               RuleKind::capacity, RuleKind::parking, RuleKind::charging, RuleKind::hold};

}  // namespace

const char* to_string(RuleKind kind) {
  switch (kind) {
    case RuleKind::closed:
      return "closed";
    case RuleKind::speed:
      return "speed";
    case RuleKind::one_way:
      return "one_way";
    case RuleKind::priority:
      return "priority";
    case RuleKind::capacity:
      return "capacity";
    case RuleKind::parking:
      return "parking";
    case RuleKind::charging:
      return "charging";
    case RuleKind::hold:
      return "hold";
  }
  return "unknown";
}

std::optional<RuleKind> rule_kind(std::string_view name) {
  for (const RuleKind kind : kKinds) {
    if (name == to_string(kind)) return kind;
  }
  return std::nullopt;
}

}  // namespace weft
