#pragma once
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "agents/navigation/end_loop_closure.hpp"
#include "agents/navigation/follower.hpp"
#include "agents/navigation/localiser.hpp"
#include "agents/navigation/navigator.hpp"
#include "agents/navigation/on_what_stays.hpp"
#include "agents/navigation/own_map.hpp"
#include "agents/navigation/place_learner.hpp"
#include "agents/navigation/place_trials.hpp"
#include "agents/navigation/recovery.hpp"
#include "agents/navigation/run_refinement.hpp"
#include "agents/navigation/shortcuts.hpp"
#include "agents/navigation/stitcher.hpp"
#include "agents/navigation/taught_speed.hpp"
#include "agents/navigation/teacher.hpp"

namespace weft::agents {

/// Teaches, localises, recovers and follows with method M.
template <Method M>
class NavigatorOf final : public Navigator {
 public:
  /// Looks through the sensor of that id; "": whichever the body has.
  NavigatorOf(M method, const NavigationConfig& config, std::string sensor)
      : method_(std::move(method)),
        config_(config),
        sensor_(std::move(sensor)),
        decoded_(method_, std::uint64_t{config.locate.decoded_mb} << 20U),
        localiser_(method_, config),
        stitcher_(method_, config),
        follower_(config, manner_of<M>()),
        recovery_(method_),
        learned_places_(method_, config.learn),
        own_(M::name) {}
  NavigatorOf(const NavigatorOf&) = delete;  // its parts point to method_
  NavigatorOf& operator=(const NavigatorOf&) = delete;

  std::string_view method() const override { return M::name; }
  std::optional<Estimate> estimate() const override { return localiser_.estimate(); }

  Navigated step(const Sample& sample, const MapView& map) override {
    const View* const view = sample.of(sensor_);
    const Motion& motion = sample.motion;
    const Step step = method_.observe(odometry_, view, motion);
    if (view != nullptr) views_not_followed_ = step.seen ? 0 : views_not_followed_ + 1;
    measure_speed(step, motion);
    localiser_.advance(step);
    learned_places_.advance(step);
    latest_ = Latest{view != nullptr ? std::optional(*view) : std::nullopt, sample.frame, sample.time, std::nullopt};

    Navigated navigated;
    if (!step.seen) navigated.refusals.push_back({step.blind_reason});
    if constexpr (Exposes<M>) {
      if (view != nullptr)
        if (const std::optional<Exposure> wish = method_.expose(std::as_const(odometry_), *view))
          navigated.exposes = ExposureWish{view->sensor, *wish};
    }
    own_.update(map.window, map.generation, !teacher_);
    if (teacher_) {
      teacher_->advance(step);
      trials_->drive(teacher_->driven_m(), step.seen ? std::string_view() : step.blind_reason);
      if (finder_) finder_->advance(step);
      if (view != nullptr) find_anchor(map, navigated);
      if (view != nullptr && teacher_->estimate()) trials_->look(*teacher_->estimate(), odometry_, *view);
      if (view != nullptr && teacher_->due() && may_be_kept()) keep(map, navigated);
    } else if (view != nullptr) {
      localise(map, navigated);
    }
    // What was looked at in full leaves no time.
    if (trials_ && !latest_->content) trials_->work(motion.elapsed);
    navigated.lost = lost();
    if (navigated.lost && !localiser_.seeking()) localiser_.seek_again();
    recovery_.advance(step, motion.elapsed, !teacher_ && (navigated.lost || (!estimate() && localiser_.seeking())));
    if (sample.hand || teacher_) {
      navigated.reason = "hand";
    } else {
      drive(map, motion, navigated);
      if (const auto turn = recovery_.turn(odometry_, follower_.route().has_value())) navigated.command = *turn;
    }
    if (config_.learn.enabled) learn(sample.hand, map, navigated);
    return navigated;
  }

  void begin_teach(const TeachStart& start) override {
    anchor_.reset();
    finder_.reset();
    if (estimate() && !lost()) {
      anchor_ = estimate();
    } else {
      finder_ = localiser_;
      if (!finder_->seeking()) finder_->seek(std::nullopt);
      finder_->leave_out(start.experience);
    }
    own_.clear();
    stitcher_.clear();
    follower_.stop();
    recovery_.stopped();
    kept_last_.reset();
    teacher_.emplace(config_.teach, start, M::name, M::content_format, drives_both_ways<M>());
    trials_.emplace(method_, config_, start.experience);
  }

