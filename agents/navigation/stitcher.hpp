#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "agents/navigation/across.hpp"
#include "agents/navigation/agreement.hpp"
#include "agents/navigation/belief.hpp"
#include "agents/navigation/candidates.hpp"
#include "agents/navigation/decoded_contents.hpp"
#include "agents/navigation/held_stitches.hpp"
#include "agents/navigation/localised_around.hpp"
#include "agents/navigation/route_ahead.hpp"
#include "agents/navigation/teacher.hpp"

namespace weft::agents {

/// Joins a place just kept to places of the map (III-C: "an edge is created"). Each stitch is a relation of the two
/// contents themselves that agrees with the way there, or, where the way is too uncertain to judge (a loop closing),
/// one that agrees with the stitch found at the kept place before. Lanes that the robot cannot change over to are
/// joined by the same rules, less often: so the network says where they lie.
template <Method M>
class Stitcher {
 public:
  using Content = typename M::Content;
  struct Found {
    std::vector<Edge> edges;
    std::optional<Fix> fix;  ///< of the robot standing at the kept place: the first stitch
    std::vector<Refusal> refusals;
    HeldStitches::AtPlace of_others;  ///< without its stitches
  };
  /// Holds what becomes of the stitches of a place that was kept while teaching.
  struct Proven {
    std::vector<Edge> believed;    ///< found at this place
    std::vector<Edge> to_hand_in;  ///< of this place and of those before
    bool is_told_apart = false;    ///< from all other runs that it seemed to lie beside: nothing joins them any more
    std::optional<Fix> fix;
    std::vector<Refusal> refusals;
  };

  Stitcher(const M& method, const NavigationConfig& config)
      : method_(&method), config_(config), across_(config.stitch), held_(config.stitch) {}

  void clear() { *this = Stitcher(*method_, config_); }

  /// Looks for stitches of the place just kept: `map` holds it already, and it is the last one of `teacher`.
  Found look(const Window& map, const Contents& bytes, DecodedContents<M>& decoded, const Teacher& teacher,
             const Place& kept, const Content& content) {
    Found found;
    if (!config_.stitch.enabled) return found;
    std::set<ExperienceId> joined;
    std::uint32_t tries = config_.stitch.tries;
    const std::vector<Candidate> around = known_around(map, teacher, kept.id, content);
    const std::vector<Candidate> near = worth_comparing(around);
    if constexpr (ChartsItself<M>) {
      if (!near.empty() && std::holds_alternative<AlongPath>(near.front().place_from_robot))
        return located(map, bytes, decoded, near.front(), kept.id, content);
    }
    for (const Candidate& candidate : near) {
      if (tries == 0 || found.edges.size() >= config_.stitch.most_a_place) break;
      if (joined.contains(candidate.place.experience)) continue;
      const auto other = decoded.find(*map.place(candidate.place), bytes);
      if (!other) {
        found.refusals.push_back(other.error());
        continue;
      }
      --tries;
      const OrRefusal<Related> related = verified(map, **other, content, candidate, kept.id, pending_);
      weigh_against(**other, content, candidate, kept.id, related, found.of_others);
      if (!related) {
        found.refusals.push_back(related.error());
        continue;
      }
      joined.insert(candidate.place.experience);
      found.edges.push_back(edge(candidate.place, kept.id, *related));
      if (!found.fix) found.fix = Fix{candidate.place, related->a_from_b, *related};
    }
    if (auto crossing = across(map, bytes, decoded, without(around, found.edges), teacher, kept.id, content))
      found.edges.push_back(*std::move(crossing));
    return found;
  }

  /// Does the same while a run is taught: what stitches it to other runs is held back until it is proven, where the
  /// method can tell places apart that look alike.
  Proven prove(const Window& map, const Contents& bytes, DecodedContents<M>& decoded, const Teacher& teacher,
               const Place& kept, const Content& content) {
    Found found = look(map, bytes, decoded, teacher, kept, content);
    Proven proven{found.edges, std::move(found.edges), false, std::move(found.fix), std::move(found.refusals)};
    if constexpr (Contradicts<M>) {
      const auto others =
          std::ranges::partition(proven.to_hand_in, [](const Edge& edge) { return !is_to_another(edge); });
      found.of_others.stitches.assign(others.begin(), others.end());
      proven.to_hand_in.erase(others.begin(), others.end());
      held_.take(found.of_others, teacher.driven_m());
      if (const std::optional<Refusal> other = held_.disproved()) {
        proven.refusals.push_back(*other);
        std::erase_if(proven.believed, is_to_another);
        proven.is_told_apart = true;
        proven.fix.reset();
        pending_.reset();
        pending_across_.reset();
      }
      const std::vector<Edge> by_now = held_.proven(teacher.driven_m());
      proven.to_hand_in.insert(proven.to_hand_in.end(), by_now.begin(), by_now.end());
    }
    return proven;
  }
  /// Returns the stitches that are held back still, as the run ends.
  std::vector<Edge> rest() { return held_.rest(); }
  /// Returns the other runs that this one has been told apart from, though it looks like them.
  const std::set<ExperienceId>& told_apart() const { return held_.elsewhere(); }
  /// Returns where the map is that a run seems to lie beside, though nothing that is handed in joins it to that.
  std::optional<PlaceId> beside() const { return held_.beside(); }

