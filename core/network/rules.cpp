#include "core/network/rules.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <set>
#include <utility>

#include "core/names.hpp"
#include "core/network/search.hpp"
#include "core/text.hpp"

namespace weft {
namespace {

/// Bounds how far from a named place another run's place covers the same floor.
constexpr double kSameFloor_m = 0.4;
/// Bounds how far around a named place runs are looked for: they may be joined some way before or behind it.
constexpr double kAround_m = 3.0;
constexpr std::size_t kMostPlacesAround = 1000;
/// Is how many places a run goes on before it may come by the same floor again.
constexpr std::uint32_t kNeighbours = 4;
/// Bounds from below the cosine of the angle between two ways that lead alike: within 60 degrees.
constexpr double kAlike = 0.5;
constexpr double kLeastStep_m = 0.02;

bool is_directed(const Rule& rule) {
  return rule.one_direction || rule.kind == RuleKind::one_way;
}

struct Bounds {
  double least;
  double most;
  bool is_whole;
  const char* unit;
};

Bounds bounds_of(RuleKind kind) {
  switch (kind) {
    case RuleKind::speed:
      return {0.01, kFastestLimit_m_s, false, " m/s"};
    case RuleKind::priority:
      return {0.0, kHighestPriority, true, ""};
    case RuleKind::capacity:
      return {1.0, kMostRobots, true, " robots"};
    default:
      return {0.0, 0.0, true, ""};
  }
}

Result<void> check_value(const Rule& rule) {
  const Bounds bounds = bounds_of(rule.kind);
  const bool is_in = rule.value >= bounds.least && rule.value <= bounds.most;
  if (is_in && (!bounds.is_whole || rule.value == std::floor(rule.value))) return {};
  const std::string name = "rule " + rule.name + ": " + to_string(rule.kind);
  if (bounds.most == 0.0) return fail(ErrorCode::invalid, name + " takes no value");
  return fail(ErrorCode::invalid, name + " needs " + (bounds.is_whole ? "a whole number" : "a value") + " from " +
                                      short_number(bounds.least) + " to " + short_number(bounds.most) + bounds.unit +
                                      ", not " + short_number(rule.value));
}

bool are_joined(const Snapshot& snapshot, const Span& span) {
  bool joined = false;
  snapshot.for_each_edge(span.from,
                         [&](const Edge& edge) { joined = joined || other_end(edge, span.from) == span.to; });
  return joined;
}

Result<void> check_span(const Snapshot& snapshot, const std::string& name, const Span& span) {
  for (const PlaceId& end : {span.from, span.to}) {
    if (snapshot.place(end) != nullptr) continue;
    return fail(ErrorCode::not_found,
                name + ": place " + to_string(end) + " is not in the map; `weft map export` lists its places");
  }
  if (span.from.experience == span.to.experience || are_joined(snapshot, span)) return {};
  return fail(ErrorCode::not_found, name + ": no edge joins " + to_string(span.from) + " and " + to_string(span.to) +
                                        ", which are of two runs; name places of one run, or the ends of an edge");
}

Result<void> check_area(const Rule& rule) {
  if (!rule.area) return {};
  const std::string name = "rule " + rule.name;
  if (is_directed(rule)) {
    return fail(ErrorCode::invalid, name + " has a direction, which an area has not: name places in its stead");
  }
  if (const Result<void> good = check_name("plan", rule.area->plan); !good)
    return fail(good.error().code, name + ", its area: " + good.error().message);
  const std::string problem = problem_of(rule.area->corners);
  if (problem.empty()) return {};
  return fail(ErrorCode::invalid, name + ": its area on plan " + rule.area->plan + " " + problem + "; give " +
                                      std::to_string(kLeastCorners) + " to " + std::to_string(kMostCorners) +
                                      " corners in metres of the plan's frame");
}

Result<void> check_where(const Snapshot& snapshot, const Rule& rule) {
  const std::string name = "rule " + rule.name;
  if (rule.spans.empty() && rule.label.empty()) {
    return fail(ErrorCode::invalid, name + " holds nowhere: name places or a label");
  }
  if (rule.spans.size() > kRuleSpans) {
    return fail(ErrorCode::invalid, name + " names " + std::to_string(rule.spans.size()) + " stretches, at most " +
                                        std::to_string(kRuleSpans) + "; make several rules of it");
  }
  const bool has_direction =
      rule.label.empty() && std::ranges::none_of(rule.spans, [](const Span& span) { return span.from == span.to; });
  if (is_directed(rule) && !has_direction) {
    return fail(ErrorCode::invalid,
                name + " has a direction: name the first and the last place of each stretch, and no label");
  }
  if (rule.one_direction && rule.kind != RuleKind::closed) {
    return fail(ErrorCode::invalid, name + ": one direction is for what is closed, not for " + to_string(rule.kind));
  }
  const bool is_within = std::isfinite(rule.within_m) && rule.within_m >= 0.0 && rule.within_m <= kRuleWithin_m;
  if (!is_within || (rule.label.empty() && rule.within_m > 0.0)) {
    return fail(ErrorCode::invalid, name + " reaches from 0 to " + short_number(kRuleWithin_m) +
                                        " m around a label, not " + short_number(rule.within_m) + " m around " +
                                        (rule.label.empty() ? "none" : rule.label));
  }
  for (const Span& span : rule.spans) {
    if (auto fits = check_span(snapshot, name, span); !fits) return fits;
  }
  if (rule.label.empty() || snapshot.labels().contains(rule.label)) return {};
  return fail(ErrorCode::not_found, name + ": the map has no label " + rule.label);
}

/// Holds a place that the rule names, and where its span leads on from there, in its own frame; no way: 0.
struct Named {
  PlaceId place;
  Eigen::Vector2d way = Eigen::Vector2d::Zero();
};

Eigen::Vector2d way_to(const Snapshot& snapshot, const PlaceId& from, const PlaceId& to) {
  Eigen::Vector2d way = Eigen::Vector2d::Zero();
  snapshot.for_each_edge(from, [&](const Edge& edge) {
    if (other_end(edge, from) != to) return;
    const Pose2 pose = planar(relation_from(edge, from));
    way = {pose.x, pose.y};
  });
  return way;
}

/// Walks a rule's spans and around its label.
class Walk {
 public:
  Walk(const Snapshot& snapshot, const Rule& rule) : snapshot_(snapshot), rule_(rule) {
    for (const Span& span : rule.spans) along(span);
    if (!rule.label.empty()) around();
  }