  std::vector<Kept> end_teach(const MapView& map) override {
    Navigated last;
    if (teacher_ && is_to_end_with_a_place()) {
      const bool is_at_a_place = teacher_->estimate() && !teacher_->has_moved();
      if (!latest_ || !latest_->view || is_at_a_place || !may_be_kept()) return {};
      keep(map, last);
      if (last.kept.empty()) return {};  // this view shows too little; another one is waited for
      come_back(map, last.kept.back());
      const std::vector<Edge> held = leave_teach();
      last.kept.back().edges.insert(last.kept.back().edges.end(), held.begin(), held.end());
      return std::move(last.kept);
    }
    teacher_.reset();
    finder_.reset();
    return {};  // what is held is given out by leave_teach
  }
  bool is_taught() const override { return teacher_.has_value(); }
  std::vector<Edge> leave_teach() override {
    teacher_.reset();
    finder_.reset();
    return stitcher_.rest();
  }
  std::unique_ptr<RunRefiner> refiner(std::string_view method) const override {
    if constexpr (Refines<M>)
      if (method == M::name) return std::make_unique<RunRefinement<M>>(method_);
    return Navigator::refiner(method);
  }

  void keep_place() override {
    if (teacher_) teacher_->ask();
  }

  OrRefusal<Kept> keep_alone(const TeachStart& start, const MapView& map) override {
    if (teacher_) return tl::unexpected(Refusal{"being_taught"});
    if (!estimate() || lost()) return tl::unexpected(Refusal{"not_localised"});
    if (!latest_ || !latest_->view) return tl::unexpected(Refusal{"no_view"});
    Navigated noted;
    const Pointer content = seen(noted);
    if (!content) return tl::unexpected(latest_->content->error());
    Teacher teacher(config_.teach, start, M::name, M::content_format);
    Kept kept = teacher.keep(method_.encode(*content), latest_->frame, latest_->time);
    OwnMap own = own_;
    own.add(kept.place, {});
    own.update(map.window, map.generation, false);
    own.anchor(anchor_edge(*estimate(), kept.place.id));
    auto found = Stitcher<M>(method_, config_)
                     .look(own.map(map.window), map.contents, decoded_, teacher, kept.place, *content);
    kept.edges = std::move(found.edges);
    // Places that are still on their way to the server are none that an edge may hang on.
    std::erase_if(kept.edges, [&](const Edge& edge) { return map.window.place(edge.id.a) == nullptr; });
    const bool reachable = std::any_of(kept.edges.begin(), kept.edges.end(),
                                       [](const Edge& edge) { return edge.drivable != Drivable::none; });
    if (reachable) return kept;
    if (!kept.edges.empty()) return tl::unexpected(Refusal{"stands_across"});
    return tl::unexpected(found.refusals.empty() ? Refusal{"nothing_joined"} : found.refusals.front());
  }

  bool map_changed(const Window& before, const Window& after) override {
    if (teacher_ || !estimate()) return true;
    const PlaceId at = estimate()->place;
    const bool has_left = before.place(at) != nullptr && after.place(at) == nullptr && !own_.has(at);
    return !has_left || stand_on_what_stays(own_.over(before).map(before), after);
  }

  void forget_taught(const Window& map) override {
    if (teacher_) return;
    trials_.reset();
    const OwnMap known = own_.over(map);
    own_.clear();
    const bool is_there = !estimate() || map.place(estimate()->place) != nullptr;
    if (!is_there && !stand_on_what_stays(known.map(map), map)) localiser_.forget();
  }

  void forget_where() override { localiser_.forget(); }

  void seek(const std::optional<PlaceId>& seed) override {
    if (teacher_) {
      finder_.emplace(method_, config_);
      finder_->seek(seed);
      finder_->leave_out(teacher_->start().experience);
      return;
    }
    recovery_.asked();
    if (lost() && !seed) return localiser_.seek_again();  // what was believed still says where to look first
    localiser_.seek(seed);
  }

  void look_again() override {
    if (teacher_) return;
    if (estimate()) return localiser_.seek_again();
    localiser_.seek(std::nullopt);
  }
  void stop_looking() override {
    if (!teacher_ && !lost()) localiser_.stop_looking();
  }

