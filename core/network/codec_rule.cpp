#include "core/network/codec.hpp"
#include "core/network/fields.hpp"

namespace weft {
namespace {

Area read_area(ByteReader& in) {
  Area area;
  area.plan = in.text("area plan");
  area.plan_hash = in.id<ContentHash>("area plan hash");
  area.corners.resize(in.count("area corners", fields::kPointBytes));
  for (Eigen::Vector2d& corner : area.corners) corner = fields::read_point(in, "area corner");
  return area;
}

void write_area(ByteWriter& out, const Area& area) {
  out.text(area.plan);
  out.id(area.plan_hash);
  out.count(area.corners.size());
  for (const Eigen::Vector2d& corner : area.corners) fields::write(out, corner);
}

Rule read_rule(ByteReader& in) {
  Rule rule;
  rule.name = in.text("name");
  rule.kind = static_cast<RuleKind>(
      in.ranged("kind", static_cast<std::uint8_t>(RuleKind::closed), static_cast<std::uint8_t>(RuleKind::hold)));
  rule.value = fields::read_within(in, "value", 0.0, kMostRobots);
  rule.one_direction = in.flag("one direction");
  rule.spans.resize(in.count("spans", 2 * fields::kPlaceIdBytes));
  for (Span& span : rule.spans) {
    span.from = in.place_id("span from");
    span.to = in.place_id("span to");
  }
  rule.label = in.text("label");
  rule.within_m = fields::read_within(in, "within", 0.0, kRuleWithin_m);
  if (in.flag("has area")) rule.area = read_area(in);
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
    out.flag(rule.area.has_value());
    if (rule.area) write_area(out, *rule.area);
  });
}

Result<Rule> decode_rule(ByteView bytes) {
  return fields::whole<Rule>(bytes, "rule", read_rule);
}

}  // namespace weft