  const std::vector<Named>& named() const { return named_; }
  std::string take_problem() { return std::move(problem_); }

 private:
  void note(const PlaceId& place) {
    if (snapshot_.place(place) != nullptr) named_.push_back({place});
  }

  void missing(const std::string& what) { problem_ += (problem_.empty() ? "the map has no " : ", no ") + what; }

  /// Notes each place of a span, leading to the next one that is there.
  void along(const Span& span) {
    const std::size_t first = named_.size();
    if (span.from.experience != span.to.experience) {
      note(span.from);
      note(span.to);
    } else {
      along_run(span);
    }
    if (named_.size() == first) return missing("place of " + to_string(span));
    for (std::size_t at = first; at < named_.size(); ++at) {
      if (at + 1 < named_.size()) {
        named_[at].way = way_to(snapshot_, named_[at].place, named_[at + 1].place);
      } else if (at > first) {
        named_[at].way = -way_to(snapshot_, named_[at].place, named_[at - 1].place);
      }
    }
  }

  void along_run(const Span& span) {
    const Experience* const run = snapshot_.experience(span.from.experience);
    if (run == nullptr) return;
    const bool is_up = span.from.index <= span.to.index;
    const std::uint32_t low = std::min(span.from.index, span.to.index);
    const std::uint32_t high = std::min(std::max(span.from.index, span.to.index), run->extent);
    for (std::uint32_t step = 0; low + step <= high; ++step) {
      note({run->id, is_up ? low + step : high - step});
    }
  }

  /// Notes what edges lead to from the label in either direction, shortest first.
  void around() {
    const auto label = snapshot_.labels().find(rule_.label);
    if (label == snapshot_.labels().end()) return missing("label " + rule_.label);
    using Entry = std::pair<double, PlaceId>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    std::set<PlaceId> settled;
    open.emplace(0.0, label->second);
    while (!open.empty()) {
      const auto [away_m, place] = open.top();
      open.pop();
      if (!settled.insert(place).second) continue;
      note(place);
      snapshot_.for_each_edge(place, [&, away = away_m, here = place](const Edge& edge) {
        const PlaceId there = other_end(edge, here);
        const double farther_m = away + distance_m(edge.a_from_b);
        if (farther_m <= rule_.within_m && !settled.contains(there)) open.emplace(farther_m, there);
      });
    }
  }