  const Question* question() const override { return looks().question(); }
  void propose(std::uint64_t question, const std::vector<PlaceId>& places) override {
    (finder_ ? *finder_ : localiser_).propose(question, places);
  }
  std::optional<PlaceId> suspected() const override { return looks().suspected(); }
  std::set<ExperienceId> told_apart() const override { return stitcher_.told_apart(); }
  std::optional<PlaceId> beside() const override { return teacher_ ? stitcher_.beside() : std::nullopt; }

  std::vector<Diagnostic> diagnostics() const override {
    if constexpr (Diagnoses<M>) return method_.diagnose(odometry_);
    return {};
  }
  std::vector<WatchedDiagnostic> watched() const override {
    if constexpr (Diagnoses<M>) return {std::begin(M::watched), std::end(M::watched)};
    return {};
  }

  Result<TeachReport> teach_report() const override {
    if (trials_) return trials_->report();
    return fail(ErrorCode::refused, "nothing has been taught since its agent started");
  }

  void believe(const Estimate& told) override {
    if (teacher_) return;
    localiser_.believe(told);
  }

  void follow(const Route& route, std::uint32_t from) override { follower_.follow(route, from); }
  void stop() override {
    follower_.stop();
    recovery_.stopped();
  }

 private:
  /// Returns the localiser that looks for the robot: while teaching, the one that finds where the run joins the map.
  const Localiser<M>& looks() const { return finder_ ? *finder_ : localiser_; }

  /// Moves what is believed to the nearest place that stays; false: none does.
  bool stand_on_what_stays(const Window& known, const Window& after) {
    const std::optional<Estimate> there = on_what_stays(*estimate(), known, after);
    if (there) localiser_.stand(*there);
    return there.has_value();
  }

  using Content = typename M::Content;
  using Pointer = std::shared_ptr<const Content>;

  /// Holds the newest sample; its content is extracted at most once.
  struct Latest {
    std::optional<View> view;
    std::uint64_t frame = 0;
    SensorTime time{};
    std::optional<OrRefusal<Pointer>> content;
  };

  /// Returns the newest view's content; null: there is nothing to remember here, and its refusal is noted once.
  Pointer seen(Navigated& navigated) {
    if (!latest_->content) {
      OrRefusal<Content> content = method_.extract(std::as_const(odometry_), *latest_->view);
      if (content) {
        latest_->content = std::make_shared<const Content>(std::move(*content));
      } else {
        latest_->content = tl::unexpected(content.error());
        navigated.refusals.push_back(content.error());
      }
    }
    return *latest_->content ? **latest_->content : nullptr;
  }

  void measure_speed(const Step& step, const Motion& motion) {
    const double elapsed_s = seconds(motion.elapsed);
    if (elapsed_s <= 0.0) return;
    constexpr double smooth_s = 0.15;
    const double now = planar(step.previous_from_current).x / elapsed_s;
    speed_m_s_ += std::min(1.0, elapsed_s / smooth_s) * (now - speed_m_s_);
  }

  bool lost() const { return !teacher_ && estimate() && estimate()->blind_m > config_.follow.blind_limit_m; }

  /// Returns whether the run is to end with a place. One that knows no poses is in any case: only at its end it shows
  /// what it has come back to.
  bool is_to_end_with_a_place() const {
    return teacher_->worth_an_end() || (ChartsItself<M> && teacher_->driven_m() > 0.0);
  }

  /// Returns whether the newest view may become a place. One that vision could not join to the view before may show
  /// something else than what lies here (somebody walks through it): the next ones tell. Where none is joined, as
  /// over a blank floor, the run is taught as it is seen.
  bool may_be_kept() const {
    constexpr std::uint32_t patience = 5;  // views
    return views_not_followed_ == 0 || views_not_followed_ > patience;
  }

  Kept keep_here(const Pointer& content) {
    Kept kept = teacher_->keep(method_.encode(*content), latest_->frame, latest_->time);
    if constexpr (Registers<M>) {
      if (kept_last_)
        for (Edge& edge : kept.edges) edge.a_from_b = method_.registered(*kept_last_, *content, edge.a_from_b);
    }
    kept_last_ = content;
    decoded_.keep(kept.place.content.hash, content, kept.content.size());
    own_.add(kept.place, kept.edges);
    localiser_.set(Fix{kept.place.id, Metric2{}, {}});
    trials_->kept(kept.place.id, content);
    return kept;
  }

