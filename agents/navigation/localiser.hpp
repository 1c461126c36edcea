#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "agents/navigation/agreement.hpp"
#include "agents/navigation/belief.hpp"
#include "agents/navigation/candidates.hpp"
#include "agents/navigation/charted.hpp"
#include "agents/navigation/decoded_contents.hpp"
#include "agents/navigation/recognition_query.hpp"
#include "agents/navigation/relocalisation_queue.hpp"
#include "agents/navigation/rivals.hpp"
#include "agents/navigation/settled.hpp"

namespace weft::agents {

/// Keeps a robot's belief: fixes while it is known where it is (the default `locate`, or the method's own), and the
/// search when it is not.
template <Method M>
class Localiser {
 public:
  using Content = typename M::Content;
  struct Outcome {
    std::optional<Fix> fix;  ///< as believed
    std::vector<Refusal> refusals;
  };

  Localiser(const M& method, const NavigationConfig& config)
      : method_(&method),
        config_(config),
        belief_(config.belief, is_posterior<M>()),
        charted_(method),
        doubt_(method) {}

  const std::optional<Estimate>& estimate() const { return belief_.estimate(); }
  bool seeking() const { return seek_.active(); }
  std::uint32_t samples_since_attempt() const { return since_samples_; }

  void advance(const Step& step) {
    belief_.advance(step);
    charted_.advance(step);
    query_.advance(step);
    if (belief_.proposed()) ++suspected_samples_;
    since_m_ += distance_m(step.previous_from_current);
    since_rad_ += std::abs(heading_rad(step.previous_from_current));
    ++since_samples_;
  }

  /// Forgets what is believed and looks around a seed or everywhere.
  void seek(const std::optional<PlaceId>& seed) {
    belief_.forget();
    charted_.forget();
    query_.forget();
    doubt_.close();
    seek_.start(seed);
  }
  /// Looks everywhere, nearest to what was believed last first.
  void seek_again() {
    query_.forget();
    doubt_.close();
    if constexpr (ComparesRivals<M>) belief_.withdraw();  // nothing that was not weighed is confirmed
    seek_.start(std::nullopt);
  }

  /// Relies on what is believed again, if anything is.
  void stop_looking() {
    if (estimate()) seek_.end();
  }

  /// Leaves this run out of every search: what is being taught looks for what else it can be joined to.
  void leave_out(const ExperienceId& run) { seek_.leave_out(run); }

  /// Returns the open question which places look like what is seen; null: nothing is to be asked.
  const Question* question() const { return seek_.active() ? query_.open() : nullptr; }
  void propose(std::uint64_t question, const std::vector<PlaceId>& places) {
    if (query_.answered(question, places.size())) seek_.proposed() = places;
  }
  /// Returns the place of a fix that waits for a second one.
  std::optional<PlaceId> suspected() const {
    if (!seek_.active() || !belief_.proposed()) return std::nullopt;
    return belief_.proposed()->place;
  }

  void set(const Fix& fix) {
    belief_.set(fix);
    charted_.forget();
    seek_.end();
  }

  /// Expresses the same belief relative to another place.
  void stand(const Estimate& estimate) {
    belief_.stand(estimate);
    charted_.stand();
  }
  /// Takes over an estimate from another navigator or the agent, with the uncertainty that it states, and ends the
  /// search.
  void believe(const Estimate& told) {
    set(Fix{told.place, told.place_from_robot, {}});
    stand(told);
  }
  void forget() {
    belief_.forget();
    charted_.forget();
    seek_.end();
  }

  /// Returns whether an attempt is worth its cost now. `soon`: standing where a fix is waited for.
  bool due(bool soon) const {
    if (seek_.active()) return true;
    if (!estimate()) return false;
    constexpr std::uint32_t soon_samples = 2;
    return since_m_ >= config_.locate.every_m || since_rad_ >= config_.locate.every_rad ||
           since_samples_ >=
               (soon ? std::min(soon_samples, config_.locate.standing_samples) : config_.locate.standing_samples);
  }

  /// Returns the chart around the robot; none: there is none. Where a belief goes on from chart to chart one is made
  /// at once; else it begins at the next attempt, with what is known then.
  std::optional<Around<M>> around(const Window& map, const Contents& bytes,
                                  DecodedContents<M>& decoded) requires ChartsItself<M> {
    if (!estimate()) return std::nullopt;
    if constexpr (CarriesBelief<M>) {
      if (!charted_.covers(estimate()->place)) charted_.prepare(map, bytes, decoded, *estimate());
    }
    return charted_.around(*estimate());
  }

