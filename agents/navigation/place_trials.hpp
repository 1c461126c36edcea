#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "agents/methods/method.hpp"
#include "agents/navigation/agreement.hpp"
#include "agents/navigation/belief.hpp"
#include "agents/navigation/config.hpp"
#include "agents/navigation/teach_report.hpp"
#include "core/random.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Tries nothing, for methods that cannot say what another robot would see.
template <Method M>
class PlaceTrials {
 public:
  using Pointer = std::shared_ptr<const typename M::Content>;
  PlaceTrials(const M&, const NavigationConfig&, const ExperienceId&) {}
  Result<TeachReport> report() const {
    return fail(ErrorCode::refused,
                "the method " + std::string(M::name) + " cannot say how what it was taught will be found again");
  }
  void drive(double, std::string_view) {}
  void kept(const PlaceId&, const Pointer&) {}
  void missed(std::string_view) {}
  void look(const Estimate&, const typename M::Odometry&, const View&) {}
  void work(Duration) {}
};

/// Finds out while a robot is taught whether its places will be found again: each is related, guided as localising
/// does it, to a view from a quarter of the spacing further on as another robot that passes aside would have had it.
/// A step at a time, in the slack that samples leave; where there is too little of that, places are left out evenly.
/// Pure: seeds come from the places' ids.
template <SimulatesRevisits M>
class PlaceTrials<M> {
 public:
  using Content = typename M::Content;
  using Pointer = std::shared_ptr<const Content>;

  PlaceTrials(const M& method, const NavigationConfig& config, const ExperienceId& experience)
      : method_(&method), config_(config) {
    report_.experience = experience;
    report_.conditions.assign(std::begin(M::conditions), std::end(M::conditions));
  }

  Result<TeachReport> report() const { return report_; }

  /// Takes how far it has come, and why nothing was seen of the last step; empty: it was seen.
  void drive(double driven_m, std::string_view blind_reason) {
    const double from_m = std::exchange(report_.driven_m, driven_m);
    if (blind_reason.empty() || driven_m <= from_m) return;
    std::vector<BlindStretch>& blind = report_.blind;
    const bool goes_on = !blind.empty() && blind.back().reason == blind_reason && blind.back().to_m == from_m;
    if (!goes_on) blind.push_back({from_m, from_m, blind_reason});
    blind.back().to_m = driven_m;
  }
  void kept(const PlaceId& place, Pointer content) {
    report_.places.push_back({place, report_.driven_m, std::nullopt});
    newest_ = std::move(content);
  }
  /// Notes that a place was due and not worth keeping.
  void missed(std::string_view reason) {
    constexpr double apart_m = 0.1;
    const bool is_known = !report_.missed.empty() && report_.missed.back().reason == reason &&
                          report_.driven_m - report_.missed.back().at_m < apart_m;
    if (!is_known) report_.missed.push_back({report_.driven_m, reason});
  }

  /// Takes a view while teaching, before it may become a place; `here`: relative to the last place kept.
  void look(const Estimate& here, const typename M::Odometry& odometry, const View& view) {
    // About as far as a robot that localises passes from where it looks.
    constexpr double of_spacing = 0.25;
    const bool is_far_enough = distance_m(here.place_from_robot) >= of_spacing * config_.teach.spacing_m ||
                               std::abs(heading_rad(here.place_from_robot)) >= of_spacing * config_.teach.spacing_rad;
    if (!newest_ || !is_far_enough) return;
    const Pointer content = std::exchange(newest_, nullptr);
    if (waiting_.size() >= most_waiting) return;
    waiting_.push_back({report_.places.size() - 1, content, here.place_from_robot, odometry, view, {}});
  }

  /// Works for as long as a sample leaves time: one step for each 30 ms since the sample before, at least one and at
  /// most four.
  void work(Duration elapsed) {
    constexpr double step_s = 0.03;
    constexpr int most_steps = 4;
    int steps = std::clamp(static_cast<int>(seconds(elapsed) / step_s), 1, most_steps);
    for (; steps > 0 && !waiting_.empty(); --steps) advance(waiting_.front());
  }

 private:
  /// Holds a place and a view of it from further on.
  struct Waiting {
    std::size_t place = 0;  // index into report_.places
    Pointer content;
    Relation place_from_robot;
    typename M::Odometry odometry;
    View view;
    Trials trials;
  };
  /// Holds the content that the other robot sees under the condition that is tried, and where that robot is.
  struct Seen {
    Content content;
    Relation place_from_other;
  };

  /// Takes one step of a trial: finds either what the other robot sees, or whether that is the place.
  void advance(Waiting& first) {
    // One seed for all conditions: they differ in light and wear alone.
    const PlaceId& place = report_.places[first.place].id;
    Random random = Random(place.experience.value).fork(place.index);
    if (seen_) return done(first, find(first, random.fork(1)));
    OrRefusal<Seen> seen = see(first, random.fork(2));
    if (!seen) return done(first, {false, seen.error().reason, 0.0});
    seen_ = std::move(*seen);
  }

  OrRefusal<Seen> see(const Waiting& first, Random random) const {
    // A hand's breadth beside, looking a little to one side.
    const double side = random.chance(0.5) ? 1.0 : -1.0;
    const double turned = random.chance(0.5) ? 1.0 : -1.0;
    const Pose2 robot_from_other{0.0, side * random.uniform(0.02, 0.08), turned * random.uniform(0.017, 0.07)};
    auto other = method_->simulate_revisit(first.odometry, first.view, {condition_, robot_from_other, random.next()});
    if (!other) return tl::unexpected(other.error());
    return Seen{std::move(other->content), compose(first.place_from_robot, Metric2{other->robot_from_other})};
  }

  /// Perturbs the guess by the error of a robot that looks for the place.
  Trial find(const Waiting& first, Random random) const {
    constexpr GuessError error = revisit_guess<M>();
    const Pose2 off{random.normal(0.0, error.sigma_m), random.normal(0.0, error.sigma_m),
                    random.normal(0.0, error.sigma_rad)};
    const Relation& expected = seen_->place_from_other;
    const Relation guess = with_noise(compose(expected, Metric2{off}), error.sigma_m, error.sigma_rad);
    const OrRefusal<Related> related = method_->relate(*first.content, seen_->content, guess);
    if (!related) return {false, related.error().reason, 0.0};
    if (agreement(expected, related->a_from_b, config_.stitch.agree_m, config_.stitch.agree_rad))
      return {false, "found_elsewhere", 0.0};
    return {true, {}, spread_of(related->a_from_b).metres};
  }

  void done(Waiting& first, const Trial& trial) {
    seen_.reset();
    first.trials.push_back(trial);
    condition_ = first.trials.size();
    if (condition_ < std::size(M::conditions)) return;
    condition_ = 0;
    report_.places[first.place].trials = first.trials;
    waiting_.pop_front();
  }

  static constexpr std::size_t most_waiting = 6;  // each holds a view

  const M* method_;
  NavigationConfig config_;
  TeachReport report_;
  Pointer newest_;  // of the last place kept, until a view of it is taken
  std::deque<Waiting> waiting_;
  std::size_t condition_ = 0;  // that is tried now
  std::optional<Seen> seen_;
};

}  // namespace weft::agents