  void keep(const MapView& map, Navigated& navigated) {
    const Pointer content = seen(navigated);
    if (!content) return trials_->missed(latest_->content->error().reason);
    Kept kept = keep_here(content);
    own_.update(map.window, map.generation, false);
    if (anchor_) own_.anchor(anchor_edge(*anchor_, kept.place.id));
    anchor_.reset();
    auto found = stitcher_.prove(own_.map(map.window), map.contents, decoded_, *teacher_, kept.place, *content);
    if (found.is_told_apart) look_elsewhere(map);
    for (const Edge& edge : found.believed) own_.anchor(edge);
    if constexpr (Clears<M>) {
      if (config_.stitch.enabled) cut_short(map, kept);
    }
    kept.edges.insert(kept.edges.end(), found.to_hand_in.begin(), found.to_hand_in.end());
    if (found.fix) navigated.fix = found.fix;
    navigated.refusals.insert(navigated.refusals.end(), found.refusals.begin(), found.refusals.end());
    navigated.kept.push_back(std::move(kept));
  }

  /// Looks for where a run is that has been told apart from where it seemed to be.
  void look_elsewhere(const MapView& map) {
    own_.part_from_others(map.window);
    finder_.emplace(method_, config_);
    finder_->seek(std::nullopt);
    finder_->leave_out(teacher_->start().experience);
    for (const ExperienceId& other : stitcher_.told_apart()) finder_->leave_out(other);
  }

  /// Adds the shortcuts that can be seen from a place just kept.
  void cut_short(const MapView& map, Kept& kept) requires Clears<M> {
    const auto found = shortcuts(method_, config_, own_.map(map.window), map.contents, decoded_, kept.place.id);
    for (const Edge& edge : found) own_.anchor(edge);
    kept.edges.insert(kept.edges.end(), found.begin(), found.end());
  }

  /// Looks, at the end of a run, for what it has come back to: distances along its path do not tell.
  void come_back(const MapView& map, Kept& last) {
    if constexpr (ChartsItself<M>) {
      const bool is_joined = std::any_of(last.edges.begin(), last.edges.end(),
                                         [](const Edge& edge) { return edge.origin == Origin::stitch; });
      const bool has_poses = std::none_of(last.edges.begin(), last.edges.end(), [](const Edge& edge) {
        return std::holds_alternative<AlongPath>(edge.a_from_b);
      });
      if (!config_.stitch.enabled || is_joined || has_poses || !*latest_->content) return;
      EndLoopClosure<M> back(method_, config_, own_.map(map.window), map.contents, decoded_);
      const OrRefusal<Fix> found = back.look(*teacher_, last.place.id, ***latest_->content);
      if (!found) return;
      last.edges.push_back(stitcher_.edge(found->place, last.place.id, found->evidence));
      own_.anchor(last.edges.back());
    }
  }

  /// Goes on looking for where the robot is, if it did not know when teaching began, so that what it teaches can be
  /// stitched to the map.
  void find_anchor(const MapView& map, Navigated& navigated) {
    constexpr std::uint32_t every = 5;  // samples; a search at each would cost too much while driving
    if (!finder_ || (finder_->samples_since_attempt() < every && !teacher_->due())) return;
    const Window& known = own_.map(map.window);
    if (!has_others(known, teacher_->start().experience)) return;
    const Pointer content = seen(navigated);
    if (!content) return;
    const auto outcome = finder_->attempt(*content, known, map.contents, decoded_, {});
    navigated.refusals.insert(navigated.refusals.end(), outcome.refusals.begin(), outcome.refusals.end());
    if (!outcome.fix) return;
    navigated.fix = outcome.fix;
    anchor_ = finder_->estimate();
    finder_.reset();
    const std::optional<Estimate> own = teacher_->estimate();
    if (!own) return;  // the first place is about to be kept
    const Relation believed_from_kept = compose(anchor_->place_from_robot, inverse(own->place_from_robot));
    own_.anchor(anchor_edge({anchor_->place, believed_from_kept, 0.0}, own->place));
    anchor_.reset();
  }

