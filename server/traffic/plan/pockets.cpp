#include "server/traffic/plan/pockets.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <limits>
#include <set>

namespace weft::server {
namespace {

/// Bounds how many berths are looked at around one.
constexpr std::size_t kBall = 200;
/// Bounds how many berths a lane and what is at its end have together, for one robot in all of them, where robots
/// could pass each other at its end.
constexpr std::size_t kWideEnd = 30;

/// Returns the berths beside that one, and those that a drive joins with it, sorted.
std::vector<Berth> joined_with(BerthGraph& graph, Berth here, std::uint32_t methods) {
  std::set<Berth> all(graph.beside(here).begin(), graph.beside(here).end());
  for (const BerthArc& arc : graph.next(here, methods)) all.insert(arc.to);
  for (const BerthGraph::Before& arc : graph.before(here, methods)) all.insert(arc.from);
  all.erase(here);
  return {all.begin(), all.end()};
}

/// Holds the berths around one, with who is joined with whom, and which of them lead on beyond.
class Ball {
 public:
  Ball(BerthGraph& graph, Berth centre, std::uint32_t methods) : graph_(graph), methods_(methods), centre_(centre) {
    std::deque<Berth> open = {centre};
    before_[centre] = centre;
    while (!open.empty() && joined_.size() < kBall) {
      const Berth here = open.front();
      open.pop_front();
      last_ = here;
      joined_[here] = joined_with(graph, here, methods);
      for (const Berth there : joined_[here]) {
        if (before_.emplace(there, here).second) open.push_back(there);
      }
    }
    outside_.insert(open.begin(), open.end());
    farthest_ = open.empty() ? last_ : open.front();
  }

  /// Returns the shortest way from the centre to what lies beyond, or to the farthest berth where nothing does.
  std::vector<Berth> way_out() const {
    std::vector<Berth> way;
    for (Berth here = farthest_; here != centre_; here = before_.at(here)) way.push_back(here);
    std::reverse(way.begin(), way.end());
    return way;
  }

  /// Returns what hangs together with the centre when nobody passes those; none: what lies beyond does, too, or more
  /// than half of all.
  std::optional<std::vector<Berth>> cut_off_by(const std::vector<Berth>& blocked) const {
    std::set<Berth> seen = {centre_};
    std::deque<Berth> open = {centre_};
    while (!open.empty()) {
      const Berth here = open.front();
      open.pop_front();
      if (outside_.contains(here) || 2 * seen.size() > before_.size()) return std::nullopt;
      for (const Berth there : joined_.at(here)) {
        if (!std::binary_search(blocked.begin(), blocked.end(), there) && seen.insert(there).second) {
          open.push_back(there);
        }
      }
    }
    return std::vector<Berth>(seen.begin(), seen.end());
  }

  enum class Way : std::uint8_t { out, in };
  /// Returns the first berth of `mouth` that a robot can drive out to from the centre, through `inside`, or from
  /// which it can drive in to the centre; none: there is none.
  std::optional<Berth> leads(Way way, const std::vector<Berth>& inside, const std::vector<Berth>& mouth) const {
    std::set<Berth> seen = {centre_};
    std::deque<Berth> open = {centre_};
    while (!open.empty()) {
      const Berth here = open.front();
      open.pop_front();
      if (std::binary_search(mouth.begin(), mouth.end(), here)) return here;
      if (!std::binary_search(inside.begin(), inside.end(), here)) continue;
      const auto go_to = [&](Berth there) {
        if (seen.insert(there).second) open.push_back(there);
      };
      if (way == Way::out) {
        for (const BerthArc& arc : graph_.next(here, methods_)) go_to(arc.to);
      } else {
        for (const BerthGraph::Before& arc : graph_.before(here, methods_)) go_to(arc.from);
      }
    }
    return std::nullopt;
  }

  /// Returns whether two robots cannot pass each other in there: berths as deep as each other are beside each other.
  /// They may be able to pass in what lies deeper than the centre, where that is small: a robot that stands in a lane
  /// keeps others from its end.
  bool is_narrow(const std::vector<Berth>& inside, const std::vector<Berth>& mouth) const {
    std::map<Berth, double> depth_m;
    std::set<std::pair<double, Berth>> open;
    double shortest_m = std::numeric_limits<double>::infinity();
    for (const Berth berth : mouth) open.insert({0.0, berth});
    while (!open.empty()) {
      const auto [here_m, here] = *open.begin();
      open.erase(open.begin());
      if (!depth_m.emplace(here, here_m).second) continue;
      const auto reach = [&, here_m = here_m](Berth there, double length_m) {
        if (!std::binary_search(inside.begin(), inside.end(), there)) return;
        const std::vector<Berth>& beside = graph_.beside(here);
        const bool is_move = !std::binary_search(beside.begin(), beside.end(), there);
        if (is_move) shortest_m = std::min(shortest_m, length_m);
        open.insert({here_m + length_m, there});
      };
      for (const BerthArc& arc : graph_.next(here, methods_)) {
        if (graph_.is_cut(arc.to)) reach(arc.to, arc.length_m);
      }
      for (const BerthGraph::Before& arc : graph_.before(here, methods_)) reach(arc.from, arc.length_m);
    }
    const auto centre = depth_m.find(centre_);
    const bool may_be_wide = centre != depth_m.end() && inside.size() <= kWideEnd;
    for (auto a = depth_m.begin(); a != depth_m.end(); ++a) {
      if (may_be_wide && a->second > centre->second + shortest_m / 2.0) continue;
      const std::vector<Berth>& beside = graph_.beside(a->first);
      for (auto b = std::next(a); b != depth_m.end(); ++b) {
        const bool is_as_deep = std::abs(a->second - b->second) < shortest_m / 2.0;
        const bool is_inside = a->second > 0.0 && b->second > 0.0;
        if (is_inside && is_as_deep && !std::binary_search(beside.begin(), beside.end(), b->first)) return false;
      }
    }
    return true;
  }

