#pragma once
#include <optional>
#include <set>
#include <vector>

#include "agents/methods/advance.hpp"
#include "agents/navigation/decoded_contents.hpp"
#include "core/network/search.hpp"

namespace weft::agents {

/// The chart and belief of a method that localises in its own way; nothing for the others.
template <class M>
class Charted {
 public:
  explicit Charted(const M&) {}
  void advance(const Step&) {}
  void forget() {}
  void believed(const Estimate&) {}
};

/// Makes the chart anew when the robot has left its middle or the window has changed, and hands on to the method all
/// motion since its last look.
template <ChartsItself M>
class Charted<M> {
 public:
  using Content = typename M::Content;
  using Belief = typename M::Belief;

  explicit Charted(const M& method) : method_(&method) {}

  void advance(const Step& step) { since_ = since_ ? joined(*since_, step) : step; }
  void forget() { belief_.reset(); }
  /// What is believed after a fix has been weighed.
  void believed(const Estimate& estimate) {
    if (belief_) belief_ = method_->believed(*chart_, *belief_, estimate);
  }

  /// `without`: places of that experience are left out.
  void prepare(const Window& map, const Contents& bytes, DecodedContents<M>& decoded, const Estimate& estimate,
               const std::optional<ExperienceId>& without = std::nullopt) {
    const Made now{estimate.place, map.revision, map.places.size(), map.edges.size()};
    if (belief_ && made_of_.same_map(now) && inside_.contains(estimate.place)) return;
    made_of_ = now;
    inside_.clear();
    std::vector<ChartPlace<Content>> around;
    for (const Reached& reached : breadth_first(map, estimate.place, chart_hops, chart_places)) {
      if (reached.id.experience == without) continue;
      const auto content = decoded.find(*map.place(reached.id), bytes);
      around.push_back({reached.id, reached.depth, reached.centre_from_place, content ? *content : nullptr});
      if (reached.depth <= chart_hops / 2) inside_.insert(reached.id);
    }
    chart_ = method_->chart(around);
    belief_ = method_->begin(*chart_, estimate);
    since_.reset();
  }

  /// After `prepare`. The belief is the method's own; what the robot believes stays in agents' Belief.
  Located<Belief> locate(const Content& seen) {
    Located<Belief> located = method_->locate(*chart_, *belief_, since_.value_or(Step{Metric2{}, true, {}}), seen);
    belief_ = located.belief;
    since_.reset();
    return located;
  }

 private:
  static constexpr std::uint32_t chart_hops = 12;
  static constexpr std::uint32_t chart_places = 200;
  struct Made {
    PlaceId centre;
    Revision revision;
    std::size_t places = 0;
    std::size_t edges = 0;
    bool same_map(const Made& other) const {
      return revision == other.revision && places == other.places && edges == other.edges;
    }
  };

  const M* method_;
  std::optional<typename M::Chart> chart_;
  std::optional<Belief> belief_;
  Made made_of_;
  std::set<PlaceId> inside_;  // the middle of the chart
  std::optional<Step> since_;
};

}  // namespace weft::agents