  /// Returns an edge for what is believed. It is not handed in; stitches are found from it.
  Edge anchor_edge(const Estimate& believed, const PlaceId& kept) const {
    Edge edge;
    edge.id = {believed.place, kept};
    edge.a_from_b = with_noise(believed.place_from_robot, config_.belief.map_sigma_m, config_.belief.map_sigma_rad);
    edge.origin = Origin::stitch;
    edge.drivable = Drivable::none;
    return edge;
  }

  void localise(const MapView& map, Navigated& navigated) {
    if (!localiser_.due(follower_.waits_for_fix())) return;
    const Pointer content = seen(navigated);
    if (!content) return;
    auto outcome =
        localiser_.attempt(*content, own_.map(map.window), map.contents, decoded_, follower_.near_places());
    navigated.fix = std::move(outcome.fix);
    navigated.refusals.insert(navigated.refusals.end(), outcome.refusals.begin(), outcome.refusals.end());
  }

  /// Learns places while the robot drives a route by itself and knows where it is.
  void learn(bool hand, const MapView& map, Navigated& navigated) {
    if constexpr (Learns<M>) {
      if (hand || teacher_ || !follower_.route() || !estimate() || localiser_.seeking())
        return learned_places_.leave();
      if (!navigated.fix) return;
      if (auto learned_place = learned_places_.pass(*navigated.fix, **latest_->content, map, decoded_))
        navigated.learned_places.push_back(std::move(*learned_place));
    }
  }

  void drive(const MapView& map, const Motion& motion, Navigated& navigated) {
    const std::optional<Estimate> believed = localiser_.estimate();
    Follower::Drive drive =
        follower_.look({own_.map(map.window), believed, navigated.lost, speed_m_s_, motion.elapsed});
    navigated.command = drive.navigated.command;
    navigated.following = drive.navigated.following;
    navigated.reason = drive.navigated.reason;
    navigated.route_at = drive.navigated.route_at;
    navigated.route_freed = drive.navigated.route_freed;
    if (!drive.along) return;
    drive.along->speed_limit_m_s = std::min(drive.along->speed_limit_m_s, taught_speed_at(map, believed->place));
    follower_.steered(steer(map, drive), motion.elapsed, navigated);
  }

  /// Returns the speed, m/s, at which this stretch was driven when it was taught; where that is not known, that which
  /// is configured.
  double taught_speed_at(const MapView& map, const PlaceId& at) {
    if constexpr (Replays<M>)
      return taught_speed(own_.map(map.window), at, decoded_, map).value_or(config_.follow.speed_m_s);
    return config_.follow.speed_m_s;
  }

  Steering steer(const MapView& map, const Follower::Drive& drive) {
    if constexpr (SteersItself<M>) {
      const std::optional<Around<M>> around = localiser_.around(own_.map(map.window), map.contents, decoded_);
      return method_.steer(odometry_, around ? &*around : nullptr, *drive.along);
    } else {
      return follower_.steer(*drive.along, *drive.path);
    }
  }

  const M method_;
  const NavigationConfig config_;
  const std::string sensor_;
  typename M::Odometry odometry_{};
  DecodedContents<M> decoded_;
  Localiser<M> localiser_;
  Stitcher<M> stitcher_;
  Follower follower_;
  Recovery<M> recovery_;
  typename PlaceLearnerOrNone<M>::Type learned_places_;
  std::optional<Teacher> teacher_;
  std::optional<PlaceTrials<M>> trials_;  // of what is taught, or was taught last
  std::optional<Localiser<M>> finder_;    // looks for where teaching began
  OwnMap own_;
  Pointer kept_last_;               // the content of the last place taught
  std::optional<Estimate> anchor_;  // where teaching began, until the first place is kept
  std::optional<Latest> latest_;
  std::uint32_t views_not_followed_ = 0;  ///< in succession, up to the latest
  double speed_m_s_ = 0.0;
};

/// Returns a navigator that looks through the sensor of that id; "": through whichever the body has. The caller has
/// checked `config` (check(config) is empty).
template <Method M>
std::unique_ptr<Navigator> make_navigator(M method, const NavigationConfig& config, std::string sensor = {}) {
  return std::make_unique<NavigatorOf<M>>(std::move(method), config, std::move(sensor));
}

}  // namespace weft::agents