  const Snapshot& snapshot_;
  const Rule& rule_;
  std::vector<Named> named_;
  std::string problem_;
};

/// Holds a place on the floor of a named one, and how it lies to that.
struct Beside {
  PlaceId place;
  Pose2 named_from_place;
};

/// Leaves out neighbours along the same run, which are other floor.
std::vector<Beside> on_the_floor_of(const Snapshot& snapshot, const PlaceId& named) {
  std::vector<Beside> found;
  for (const Reached& reached : within(snapshot, named, kAround_m, kMostPlacesAround)) {
    const bool is_neighbour =
        reached.depth > 0 && reached.id.experience == named.experience &&
        std::max(reached.id.index, named.index) - std::min(reached.id.index, named.index) <= kNeighbours;
    if (is_neighbour || distance_m(reached.centre_from_place) > kSameFloor_m) continue;
    found.push_back({reached.id, planar(reached.centre_from_place)});
  }
  return found;
}

/// Adds the ways that leave `from` along `way`, or against it, for a place within the extent.
void forbid(const Snapshot& snapshot, const Beside& from, const Eigen::Vector2d& way, double sign,
            const std::set<PlaceId>& within, std::set<Span>& forbidden) {
  if (way.norm() < kLeastStep_m) return;
  snapshot.for_each_edge(from.place, [&](const Edge& edge) {
    const PlaceId to = other_end(edge, from.place);
    if (!within.contains(to)) return;
    const Pose2 there = from.named_from_place * planar(relation_from(edge, from.place));
    const Eigen::Vector2d step(there.x - from.named_from_place.x, there.y - from.named_from_place.y);
    const bool is_alike = step.norm() >= kLeastStep_m && sign * step.dot(way) > kAlike * step.norm() * way.norm();
    if (is_alike) forbidden.insert({from.place, to});
  });
}

Snapshot one_on(const Snapshot& snapshot, Snapshot::Rules rules) {
  return {{snapshot.revision().value + 1},
          snapshot.experiences(),
          snapshot.shared_labels(),
          snapshot.shared_aparts(),
          std::make_shared<const Snapshot::Rules>(std::move(rules)),
          snapshot.shared_registrations()};
}

}  // namespace

Result<void> check(const Snapshot& snapshot, const Rule& rule) {
  if (auto good = check_name("rule", rule.name); !good) return good;
  if (auto good = check_value(rule); !good) return good;
  const bool is_one_more = !snapshot.rules().contains(rule.name);
  if (is_one_more && snapshot.rules().size() >= kMostRules) {
    return fail(ErrorCode::invalid,
                "rule " + rule.name + " would be one of more than " + std::to_string(kMostRules) + ": remove others");
  }
  if (auto good = check_area(rule); !good) return good;
  return check_where(snapshot, rule);
}

RuleExtent extent_of(const Snapshot& snapshot, const Rule& rule) {
  Walk walk(snapshot, rule);
  RuleExtent extent;
  extent.problem = walk.take_problem();
  std::set<PlaceId> places;
  std::vector<std::vector<Beside>> floors;
  for (const Named& named : walk.named()) {
    floors.push_back(on_the_floor_of(snapshot, named.place));
    for (const Beside& beside : floors.back()) places.insert(beside.place);
  }
  if (is_directed(rule)) {
    std::set<Span> forbidden;
    const double sign = rule.kind == RuleKind::one_way ? -1.0 : 1.0;
    for (std::size_t at = 0; at < floors.size(); ++at) {
      for (const Beside& beside : floors[at]) {
        forbid(snapshot, beside, walk.named()[at].way, sign, places, forbidden);
      }
    }
    extent.forbidden.assign(forbidden.begin(), forbidden.end());
  }
  extent.places.assign(places.begin(), places.end());
  return extent;
}

std::set<Span> hops_on_the_floor_of(const Snapshot& snapshot, const std::vector<PlaceId>& way) {
  std::set<Span> hops;
  std::set<PlaceId> places;
  std::vector<std::vector<Beside>> floors;
  for (const PlaceId& place : way) {
    floors.push_back(on_the_floor_of(snapshot, place));
    for (const Beside& beside : floors.back()) places.insert(beside.place);
  }
  for (std::size_t at = 0; at + 1 < way.size(); ++at) {
    hops.insert({{way[at], way[at + 1]}, {way[at + 1], way[at]}});
    const Eigen::Vector2d onward = way_to(snapshot, way[at], way[at + 1]);
    const Eigen::Vector2d back = way_to(snapshot, way[at + 1], way[at]);
    for (const double sign : {1.0, -1.0}) {
      for (const Beside& beside : floors[at]) forbid(snapshot, beside, onward, sign, places, hops);
      for (const Beside& beside : floors[at + 1]) forbid(snapshot, beside, back, sign, places, hops);
    }
  }
  return hops;
}

std::vector<PlaceId> spots_of(const Snapshot& snapshot, RuleKind kind) {
  std::vector<PlaceId> spots;
  const auto add = [&](const PlaceId& place) {
    if (snapshot.place(place) != nullptr && std::ranges::find(spots, place) == spots.end()) spots.push_back(place);
  };
  for (const auto& [name, rule] : snapshot.rules()) {
    if (rule.kind != kind) continue;
    const auto label = snapshot.labels().find(rule.label);
    if (label != snapshot.labels().end()) add(label->second);
    for (const Span& span : rule.spans) add(span.to);
  }
  return spots;
}

Snapshot with_rule(const Snapshot& snapshot, const Rule& rule) {
  Snapshot::Rules rules = snapshot.rules();
  rules.insert_or_assign(rule.name, rule);
  return one_on(snapshot, std::move(rules));
}

Snapshot without_rule(const Snapshot& snapshot, const std::string& name) {
  Snapshot::Rules rules = snapshot.rules();
  rules.erase(name);
  return one_on(snapshot, std::move(rules));
}

}  // namespace weft
