#pragma once
#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "agents/methods/advance.hpp"
#include "agents/navigation/decoded_contents.hpp"
#include "core/network/search.hpp"

namespace weft::agents {

/// Holds the chart and belief of a method that localises in its own way; nothing for the others.
template <class M>
class Charted {
 public:
  explicit Charted(const M&) {}
  void advance(const Step&) {}
  void forget() {}
  void believed(const Estimate&) {}
};

/// Makes the chart anew when the robot has left its middle or the map around it has changed, and hands on to the
/// method all motion since its last look.
template <ChartsItself M>
class Charted<M> {
 public:
  using Content = typename M::Content;
  using Belief = typename M::Belief;

  explicit Charted(const M& method) : method_(&method) {}

  void advance(const Step& step) { since_ = since_ ? joined(*since_, step) : step; }
  /// Forgets where the robot is, not what else the method has come to believe on its way.
  void forget() { is_placed_ = false; }
  /// Replaces the method's belief once navigation has weighed its fix.
  void believed(const Estimate& estimate) {
    if (is_placed_) belief_ = method_->believed(*chart_, *belief_, estimate);
  }

  /// Makes the chart around the estimate unless it is still right. `without`: places of that experience are left out.
  void prepare(const Window& map, const Contents& bytes, DecodedContents<M>& decoded, const Estimate& estimate,
               const std::optional<ExperienceId>& without = std::nullopt) {
    const bool in_the_middle = is_placed_ && inside_.contains(estimate.place);
    if (in_the_middle && made_of_.is_same(around(map, made_of_.places.front().id), bytes)) return;
    made_of_ = {around(map, estimate.place), {}};
    inside_.clear();
    std::vector<ChartPlace<Content>> charted;
    for (const Reached& reached : made_of_.places) {
      if (reached.depth <= M::chart_size.hops / 2) inside_.insert(reached.id);
      if (reached.id.experience == without) continue;
      const Place& place = *map.place(reached.id);
      const auto content = decoded.find(place, bytes);
      if (!content && !bytes.find(place.content.hash)) made_of_.missing.push_back(place.content.hash);
      charted.push_back({reached.id, reached.depth, reached.centre_from_place, content ? *content : nullptr});
    }
    chart_ = std::make_shared<const typename M::Chart>(method_->chart(charted));
    belief_ = begun(estimate);
    is_placed_ = true;
    since_.reset();
  }

  /// Locates a view, after `prepare`. The belief is the method's own; what the robot believes is in agents' Belief.
  Located<Belief> locate(const Content& seen) {
    Located<Belief> located = method_->locate(*chart_, *belief_, since_.value_or(Step{Metric2{}, true, {}}), seen);
    belief_ = located.belief;
    since_.reset();
    return located;
  }

 private:
  /// Keeps the places that a chart is made of, to find whether they are still the same. The window's revision does
  /// not tell: the window changes far from here, and moves within one revision.
  struct Made {
    std::vector<Reached> places;
    std::vector<ContentHash> missing;  ///< had not arrived
    bool is_same(const std::vector<Reached>& now, const Contents& bytes) const {
      return std::equal(places.begin(), places.end(), now.begin(), now.end(),
                        [](const Reached& a, const Reached& b) {
                          return a.id == b.id && identical(a.centre_from_place, b.centre_from_place);
                        }) &&
             std::none_of(missing.begin(), missing.end(), [&](const ContentHash& hash) { return bytes.find(hash); });
    }
  };
  static std::vector<Reached> around(const Window& map, const PlaceId& centre) {
    return breadth_first(map, centre, M::chart_size.hops, M::chart_size.places);
  }

  Belief begun(const Estimate& estimate) const {
    if constexpr (Remembers<M>) {
      if (belief_) return method_->begin(*chart_, estimate, *belief_);
    }
    return method_->begin(*chart_, estimate);
  }

  const M* method_;
  std::shared_ptr<const typename M::Chart> chart_;  // in use until another one is made
  std::optional<Belief> belief_;
  bool is_placed_ = false;  // belief_ is of where the robot is, in chart_
  Made made_of_;
  std::set<PlaceId> inside_;  // the middle of the chart
  std::optional<Step> since_;
};

}  // namespace weft::agents
