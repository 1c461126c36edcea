#include <algorithm>
#include <map>

#include "clients/cli/commands.hpp"
#include "clients/cli/rule_areas.hpp"
#include "clients/cli/table.hpp"
#include "core/text.hpp"

/// Holds `weft rule list`: rules, where they hold, and what they do not cover.
namespace weft::cli {
namespace {

std::string value_of(const Rule& rule) {
  if (rule.kind == RuleKind::speed) return short_number(rule.value) + " m/s";
  const bool has_value = rule.kind == RuleKind::priority || rule.kind == RuleKind::capacity;
  return has_value ? short_number(rule.value) : rule.one_direction ? "one direction" : "-";
}

std::string where(const Rule& rule) {
  std::string text;
  for (const Span& span : rule.spans) text += (text.empty() ? "" : ", ") + to_string(span);
  if (rule.area) text += " on plan " + rule.area->plan;
  if (rule.label.empty()) return text;
  text += (text.empty() ? "" : ", ") + rule.label;
  return rule.within_m > 0.0 ? text + " within " + short_number(rule.within_m) + " m" : text;
}

/// Tells of each rule with an area, by its name, how many places within that it does not cover, or why nobody can
/// say.
using Coverage = std::map<std::string, Result<std::size_t>>;

Result<Coverage> coverage_of(Session& session, const std::vector<msg::RuleRow>& rows, const Invocation& invocation,
                             const Output& output) {
  Coverage coverage;
  const auto has_area = [](const msg::RuleRow& row) { return row.rule.area.has_value(); };
  if (std::ranges::none_of(rows, has_area)) return coverage;
  Result<RuleAreas> areas = rule_areas(session, invocation, output);
  if (!areas) return fail(areas.error());
  for (const msg::RuleRow& row : rows) {
    if (has_area(row)) coverage.emplace(row.rule.name, areas->not_covered(row.rule));
  }
  return coverage;
}

nlohmann::json document_of(const Area& area, const Result<std::size_t>& not_covered) {
  nlohmann::json document = {
      {"plan", area.plan},
      {"sha256", to_string(area.plan_hash)},
      {"corners", nlohmann::json::array()},
      {"not_covered", not_covered ? nlohmann::json(*not_covered) : nlohmann::json()},
      {"problem", not_covered ? nlohmann::json() : nlohmann::json(not_covered.error().message)}};
  for (const Eigen::Vector2d& corner : area.corners) document["corners"].push_back({corner.x(), corner.y()});
  return document;
}

nlohmann::json document_of(const msg::RuleRow& row, const Coverage& coverage) {
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
  const auto found = coverage.find(rule.name);
  const bool has_area = rule.area.has_value() && found != coverage.end();
  document["area"] = has_area ? document_of(*rule.area, found->second) : nlohmann::json();
  return document;
}

/// Says what the rule names and the map has not, and what its area has and it does not cover.
std::string problems_of(const msg::RuleRow& row, const Coverage& coverage) {
  std::string text = row.problem;
  const auto found = coverage.find(row.rule.name);
  if (found == coverage.end() || (found->second && *found->second == 0)) return text;
  if (!text.empty()) text += "; ";
  if (!found->second) return text + found->second.error().message;
  const std::size_t count = *found->second;
  return text + std::to_string(count) + (count == 1 ? " place" : " places") +
         " within its polygon not covered: weft rule refresh " + row.rule.name;
}

}  // namespace

Exit run_rule_list(Session& session, const Invocation& invocation, const Output& output) {
  msg::Query query;
  query.kind = msg::Query::Kind::rules;
  const Result<msg::QueryReply> reply = session.query(query, patience(invocation));
  if (!reply) return report(reply.error(), invocation.json, output);
  const Result<Coverage> coverage = coverage_of(session, reply->rules, invocation, output);
  if (!coverage) return report(coverage.error(), invocation.json, output);
  if (invocation.json) {
    nlohmann::json document = {{"rules", nlohmann::json::array()}};
    for (const msg::RuleRow& row : reply->rules) document["rules"].push_back(document_of(row, *coverage));
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
               where(row.rule), problems_of(row, *coverage)});
  }
  table.print(output.out);
  return Exit::done;
}

}  // namespace weft::cli