  Outcome attempt(const Content& seen, const Window& map, const Contents& bytes, DecodedContents<M>& decoded,
                  const std::set<PlaceId>& preferred) {
    since_m_ = since_rad_ = 0.0;
    since_samples_ = 0;
    Outcome outcome;
    if (seek_.active()) {
      search(seen, map, bytes, decoded, outcome);
    } else if (estimate()) {
      come_nearer(map);
      if constexpr (ChartsItself<M>) {
        chart(seen, map, bytes, decoded, outcome);
      } else {
        track(seen, map, bytes, decoded, preferred, outcome);
      }
    }
    return outcome;
  }

 private:
  /// Re-anchors an estimate whose place is out of reach, because nothing nearer was there, to a nearer place as soon
  /// as the window has one.
  void come_nearer(const Window& map) {
    const double apart_m = norm(estimate()->place_from_robot);
    if (apart_m <= config_.locate.reach_m) return;
    const std::vector<Candidate> near = candidates(config_, map, *estimate(), config_.locate.most_hops, apart_m, {});
    if (near.empty() || near.front().place == estimate()->place) return;
    stand({near.front().place, near.front().place_from_robot, estimate()->blind_m});
  }

  /// Runs the default `locate` (III-C): relates the best candidates by predicted norm, with the prediction as guess.
  void track(const Content& seen, const Window& map, const Contents& bytes, DecodedContents<M>& decoded,
             const std::set<PlaceId>& preferred, Outcome& outcome) {
    const double blind_m = estimate()->blind_m;
    const std::vector<Candidate> near = candidates(config_, map, *estimate(), search_hops(config_, blind_m),
                                                   search_reach_m(config_, blind_m), preferred);
    if (near.empty()) {
      outcome.refusals.push_back({"nothing_near", 0.0, search_reach_m(config_, blind_m)});
      return;
    }
    std::uint32_t tries = config_.locate.tries;
    for (const Candidate& candidate : near) {
      if (tries == 0) return;
      const auto content = decoded.find(*map.place(candidate.place), bytes);
      if (!content) {
        outcome.refusals.push_back(content.error());
        continue;
      }
      --tries;
      const OrRefusal<Related> related = method_->relate(**content, seen, candidate.place_from_robot);
      if (!related) {
        outcome.refusals.push_back(related.error());
        continue;
      }
      if (take(belief_.correct({candidate.place, related->a_from_b, *related}, candidate.place_from_robot, map),
               outcome)) {
        return;
      }
    }
  }

  /// Runs the method's own `locate`. Its fixes pass the same test as those of the default.
  void chart(const Content& seen, const Window& map, const Contents& bytes, DecodedContents<M>& decoded,
             Outcome& outcome) requires ChartsItself<M> {
    charted_.prepare(map, bytes, decoded, *estimate());
    Located<typename M::Belief> located = charted_.locate(seen);
    outcome.refusals.insert(outcome.refusals.end(), located.refusals.begin(), located.refusals.end());
    if (!located.fix) return;
    const auto fix_from_believed =
        between(config_.belief, map, located.fix->place, estimate()->place, config_.locate.most_hops);
    if (!fix_from_believed) {
      outcome.refusals.push_back({"fix_not_joined"});
      return;
    }
    take(belief_.correct(*located.fix, compose(*fix_from_believed, estimate()->place_from_robot), map), outcome);
  }

  void search(const Content& seen, const Window& map, const Contents& bytes, DecodedContents<M>& decoded,
              Outcome& outcome) {
    std::uint32_t tries = config_.locate.seek_tries;
    if (belief_.proposed()) {
      if (waits_for_neighbours(map, bytes)) return;
      if (is_in_doubt(map, bytes, decoded, tries, outcome)) return;
      if (confirm(seen, map, bytes, decoded, tries, outcome)) return;
    }
    const OrRefusal<void> prepared = seek_.prepare(config_, map, estimate());
    if (!seek_.seeded() && !seek_.looks_near()) {
      request_candidates(seen);
      if (try_proposed(seen, map, bytes, decoded, tries, outcome) || !seek_.proposed().empty()) return;
    }
    if (!prepared) {
      outcome.refusals.push_back(prepared.error());
      return;
    }
    if (!order_by_signature(seen, map, bytes, decoded)) return;
    while (tries > 0) {
      const std::optional<PlaceId> id = seek_.next();
      if (!id) return;
      if (try_place(*id, seen, map, bytes, decoded, tries, outcome)) return;
    }
  }

