#include <cmath>

#include "core/network/codec.hpp"
#include "core/network/fields.hpp"

namespace weft {
namespace {

/// Reads a number that is neither negative nor above `most`.
double read_bounded(ByteReader& in, const char* field, double most) {
  const std::size_t at = in.offset();
  const double value = in.f64(field);
  if (!(value >= 0.0 && value <= most)) in.corrupt(field, at, "is not from 0 to " + std::to_string(most));
  return value;
}

Rule read_rule(ByteReader& in) {
  Rule rule;
  rule.name = in.text("name");
  rule.kind = static_cast<RuleKind>(
      in.ranged("kind", static_cast<std::uint8_t>(RuleKind::closed), static_cast<std::uint8_t>(RuleKind::hold)));
  rule.value = read_bounded(in, "value", kMostRobots);
  rule.one_direction = in.flag("one direction");
  rule.spans.resize(in.count("spans", 2 * fields::kPlaceIdBytes));
  for (Span& span : rule.spans) {
    span.from = in.place_id("span from");
    span.to = in.place_id("span to");
  }
  rule.label = in.text("label");
  rule.within_m = read_bounded(in, "within", kRuleWithin_m);
  return rule;
}

}  // namespace

Bytes encode(const Rule& rule) {
  return fields::record([&](ByteWriter& out) {
    out.text(rule.name);
    out.number(static_cast<std::uint8_t>(rule.kind));
    out.f64(rule.value);
    out.flag(rule.one_direction);
    out.count(rule.spans.size());
    for (const Span& span : rule.spans) {
      out.id(span.from);
      out.id(span.to);
    }
    out.text(rule.label);
    out.f64(rule.within_m);
  });
}

Result<Rule> decode_rule(ByteView bytes) {
  return fields::whole<Rule>(bytes, "rule", read_rule);
}

}  // namespace weft
