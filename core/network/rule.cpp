#include "core/network/rule.hpp"

#include <array>

#include "core/text.hpp"

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

std::string to_string(const Span& span) {
  const bool is_one_run = span.from.experience == span.to.experience;
  return to_string(span.from) + ".." + (is_one_run ? std::to_string(span.to.index) : to_string(span.to));
}

std::string to_string(const Rule& rule) {
  std::string text = to_string(rule.kind);
  if (rule.kind == RuleKind::speed) text += " " + short_number(rule.value) + " m/s";
  if (rule.kind == RuleKind::priority || rule.kind == RuleKind::capacity) text += " " + short_number(rule.value);
  if (rule.one_direction) text += " in one direction";
  for (const Span& span : rule.spans) text += (&span == rule.spans.data() ? " on " : ", ") + to_string(span);
  if (rule.area)
    text += " (" + std::to_string(rule.area->corners.size()) + " corners on plan " + rule.area->plan + ")";
  if (rule.label.empty()) return text;
  text += rule.spans.empty() ? " " : " and ";
  return text + (rule.within_m > 0.0 ? "within " + short_number(rule.within_m) + " m of " : "at ") + rule.label;
}

}  // namespace weft
