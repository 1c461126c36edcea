#pragma once
#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <utility>
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
  void stand() {}
  void believed(const Estimate&) {}
  void found(const Estimate&) {}
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
  /// Takes note that where the robot is has been expressed by another place. A belief that is carried on stays.
  void stand() {
    if constexpr (!CarriesBelief<M>) forget();
  }
  /// Replaces the method's belief once navigation has weighed its fix.
  void believed(const Estimate& estimate) {
    if (is_placed_) belief_ = method_->believed(*chart_, *belief_, estimate);
  }
  /// Takes note that the robot was found by a search, which may be elsewhere: a belief is not carried there.
  void found(const Estimate& estimate) {
    if constexpr (CarriesBelief<M>) return forget();
    believed(estimate);
  }

  /// Returns whether there is a chart of which that place is in the middle.
  bool covers(const PlaceId& place) const { return is_placed_ && inside_.contains(place); }

  /// Makes the chart around the estimate unless it is still right. `without`: places of that experience are left out.
  void prepare(const Window& map, const Contents& bytes, DecodedContents<M>& decoded, const Estimate& estimate,
               const std::optional<ExperienceId>& without = std::nullopt) {
    if (covers(estimate.place) && made_of_.is_same(around(map, made_of_.places.front().id), bytes)) return;
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
    auto chart = std::make_shared<const typename M::Chart>(method_->chart(charted));
    move_to(*chart, estimate);
    chart_ = std::move(chart);
  }

  /// Returns what is believed of where the robot is, in the chart; none: there is no chart of where it is.
  std::optional<Around<M>> around(const Estimate& estimate) const {
    if (!is_placed_) return std::nullopt;
    const auto at = std::find_if(made_of_.places.begin(), made_of_.places.end(),
                                 [&](const Reached& reached) { return reached.id == estimate.place; });
    if (at == made_of_.places.end()) return std::nullopt;
    return Around<M>{chart_.get(), &*belief_, planar(compose(at->centre_from_place, estimate.place_from_robot))};
  }
  /// Returns the places that the chart is made of, its centre first.
  const std::vector<Reached>& places() const { return made_of_.places; }

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

  /// Goes on in another chart. A belief that is carried there is one of the last look: the steps since then are still
  /// to be told, and where the robot is said to be is without them.
  void move_to(const typename M::Chart& chart, const Estimate& estimate) {
    if constexpr (CarriesBelief<M>) {
      if (is_placed_) {
        belief_ = method_->carried(chart, since_ ? before(estimate, *since_) : estimate, *belief_);
        return;
      }
    }
    belief_ = begun(chart, estimate);
    is_placed_ = true;
    since_.reset();
  }

  /// Returns where the robot was before a step, no surer of it than now.
  static Estimate before(const Estimate& now, const Step& step) {
    return {now.place, compose(now.place_from_robot, inverse(step.previous_from_current)),
            std::max(0.0, now.blind_m - distance_m(step.previous_from_current))};
  }

  Belief begun(const typename M::Chart& chart, const Estimate& estimate) const {
    if constexpr (Remembers<M>) {
      if (belief_) return method_->begin(chart, estimate, *belief_);
    }
    return method_->begin(chart, estimate);
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