  /// Returns the stitch that what was found makes.
  Edge edge(const PlaceId& older, const PlaceId& kept, const Related& related) const {
    Edge edge;
    edge.id = {older, kept};
    edge.a_from_b = related.a_from_b;
    edge.origin = Origin::stitch;
    edge.method = std::string(M::name);
    edge.drivable = can_cross(config_.stitch, related.a_from_b) ? Drivable::both : Drivable::none;
    edge.inliers = related.inliers;
    edge.overlap = static_cast<float>(std::clamp(related.overlap, 0.0, 1.0));
    return edge;
  }

 private:
  static bool is_to_another(const Edge& edge) { return edge.id.a.experience != edge.id.b.experience; }

  /// Holds a relation over an uncertain way, which waits for a second one.
  struct Pending {
    PlaceId place;
    PlaceId kept;
    Relation place_from_kept;
  };

  /// Returns all places that may be seen from here, at any heading, but for what has just been driven.
  std::vector<Candidate> known_around(const Window& map, const Teacher& teacher, const PlaceId& kept,
                                      const Content& content) const {
    constexpr std::uint32_t everywhere = 100'000;  // hops; the number of places is bounded by the window's cap
    const Estimate here{kept, Metric2{}, 0.0};
    double reach_m = config_.stitch.most_reach_m;
    if constexpr (Gazes<M>) reach_m += 2.0 * method_->gaze(content).norm();  // two robots that face one another
    std::vector<Candidate> around = at_any_heading(config_, map, here, everywhere, reach_m);
    std::erase_if(around, [&](const Candidate& candidate) {
      if (candidate.place.experience != kept.experience)
        return held_.elsewhere().contains(candidate.place.experience);
      return candidate.place.index + 1 >= kept.index ||
             teacher.driven_since_m(candidate.place.index) < config_.stitch.own_distance_m;
    });
    return around;
  }

  /// Returns those that no edge leads to yet: a pair of places has one.
  static std::vector<Candidate> without(std::vector<Candidate> around, const std::vector<Edge>& edges) {
    std::erase_if(around, [&](const Candidate& candidate) {
      return std::any_of(edges.begin(), edges.end(), [&](const Edge& edge) { return edge.id.a == candidate.place; });
    });
    return around;
  }

  /// Returns those of them that look the same way, the likeliest first.
  std::vector<Candidate> worth_comparing(std::vector<Candidate> near) const {
    std::erase_if(near, [&](const Candidate& candidate) {
      constexpr double sigmas = 3.0;
      const double reach_m = config_.stitch.reach_m + sigmas * spread_of(candidate.place_from_robot).metres;
      return candidate.cost > std::min(reach_m, config_.stitch.most_reach_m);
    });
    sort_by_cost(near);
    return near;
  }

  /// Finds a stitch to a lane that is met head-on or across. Refusals are not told: mostly nothing of it is in view.
  std::optional<Edge> across(const Window& map, const Contents& bytes, DecodedContents<M>& decoded,
                             const std::vector<Candidate>& around, const Teacher& teacher, const PlaceId& kept,
                             const Content& content) {
    if constexpr (Gazes<M>) {
      for (const Candidate& candidate : across_.worth_comparing(around, method_->gaze(content), teacher.driven_m())) {
        const auto other = decoded.find(*map.place(candidate.place), bytes);
        if (!other) continue;
        const OrRefusal<Related> related = verified(map, **other, content, candidate, kept, pending_across_);
        if (!related) continue;
        across_.joined(related->a_from_b, teacher.driven_m());
        return edge(candidate.place, kept, *related);
      }
    }
    return std::nullopt;
  }

