#include <charconv>

#include "clients/cli/commands.hpp"
#include "clients/cli/rule_areas.hpp"

/// Holds the commands that change rules: what is laid down for pieces of the map.
namespace weft::cli {
namespace {

using Command = Invocation::Command;
using Kind = msg::OperatorRequest::Kind;

/// Reads "E:I..J", "E:I..F:J" or "E:I"; none when the text is not of that form.
std::optional<Span> parse_span(const std::string& text) {
  const std::size_t dots = text.find("..");
  const std::optional<PlaceId> from = parse_place_id(text.substr(0, dots));
  if (!from) return std::nullopt;
  if (dots == std::string::npos) return Span{*from, *from};
  const std::string rest = text.substr(dots + 2);
  if (const std::optional<PlaceId> to = parse_place_id(rest)) return Span{*from, *to};
  std::uint32_t index = 0;
  const char* const end = rest.data() + rest.size();
  const auto [stop, error] = std::from_chars(rest.data(), end, index);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return Span{*from, {from->experience, index}};
}

tl::unexpected<Error> no_place(const std::string& text, const char* form) {
  return fail(ErrorCode::invalid, "'" + text + "' is no " + form +
                                      ", with E and F of 16 hex digits and I and J indices of places; `weft map "
                                      "export` and `weft robots` show them");
}

/// Names the rule that closes an edge.
std::string edge_name(const Span& edge, bool both) {
  const auto named = [](const PlaceId& place) {
    return to_string(place.experience) + "." + std::to_string(place.index);
  };
  return "edge-" + named(edge.from) + "-" + named(edge.to) + (both ? "-both" : "");
}

Result<Rule> edge_rule(const Invocation& invocation) {
  Span edge;
  for (const auto& [text, place] : {std::pair(&invocation.place, &edge.from), {&invocation.to_place, &edge.to}}) {
    const std::optional<PlaceId> known = parse_place_id(*text);
    if (!known) return no_place(*text, "place E:I");
    *place = *known;
  }
  if (edge.from == edge.to) {
    return fail(ErrorCode::invalid, "the edge from " + invocation.place + " leads to itself: name two places");
  }
  Rule rule;
  rule.name = edge_name(edge, invocation.both);
  rule.one_direction = true;
  rule.spans = {edge};
  if (invocation.both) rule.spans.push_back({edge.to, edge.from});
  return rule;
}

/// Gives the rule an area, and the spans of what lies within it.
Result<void> take_area(Session& session, const Invocation& invocation, const Output& output, Rule& rule) {
  Result<RuleAreas> areas = rule_areas(session, invocation, output);
  if (!areas) return fail(areas.error());
  Result<Area> area = areas->area_on(invocation.plan, invocation.polygon);
  if (!area) return fail(area.error());
  Result<std::vector<Span>> spans = areas->spans_of(*area);
  if (!spans) return fail(spans.error());
  rule.area = *std::move(area);
  rule.spans = *std::move(spans);
  return {};
}

}  // namespace

Result<msg::OperatorRequest> rule_request(const Invocation& invocation) {
  msg::OperatorRequest request;
  const bool removes = invocation.command == Command::rule_remove || invocation.command == Command::edge_open;
  request.kind = removes ? Kind::rule_remove : Kind::rule_put;
  request.work.only_say = invocation.only_say;
  if (invocation.command == Command::edge_close || invocation.command == Command::edge_open) {
    Result<Rule> rule = edge_rule(invocation);
    if (!rule) return fail(rule.error());
    request.rule = *std::move(rule);
    return request;
  }
  request.rule = invocation.rule;
  for (const std::string& text : invocation.stretches) {
    const std::optional<Span> span = parse_span(text);
    if (!span) return no_place(text, "stretch E:I..J, E:I..F:J or place E:I");
    request.rule.spans.push_back(*span);
  }
  const bool is_directed = request.rule.kind == RuleKind::one_way || request.rule.one_direction;
  if (is_directed && !invocation.polygon.empty()) {
    return fail(ErrorCode::invalid, "rule " + request.rule.name +
                                        ": --polygon has no direction, and such a rule needs one: name --place A..B, "
                                        "from A towards B");
  }
  if (!request.rule.spans.empty() && !invocation.polygon.empty()) {
    return fail(ErrorCode::invalid,
                "rule " + request.rule.name +
                    ": its places are those of --polygon, which can be taken anew, or of --place, "
                    "not of both: make two rules of it");
  }
  const bool is_somewhere = !request.rule.spans.empty() || !request.rule.label.empty() || !invocation.polygon.empty();
  if (request.kind == Kind::rule_put && !is_somewhere) {
    return fail(ErrorCode::invalid, "rule " + request.rule.name +
                                        " holds nowhere: name --place A..B, --label L or "
                                        "--polygon X,Y;X,Y;X,Y");
  }
  return request;
}

Exit run_rules(Session& session, const Invocation& invocation, const Output& output) {
  Result<msg::OperatorRequest> request = rule_request(invocation);
  if (!request) return report(request.error(), invocation.json, output);
  if (!invocation.polygon.empty()) {
    const Result<void> taken = take_area(session, invocation, output, request->rule);
    if (!taken) return report(taken.error(), invocation.json, output);
  }
  const Result<msg::OperatorReply> reply = session.ask(*std::move(request), patience(invocation));
  if (!reply) return report(reply.error(), invocation.json, output);
  const Exit exit = show(*reply, invocation, output);
  if (exit == Exit::done && !invocation.polygon.empty() && !invocation.json && !invocation.only_say) {
    output.out << "when more is taught within the polygon, weft rule refresh " << invocation.rule.name
               << " covers that too\n";
  }
  return exit;
}

}  // namespace weft::cli
