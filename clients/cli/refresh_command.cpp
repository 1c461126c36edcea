#include <algorithm>
#include <iterator>

#include "clients/cli/commands.hpp"
#include "clients/cli/rule_areas.hpp"

/// Holds `weft rule refresh`: the spans of rules are taken anew from their areas.
namespace weft::cli {
namespace {

/// Holds what became of one rule's places.
struct Refreshed {
  std::string name;
  std::vector<Span> added;
  std::vector<Span> removed;
};

/// Returns the rule that is named, or all that have an area. not_found: the map has none of that name; refused: it
/// has no area.
Result<std::vector<Rule>> rules_to_refresh(const std::vector<msg::RuleRow>& rows, const std::string& name) {
  std::vector<Rule> rules;
  for (const msg::RuleRow& row : rows) {
    if (name.empty() ? row.rule.area.has_value() : row.rule.name == name) rules.push_back(row.rule);
  }
  if (name.empty()) return rules;
  if (rules.empty()) return fail(ErrorCode::not_found, "the map has no rule " + name + ": weft rule list shows all");
  if (rules.front().area) return rules;
  return fail(ErrorCode::refused, "rule " + name +
                                      " has no area from which its places could be taken anew: they were named; lay "
                                      "it down again with --polygon to give it one");
}

std::vector<Span> only_in(const std::set<PlaceId>& places, const std::set<PlaceId>& others) {
  std::set<PlaceId> found;
  std::ranges::set_difference(places, others, std::inserter(found, found.end()));
  return spans_of(found);
}

/// Lays one rule down anew, if its spans are others by now. Errors name the rule.
Result<Refreshed> refresh(Session& session, const Invocation& invocation, Rule rule, RuleAreas& areas) {
  const std::string name = "rule " + rule.name + ": ";
  Result<std::vector<Span>> spans = areas.spans_of(rule.area.value_or(Area{}));
  if (!spans) return fail(spans.error().code, name + spans.error().message);
  Refreshed refreshed{rule.name, {}, {}};
  if (*spans == rule.spans) return refreshed;
  const std::set<PlaceId> before = places_of(rule.spans);
  const std::set<PlaceId> now = places_of(*spans);
  refreshed.added = only_in(now, before);
  refreshed.removed = only_in(before, now);
  msg::OperatorRequest request;
  request.kind = msg::OperatorRequest::Kind::rule_put;
  request.work.only_say = invocation.only_say;
  request.rule = std::move(rule);
  request.rule.spans = *std::move(spans);
  const Result<msg::OperatorReply> reply = session.ask(std::move(request), patience(invocation));
  if (!reply) return fail(reply.error().code, name + reply.error().message);
  if (reply->outcome != msg::Outcome::done) return fail(ErrorCode::refused, name + reply->message);
  return refreshed;
}

std::string listed(const std::vector<Span>& spans) {
  std::string text;
  for (const Span& span : spans) text += (text.empty() ? "" : ", ") + to_string(span);
  return text.empty() ? "nothing" : text;
}

nlohmann::json texts_of(const std::vector<Span>& spans) {
  nlohmann::json texts = nlohmann::json::array();
  for (const Span& span : spans) texts.push_back(to_string(span));
  return texts;
}

void tell(const std::vector<Refreshed>& rules, const Invocation& invocation, const Output& output) {
  if (invocation.json) {
    nlohmann::json document = {{"refreshed", nlohmann::json::array()}};
    for (const Refreshed& rule : rules) {
      document["refreshed"].push_back(
          {{"name", rule.name}, {"added", texts_of(rule.added)}, {"removed", texts_of(rule.removed)}});
    }
    output.out << printed(document) << '\n';
    return;
  }
  for (const Refreshed& rule : rules) {
    if (rule.added.empty() && rule.removed.empty()) {
      output.out << "rule " << rule.name << ": as it was\n";
    } else {
      output.out << "rule " << rule.name << ": added " << listed(rule.added) << "; removed " << listed(rule.removed)
                 << (invocation.only_say ? "; nothing was changed" : "") << '\n';
    }
  }
  if (rules.empty()) output.out << "no rule has an area\n";
}

}  // namespace

Exit run_refresh(Session& session, const Invocation& invocation, const Output& output) {
  msg::Query query;
  query.kind = msg::Query::Kind::rules;
  const Result<msg::QueryReply> reply = session.query(query, patience(invocation));
  if (!reply) return report(reply.error(), invocation.json, output);
  const Result<std::vector<Rule>> rules = rules_to_refresh(reply->rules, invocation.rule.name);
  if (!rules) return report(rules.error(), invocation.json, output);
  std::vector<Refreshed> done;
  std::optional<Error> error;
  if (!rules->empty()) {
    Result<RuleAreas> areas = rule_areas(session, invocation, output);
    if (!areas) return report(areas.error(), invocation.json, output);
    for (const Rule& rule : *rules) {
      Result<Refreshed> refreshed = refresh(session, invocation, rule, *areas);
      if (refreshed) {
        done.push_back(*std::move(refreshed));
      } else if (!error) {
        error = refreshed.error();
      } else {
        error->message += "\n" + refreshed.error().message;
      }
    }
  }
  if (!error || (!invocation.json && !done.empty())) tell(done, invocation, output);
  return error ? report(*error, invocation.json, output) : Exit::done;
}

}  // namespace weft::cli