  /// Finds a stitch along a path: two contents alone do not say how far apart along it they are, but the method does,
  /// in a chart of that path.
  Found located(const Window& map, const Contents& bytes, DecodedContents<M>& decoded, const Candidate& candidate,
                const PlaceId& kept, const Content& content) requires ChartsItself<M> {
    Found found;
    const OrRefusal<Fix> fix = localised_around(
        *method_, map, bytes, decoded, {candidate.place, candidate.place_from_robot, 0.0}, content, kept.experience);
    if (!fix) {
      found.refusals.push_back(fix.error());
      return found;
    }
    // Who cannot say how far along it is, joins nothing: what looks alike may be metres on.
    const double sigma_m = spread_of(fix->place_from_robot).metres;
    if (sigma_m > config_.stitch.sure_m) {
      found.refusals.push_back({"unsure_how_far", sigma_m, config_.stitch.sure_m});
      return found;
    }
    const auto there_from_place = between(config_.belief, map, candidate.place, fix->place, config_.locate.most_hops);
    const Difference spread = spread_of(candidate.place_from_robot);
    const std::optional<Refusal> refusal =
        there_from_place
            ? agreement(candidate.place_from_robot, compose(*there_from_place, fix->place_from_robot),
                        config_.stitch.agree_m + 2.0 * spread.metres, config_.stitch.agree_rad + 2.0 * spread.radians)
            : Refusal{"fix_not_joined"};
    if (refusal) {
      found.refusals.push_back(*refusal);
      return found;
    }
    found.edges.push_back(edge(fix->place, kept, fix->evidence));
    found.fix = fix.value();
    return found;
  }

  OrRefusal<Related> verified(const Window& map, const Content& other, const Content& content,
                              const Candidate& candidate, const PlaceId& kept, std::optional<Pending>& pending) {
    const Difference spread = spread_of(candidate.place_from_robot);
    const bool trusted = is_trusted(candidate);
    const std::optional<Relation> guess = trusted ? std::optional(candidate.place_from_robot) : std::nullopt;
    OrRefusal<Related> related = method_->relate(other, content, guess);
    if (!related) return related;
    // A robot may be found where something has come or gone; maps are joined only by what is as it was.
    if (!trusted && related->doubt > config_.stitch.most_doubt)
      return tl::unexpected(Refusal{"doubtful", related->doubt, config_.stitch.most_doubt});
    const auto agrees = [&](const Relation& predicted, const Difference& allowance) {
      return agreement(predicted, related->a_from_b, config_.stitch.agree_m + allowance.metres,
                       config_.stitch.agree_rad + allowance.radians);
    };
    if (trusted) {
      const std::optional<Refusal> refusal = agrees(candidate.place_from_robot, spread);
      if (refusal) return tl::unexpected(*refusal);
      return related;
    }
    const std::optional<Relation> expected = through_pending(map, candidate.place, kept, pending);
    const bool confirmed = expected && !agrees(*expected, {});
    pending = Pending{candidate.place, kept, related->a_from_b};
    if (confirmed) return related;
    return tl::unexpected(Refusal{"stitch_unconfirmed", spread.metres, config_.stitch.trusted_sigma_m});
  }

  bool is_trusted(const Candidate& candidate) const {
    return spread_of(candidate.place_from_robot).metres <= config_.stitch.trusted_sigma_m;
  }

  /// Notes what speaks against two places of two runs lying to each other as was found, or else as is believed for
  /// sure. Of several places of a run the one counts that most speaks against.
  void weigh_against(const Content& other, const Content& content, const Candidate& candidate, const PlaceId& kept,
                     const OrRefusal<Related>& related, HeldStitches::AtPlace& found) const {
    if constexpr (Contradicts<M>) {
      const ExperienceId run = candidate.place.experience;
      if (run == kept.experience || (!related && !is_trusted(candidate))) return;
      found.is_beside = true;
      double& most = found.contradictions[run];
      most = std::max(
          most, method_->contradiction(other, content, related ? related->a_from_b : candidate.place_from_robot));
    }
  }

  /// Returns place_from_kept as the pending stitch and the chains between both pairs of places say.
  std::optional<Relation> through_pending(const Window& map, const PlaceId& place, const PlaceId& kept,
                                          const std::optional<Pending>& pending) const {
    constexpr std::uint32_t hops = 8;
    if (!pending || pending->kept == kept) return std::nullopt;
    const auto place_from_there = between(config_.belief, map, place, pending->place, hops);
    const auto there_from_kept = between(config_.belief, map, pending->kept, kept, hops);
    if (!place_from_there || !there_from_kept) return std::nullopt;
    return compose(compose(*place_from_there, pending->place_from_kept), *there_from_kept);
  }

  const M* method_;
  NavigationConfig config_;
  Across across_;
  HeldStitches held_;
  std::optional<Pending> pending_;
  std::optional<Pending> pending_across_;
};

}  // namespace weft::agents