  /// Keeps a question open while there is nothing proposed left to try for where the robot stands now.
  void request_candidates(const Content& seen) {
    if (query_.is_stale()) seek_.proposed().clear();
    const bool has_places = !seek_.proposed().empty();
    if (query_.is_due(has_places)) {
      if (std::optional<Signature> here = method_->sign(seen))
        query_.ask(*std::move(here), M::name, M::content_format);
    } else if (!has_places && query_.may_go_on()) {
      query_.ask_on();
    }
  }

  /// Tries the proposed places whose content is there; the others stay for later. Returns true when this sample is
  /// done.
  bool try_proposed(const Content& seen, const Window& map, const Contents& bytes, DecodedContents<M>& decoded,
                    std::uint32_t& tries, Outcome& outcome) {
    std::vector<PlaceId>& open = seek_.proposed();
    for (auto at = open.begin(); at != open.end() && tries > 0;) {
      if (!is_readable(*at, map, bytes)) {
        ++at;
        continue;
      }
      const PlaceId id = *at;
      at = open.erase(at);
      if (try_place(id, seen, map, bytes, decoded, tries, outcome)) return true;
    }
    return false;
  }

  static bool is_readable(const PlaceId& id, const Window& map, const Contents& bytes) {
    const Place* const place = map.place(id);
    return place != nullptr && bytes.find(place->content.hash) != nullptr;
  }

  /// Returns whether a suspected place waits for its neighbours: the window of a robot that looks at proposed places
  /// has few others, and what lies around comes a little later. Until then the place itself would confirm what it
  /// said before.
  bool waits_for_neighbours(const Window& map, const Contents& bytes) const {
    constexpr std::uint32_t patience = 60;  // samples; some places have no neighbours
    if (query_.open() == nullptr && !query_.may_go_on()) return false;
    if (suspected_samples_ > patience) return false;
    const PlaceId at = belief_.proposed()->place;
    bool has_neighbour = false;
    map.for_each_edge(
        at, [&](const Edge& edge) { has_neighbour = has_neighbour || is_readable(other_end(edge, at), map, bytes); });
    return !has_neighbour;
  }

  /// Looks for a second fix beside the one proposed: at its neighbours first, as the same two views would make the
  /// same mistake again.
  bool confirm(const Content& seen, const Window& map, const Contents& bytes, DecodedContents<M>& decoded,
               std::uint32_t& tries, Outcome& outcome) {
    constexpr std::uint32_t hops = 3;
    constexpr std::size_t most = 5;
    const Fix proposed = *belief_.proposed();
    std::vector<Candidate> near =
        candidates(config_, map, {proposed.place, proposed.place_from_robot, 0.0}, hops, config_.locate.reach_m, {});
    std::stable_partition(near.begin(), near.end(),
                          [&](const Candidate& candidate) { return candidate.place != proposed.place; });
    if (near.size() > most) near.erase(near.begin() + most - 1, near.end() - 1);
    for (const Candidate& candidate : near) {
      if (tries == 0) return false;
      if (try_place(candidate.place, seen, map, bytes, decoded, tries, outcome)) return true;
    }
    return false;
  }

  /// Tries to find a fix at a place. Returns true when this sample is done: one was found, believed or not.
  bool try_place(const PlaceId& id, const Content& seen, const Window& map, const Contents& bytes,
                 DecodedContents<M>& decoded, std::uint32_t& tries, Outcome& outcome) {
    const Place* const place = map.place(id);
    if (place == nullptr || seek_.leaves_out(id)) return false;
    const auto content = decoded.find(*place, bytes);
    if (!content) {
      outcome.refusals.push_back(content.error());
      return false;
    }
    --tries;
    const OrRefusal<Fix> fix = look_at(id, **content, seen, map, bytes, decoded);
    if (!fix) {
      outcome.refusals.push_back(fix.error());
      return false;
    }
    const bool looked_everywhere = !seek_.seeded();
    const std::uint32_t least = ComparesRivals<M> ? 2 : 1;  // the second one after the first has been weighed
    const std::uint32_t needed = looked_everywhere ? std::max(least, config_.belief.unseeded_fixes) : 1;
    suspected_samples_ = 0;
    const Belief before = belief_;
    if (const OrRefusal<Fix> believed = belief_.propose(*fix, map, needed); !believed) {
      outcome.refusals.push_back(believed.error());
      if constexpr (ComparesRivals<M>) {
        if (looked_everywhere) doubt_.begin(config_, map, id, seen, seek_.left_out());
      }
      return true;
    }
    outcome.fix = *fix;
    if (!looked_everywhere || settles(seen, map, bytes, decoded, outcome)) {
      charted_.found(*estimate());
      seek_.end();
    } else {
      belief_ = before;
      outcome.fix.reset();
    }
    return true;
  }

