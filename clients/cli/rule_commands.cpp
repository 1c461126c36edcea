#include <charconv>

#include "clients/cli/commands.hpp"
#include "clients/cli/registered.hpp"
#include "clients/cli/table.hpp"
#include "core/text.hpp"

/// Holds the commands on rules: what is laid down for pieces of the map.
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

std::string value_of(const Rule& rule) {
  if (rule.kind == RuleKind::speed) return short_number(rule.value) + " m/s";
  const bool has_value = rule.kind == RuleKind::priority || rule.kind == RuleKind::capacity;
  return has_value ? short_number(rule.value) : rule.one_direction ? "one direction" : "-";
}

std::string where(const Rule& rule) {
  std::string text;
  for (const Span& span : rule.spans) text += (text.empty() ? "" : ", ") + to_string(span);
  if (rule.label.empty()) return text;
  text += (text.empty() ? "" : ", ") + rule.label;
  return rule.within_m > 0.0 ? text + " within " + short_number(rule.within_m) + " m" : text;
}

nlohmann::json document_of(const msg::RuleRow& row) {
  const Rule& rule = row.rule;
  nlohmann::json document = {{"name", rule.name},
                             {"kind", to_string(rule.kind)},
                             {"value", rule.value},
                             {"one_direction", rule.one_direction},
                             {"places", nlohmann::json::array()},
                             {"label", rule.label.empty() ? nlohmann::json() : nlohmann::json(rule.label)},
                             {"within_m", rule.within_m},
                             {"place_count", row.places},
                             {"problem", row.problem.empty() ? nlohmann::json() : nlohmann::json(row.problem)}};
  for (const Span& span : rule.spans) document["places"].push_back(to_string(span));
  return document;
}

/// Asks for the map and what is registered, and finds what of it lies within the polygon.
Result<std::vector<Span>> spans_on_plan(Session& session, const Invocation& invocation, const Output& output) {
  const Result<Window> network = network_at(session, invocation, {}, output);
  if (!network) return fail(network.error());
  const Result<NetworkPage> page = last_page_at(session, invocation, network->revision);
  if (!page) return fail(page.error());
  const Result<Registration> plan = registration_of(page->registrations, invocation.plan);
  if (!plan) return fail(plan.error());
  const Result<Registered> on_plan = registered(*network, *plan);
  if (!on_plan) return fail(on_plan.error());
  return spans_within(on_plan->layout, invocation.polygon);
}

Exit list(Session& session, const Invocation& invocation, const Output& output) {
  msg::Query query;
  query.kind = msg::Query::Kind::rules;
  const Result<msg::QueryReply> reply = session.query(query, patience(invocation));
  if (!reply) return report(reply.error(), invocation.json, output);
  if (invocation.json) {
    nlohmann::json document = {{"rules", nlohmann::json::array()}};
    for (const msg::RuleRow& row : reply->rules) document["rules"].push_back(document_of(row));
    output.out << printed(document) << '\n';
    return Exit::done;
  }
  if (reply->rules.empty()) {
    output.out << "no rules; lay one down: weft rule add NAME --kind closed --place A..B\n";
    return Exit::done;
  }
  Table table;
  table.add({"RULE", "KIND", "VALUE", "PLACES", "WHERE", "PROBLEM"});
  for (const msg::RuleRow& row : reply->rules) {
    table.add({row.rule.name, to_string(row.rule.kind), value_of(row.rule), std::to_string(row.places),
               where(row.rule), row.problem});
  }
  table.print(output.out);
  return Exit::done;
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
  const bool is_somewhere = !request.rule.spans.empty() || !request.rule.label.empty() || !invocation.polygon.empty();
  if (request.kind == Kind::rule_put && !is_somewhere) {
    return fail(ErrorCode::invalid, "rule " + request.rule.name +
                                        " holds nowhere: name --place A..B, --label L or "
                                        "--polygon X,Y;X,Y;X,Y");
  }
  return request;
}

Exit run_rules(Session& session, const Invocation& invocation, const Output& output) {
  if (invocation.command == Command::rule_list) return list(session, invocation, output);
  Result<msg::OperatorRequest> request = rule_request(invocation);
  if (!request) return report(request.error(), invocation.json, output);
  if (!invocation.polygon.empty()) {
    Result<std::vector<Span>> spans = spans_on_plan(session, invocation, output);
    if (!spans) return report(spans.error(), invocation.json, output);
    request->rule.spans.insert(request->rule.spans.end(), spans->begin(), spans->end());
    if (const std::size_t count = request->rule.spans.size(); count > kRuleSpans) {
      const std::string message = "rule " + request->rule.name + " names " + std::to_string(count) +
                                  " stretches with those within the polygon, at most " + std::to_string(kRuleSpans) +
                                  "; make several rules of it";
      return report(Error{ErrorCode::invalid, message}, invocation.json, output);
    }
  }
  const Result<msg::OperatorReply> reply = session.ask(*std::move(request), patience(invocation));
  if (!reply) return report(reply.error(), invocation.json, output);
  const Exit exit = show(*reply, invocation, output);
  if (exit == Exit::done && !invocation.polygon.empty() && !invocation.json && !invocation.only_say) {
    output.out << "it holds on the floor that is taught there now: lay it down again when more is taught within the "
                  "polygon.\n";
  }
  return exit;
}

}  // namespace weft::cli