 private:
  BerthGraph& graph_;
  std::uint32_t methods_;
  Berth centre_;
  Berth last_ = kNoBerth;
  Berth farthest_ = kNoBerth;
  std::map<Berth, Berth> before_;
  std::map<Berth, std::vector<Berth>> joined_;
  std::set<Berth> outside_;
};

std::vector<Berth> standing_in(BerthGraph& graph, Berth berth) {
  std::vector<Berth> all = graph.beside(berth);
  all.insert(std::upper_bound(all.begin(), all.end(), berth), berth);
  return all;
}

}  // namespace

std::optional<Pocket> pocket_around(BerthGraph& graph, Berth berth, std::uint32_t methods) {
  const Ball ball(graph, berth, methods);
  std::optional<Pocket> largest;
  for (const Berth mouth : ball.way_out()) {
    const std::vector<Berth> blocked = standing_in(graph, mouth);
    if (std::binary_search(blocked.begin(), blocked.end(), berth)) continue;
    std::optional<std::vector<Berth>> inside = ball.cut_off_by(blocked);
    if (!inside || !ball.leads(Ball::Way::in, *inside, blocked) || !ball.is_narrow(*inside, blocked)) break;
    const std::optional<Berth> exit = ball.leads(Ball::Way::out, *inside, blocked);
    if (!exit) break;
    largest = Pocket{.exit = *exit, .at_mouth = blocked, .inside = *std::move(inside)};
  }
  return largest;
}

bool Pockets::look_around(Berth berth, std::uint32_t methods, std::size_t most) {
  if (of_.contains(berth)) return true;
  if (around_.reached.empty() || around_.reached.front() != berth || around_.methods != methods)
    around_ = {.reached = {berth}, .seen = {berth}, .methods = methods};
  for (; around_.next < std::min(around_.reached.size(), kBall); ++around_.next, --most) {
    if (most == 0) return false;
    for (const Berth there : joined_with(graph_, around_.reached[around_.next], methods)) {
      if (around_.seen.insert(there).second) around_.reached.push_back(there);
    }
  }
  return true;
}

std::uint32_t Pockets::look(Berth berth, std::uint32_t methods) {
  const auto known = of_.find(berth);
  if (known != of_.end()) return known->second;
  std::optional<Pocket> pocket = pocket_around(graph_, berth, methods);
  if (!pocket) return of_[berth] = kNone;
  // Takes what overlaps with a known pocket for a part of it, seen from elsewhere.
  const auto same = std::find_if(pocket->inside.begin(), pocket->inside.end(),
                                 [this](Berth inside) { return of(inside) != kNone; });
  const auto number = same == pocket->inside.end() ? static_cast<std::uint32_t>(pockets_.size()) : of(*same);
  if (same == pocket->inside.end()) pockets_.push_back(*pocket);
  for (const Berth inside : pocket->inside) {
    std::uint32_t& known_as = of_.try_emplace(inside, kNone).first->second;
    if (known_as == kNone) known_as = number;
  }
  return of_[berth] = number;
}

std::uint32_t Pockets::of(Berth berth) const {
  const auto known = of_.find(berth);
  return known == of_.end() ? kNone : known->second;
}

bool Pockets::is_at_mouth(std::uint32_t pocket, Berth berth) const {
  const std::vector<Berth>& mouth = pockets_[pocket].at_mouth;
  return std::binary_search(mouth.begin(), mouth.end(), berth);
}

bool Pockets::leads_only_into(std::uint32_t pocket, Berth from, std::uint32_t methods) const {
  const std::vector<BerthArc>& ways = graph_.next(from, methods);
  return std::all_of(ways.begin(), ways.end(), [&](const BerthArc& arc) { return of(arc.to) == pocket; });
}

Distances& Pockets::to_mouth(std::uint32_t pocket, std::uint32_t methods) {
  std::unique_ptr<Distances>& known = to_mouth_[{pocket, methods}];
  if (known == nullptr) {
    known = std::make_unique<Distances>(graph_, pockets_[pocket].exit, methods, nothing_);
  }
  return *known;
}

void Pockets::clear() {
  around_ = {};
  pockets_.clear();
  of_.clear();
  to_mouth_.clear();
}

}  // namespace weft::server