  /// Holds the view by which a robot seems to stand somewhere against all other places first, as another one may look
  /// the same. Returns whether this sample is done.
  bool is_in_doubt(const Window& map, const Contents& bytes, DecodedContents<M>& decoded, std::uint32_t& tries,
                   Outcome& outcome) {
    if constexpr (ComparesRivals<M>) {
      if (!doubt_.is_open()) return false;
      const OrRefusal<void> only = doubt_.look(map, bytes, decoded, tries);
      if (only) return false;
      outcome.refusals.push_back(only.error());
      if (!doubt_.is_open()) belief_.withdraw();
      return true;
    }
    return false;
  }

  /// Improves what was found by the places around. When they tell no more, the result stays as it is, or, with a
  /// method that compares rivals, is not to be believed: returns false.
  bool settles(const Content& seen, const Window& map, const Contents& bytes, DecodedContents<M>& decoded,
               Outcome& outcome) {
    if constexpr (ChartsItself<M>) {
      const OrRefusal<Fix> fix = settled(*method_, config_, map, bytes, decoded, *estimate(), seen);
      if (fix) {
        belief_.set(*fix);
        outcome.fix = *fix;
      } else if (ComparesRivals<M>) {
        outcome.refusals.push_back(fix.error());
        return false;
      }
    }
    return true;
  }

  /// Looks for a fix at a place by its content. Around a seed, a method that localises in its own way does so where
  /// two contents alone tell too little.
  OrRefusal<Fix> look_at(const PlaceId& id, const Content& there, const Content& seen, const Window& map,
                         const Contents& bytes, DecodedContents<M>& decoded) {
    const OrRefusal<Related> related = method_->relate(there, seen, std::nullopt);
    if constexpr (Contradicts<M>) {
      // Places that look alike are told apart by no more than this.
      const double against = related ? method_->contradiction(there, seen, related->a_from_b) : 0.0;
      if (against > 0.0) return tl::unexpected(Refusal{"contradicted", against, 0.0});
    }
    if (related) return Fix{id, related->a_from_b, *related};
    if constexpr (ChartsItself<M>) {
      if (seek_.seeded()) {
        constexpr double seed_sigma_m = 0.5;
        constexpr double seed_sigma_rad = 0.3;
        charted_.forget();
        charted_.prepare(map, bytes, decoded, {id, with_noise(Metric2{}, seed_sigma_m, seed_sigma_rad), 0.0});
        const auto located = charted_.locate(seen);
        charted_.forget();
        if (located.fix) return *located.fix;
      }
    }
    return tl::unexpected(related.error());
  }

  bool take(const OrRefusal<Fix>& fix, Outcome& outcome) {
    if (!fix) {
      outcome.refusals.push_back(fix.error());
      return false;
    }
    outcome.fix = *fix;
    charted_.believed(*estimate());
    seek_.end();
    return true;
  }

  /// Orders the queue by signature, the likeliest places first; without a signature the order stays. Signatures are
  /// read over several samples; false until that is done.
  bool order_by_signature(const Content& seen, const Window& map, const Contents& bytes,
                          DecodedContents<M>& decoded) {
    if (seek_.ordered()) return true;
    const std::optional<Signature> here = method_->sign(seen);
    if (!here) {
      seek_.set_ordered();
      return true;
    }
    std::uint32_t reads = config_.locate.seek_signs;
    std::vector<std::pair<double, PlaceId>> by_distance;
    for (const PlaceId& id : seek_.order()) {
      const Place* const place = map.place(id);
      if (place == nullptr) continue;
      constexpr double unknown = 1e9;
      if (!is_readable(id, map, bytes)) {
        by_distance.emplace_back(unknown, id);
        continue;
      }
      if (!decoded.has_signature(place->content.hash) && reads-- == 0) return false;
      const std::optional<Signature>& there = decoded.signature(*place, bytes);
      by_distance.emplace_back(there ? distance2(*here, *there) : unknown, id);
    }
    std::sort(by_distance.begin(), by_distance.end(), std::greater<>());  // the next one stands last
    seek_.order().clear();
    for (const auto& [distance, id] : by_distance) seek_.order().push_back(id);
    seek_.set_ordered();
    return true;
  }

  const M* method_;
  NavigationConfig config_;
  Belief belief_;
  RelocalisationQueue seek_;
  RecognitionQuery query_;
  std::uint32_t suspected_samples_ = 0;  // since the last fix that waits for another
  Charted<M> charted_;
  typename RivalsOrNone<M>::Type doubt_;  // open while a fix that waits for another one is weighed
  double since_m_ = 0.0;
  double since_rad_ = 0.0;
  std::uint32_t since_samples_ = 0;
};

}  // namespace weft::agents
