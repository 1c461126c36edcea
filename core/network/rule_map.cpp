#include "core/network/rule_map.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <set>
#include <utility>

namespace weft {
namespace {

constexpr double kUsualSpeed_m_s = 0.6;

bool has(const std::vector<std::uint32_t>& numbers, std::uint32_t number) {
  return std::ranges::binary_search(numbers, number);
}

/// Returns how many times more a metre costs there.
double factor_at(const RuleMap& rules, const PlaceId& place) {
  const std::optional<double> limit_m_s = rules.limit_m_s(place);
  return limit_m_s ? std::max(1.0, kUsualSpeed_m_s / *limit_m_s) : 1.0;
}

struct PlaceLabel {
  double cost = std::numeric_limits<double>::infinity();
  PlaceId before;
  const Edge* edge = nullptr;
  bool is_settled = false;
};
using Labels = std::map<PlaceId, PlaceLabel>;

/// Runs Dijkstra's algorithm over places as they are met; stops when `to` is settled.
Labels settle(const Snapshot& snapshot, const RuleMap& rules, const PlaceId& from, const PlaceId& to,
              const std::set<std::string>& methods, const Passage& passage) {
  using Entry = std::pair<double, PlaceId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  Labels labels;
  labels[from].cost = 0.0;
  open.emplace(0.0, from);
  while (!open.empty()) {
    const PlaceId here = open.top().second;
    open.pop();
    PlaceLabel& settled = labels[here];
    if (std::exchange(settled.is_settled, true)) continue;
    if (here == to) break;
    const double so_far = settled.cost;
    snapshot.for_each_edge(here, [&](const Edge& edge) {
      if (!can_drive(edge, here) || !methods.contains(edge.method)) return;
      const PlaceId there = other_end(edge, here);
      if (snapshot.place(there) == nullptr || rules.bars(here, there, passage)) return;
      PlaceLabel& label = labels[there];
      const double cost = so_far + norm(edge.a_from_b) * std::max(factor_at(rules, here), factor_at(rules, there));
      if (label.is_settled || cost >= label.cost) return;
      label = {.cost = cost, .before = here, .edge = &edge, .is_settled = false};
      open.emplace(cost, there);
    });
  }
  return labels;
}

Path path_to(const PlaceId& to, const Labels& labels) {
  Path path;
  path.places.push_back(to);
  for (const PlaceLabel* at = &labels.at(to); at->edge != nullptr; at = &labels.at(at->before)) {
    path.relations.push_back(relation_from(*at->edge, at->before));
    path.length_m += distance_m(path.relations.back());
    path.places.push_back(at->before);
  }
  std::ranges::reverse(path.places);
  std::ranges::reverse(path.relations);
  return path;
}

/// Returns the first hop of a way that cannot be driven; none: it can.
std::optional<Span> first_bar(const RuleMap& rules, const std::vector<PlaceId>& places, const Passage& passage) {
  for (std::size_t at = 1; at < places.size(); ++at) {
    if (rules.bars(places[at - 1], places[at], passage)) return Span{places[at - 1], places[at]};
  }
  return std::nullopt;
}

}  // namespace

RuleMap::RuleMap(const Snapshot& snapshot) {
  for (const auto& [name, rule] : snapshot.rules()) {
    const auto number = static_cast<std::uint32_t>(rules_.size());
    const RuleExtent extent = extent_of(snapshot, rule);
    for (const PlaceId& place : extent.places) places_[place].push_back(number);
    for (const Span& span : extent.forbidden) {
      forbidden_[span].push_back(number);
      enters_[span.to].push_back(number);
      leaves_[span.from].push_back(number);
    }
    rules_.push_back(rule);
  }
}

const RuleMap::Numbers& RuleMap::at(const PlaceId& place) const {
  static const Numbers kNone;
  const auto found = places_.find(place);
  return found == places_.end() ? kNone : found->second;
}

/// Returns whether what the rule forbids leads to the place and on from it.
bool RuleMap::is_inside(std::uint32_t rule, const PlaceId& place) const {
  const auto enters = enters_.find(place);
  const auto leaves = leaves_.find(place);
  return enters != enters_.end() && leaves != leaves_.end() && has(enters->second, rule) && has(leaves->second, rule);
}

const Rule* RuleMap::barrier(const PlaceId& from, const PlaceId& to, const Passage& passage) const {
  if (empty()) return nullptr;
  for (const std::uint32_t number : at(to)) {
    const Rule& rule = rules_[number];
    const bool is_closed = (rule.kind == RuleKind::closed && !rule.one_direction) ||
                           (rule.kind == RuleKind::speed && !passage.keeps_limits);
    if (is_closed && !has(at(from), number)) return &rule;
  }
  const auto forbidden = forbidden_.find({from, to});
  if (forbidden == forbidden_.end()) return nullptr;
  for (const std::uint32_t number : forbidden->second) {
    if (!is_inside(number, passage.begins)) return &rules_[number];
  }
  return nullptr;
}

bool RuleMap::bars(const PlaceId& from, const PlaceId& to, const Passage& passage) const {
  const bool is_closed = passage.closed != nullptr && passage.closed->contains({from, to});
  return is_closed || barrier(from, to, passage) != nullptr;
}

const Rule* RuleMap::first_of(const PlaceId& place, RuleKind kind) const {
  const Numbers& numbers = at(place);
  const auto found = std::ranges::find_if(numbers, [&](std::uint32_t number) { return rules_[number].kind == kind; });
  return found == numbers.end() ? nullptr : &rules_[*found];
}

const Rule* RuleMap::hold(const PlaceId& place) const {
  return first_of(place, RuleKind::hold);
}

std::optional<double> RuleMap::limit_m_s(const PlaceId& place) const {
  std::optional<double> lowest;
  for (const std::uint32_t number : at(place)) {
    const Rule& rule = rules_[number];
    if (rule.kind == RuleKind::speed) lowest = std::min(lowest.value_or(rule.value), rule.value);
  }
  return lowest;
}

std::uint8_t RuleMap::priority(const PlaceId& place) const {
  std::uint8_t highest = 0;
  for (const std::uint32_t number : at(place)) {
    const Rule& rule = rules_[number];
    if (rule.kind == RuleKind::priority) highest = std::max(highest, static_cast<std::uint8_t>(rule.value));
  }
  return highest;
}

bool RuleMap::counts_robots() const {
  return std::ranges::any_of(rules_, [](const Rule& rule) { return rule.kind == RuleKind::capacity; });
}

std::map<std::string, std::size_t> RuleMap::capacities(const PlaceId& place) const {
  std::map<std::string, std::size_t> most;
  for (const std::uint32_t number : at(place)) {
    const Rule& rule = rules_[number];
    if (rule.kind == RuleKind::capacity) most.emplace(rule.name, static_cast<std::size_t>(rule.value));
  }
  return most;
}

ReleasedByRules released_by_rules(const RuleMap& rules, const Route& route, std::uint32_t from,
                                  std::optional<std::uint32_t> through, bool keeps_limits) {
  if (rules.empty() || from >= route.places.size()) return {through, {}};
  // Names the rule also for a robot that others let no farther, if the rule is the next thing.
  const auto last = static_cast<std::uint32_t>(route.places.size() - 1);
  const std::uint32_t farthest = through ? *through : std::min(from + 1, last);
  const Passage passage{.begins = route.places[from], .keeps_limits = keeps_limits};
  for (std::uint32_t at = from + 1; at <= farthest; ++at) {
    const PlaceId& before = route.places[at - 1];
    const PlaceId& place = route.places[at];
    const Rule* rule = rules.barrier(before, place, passage);
    if (rule == nullptr) rule = rules.hold(place);
    if (rule == nullptr) rule = rules.hold(before);
    if (rule == nullptr) continue;
    // The first place of a route is where the robot stands: that it may have.
    const bool is_more = through && (at - 1 > from || at == 1);
    return {is_more ? std::optional(at - 1) : std::nullopt, rule->name};
  }
  return {through, {}};
}

std::optional<std::uint32_t> first_barred(const RuleMap& rules, const Route& route, std::uint32_t from,
                                          bool keeps_limits) {
  if (rules.empty() || from >= route.places.size()) return std::nullopt;
  const Passage passage{.begins = route.places[from], .keeps_limits = keeps_limits};
  for (auto at = std::size_t{from} + 1; at < route.places.size(); ++at) {
    if (rules.barrier(route.places[at - 1], route.places[at], passage) != nullptr) {
      return static_cast<std::uint32_t>(at);
    }
  }
  return std::nullopt;
}

std::vector<SpeedLimit> limits_of(const RuleMap& rules, const std::vector<PlaceId>& places) {
  std::vector<SpeedLimit> limits;
  if (rules.empty()) return limits;
  for (std::uint32_t at = 0; at < places.size(); ++at) {
    const std::optional<double> limit_m_s = rules.limit_m_s(places[at]);
    if (!limit_m_s) continue;
    const bool goes_on = !limits.empty() && limits.back().to + 1 == at;
    const bool is_full = limits.size() == kRouteLimits;
    if (is_full || (goes_on && limits.back().limit_m_s == *limit_m_s)) {
      limits.back().to = at;
      limits.back().limit_m_s = std::min(limits.back().limit_m_s, *limit_m_s);
    } else {
      limits.push_back({.from = at, .to = at, .limit_m_s = *limit_m_s});
    }
  }
  return limits;
}

Result<Path> shortest_path(const Snapshot& snapshot, const RuleMap& rules, const PlaceId& from, const PlaceId& to,
                           const std::set<std::string>& methods, const Passage& passage) {
  const bool are_there = snapshot.place(from) != nullptr && snapshot.place(to) != nullptr;
  if (!are_there) return shortest_path(snapshot, from, to, methods);  // which says it
  const Labels labels = settle(snapshot, rules, from, to, methods, passage);
  const auto reached = labels.find(to);
  if (reached != labels.end() && reached->second.is_settled) return path_to(to, labels);
  const Result<Path> free = shortest_path(snapshot, from, to, methods);
  if (!free) return fail(free.error());
  return fail(ErrorCode::not_found, barred_text(rules, *free, passage));
}

bool is_free(const RuleMap& rules, const Path& path, const Passage& passage) {
  if (rules.empty() && passage.closed == nullptr) return true;
  if (first_bar(rules, path.places, passage)) return false;
  return std::ranges::all_of(path.places, [&](const PlaceId& place) { return factor_at(rules, place) == 1.0; });
}

std::string barred_text(const RuleMap& rules, const Path& path, const Passage& passage) {
  const Span bar = first_bar(rules, path.places, passage).value_or(Span{});
  const std::string to = to_string(path.places.back());
  const Rule* const rule = rules.barrier(bar.from, bar.to, passage);
  if (rule == nullptr) return "the way to " + to + " is closed at " + to_string(bar) + ", and no other leads there";
  return "rule " + rule->name + " bars the way to " + to + " from " + to_string(bar.to) +
         " on, and no other way leads there: weft rule list";
}

}  // namespace weft
