#include "agents/navigation/multi_method_navigator.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "agents/navigation/method_navigators.hpp"
#include "agents/navigation/method_switch.hpp"
#include "agents/navigation/run_refiner.hpp"

namespace weft::agents {
namespace {

class MultiMethodNavigator final : public Navigator {
 public:
  MultiMethodNavigator(std::vector<SensorNavigator> all, const NavigationConfig& config)
      : config_(config), joins_(config.stitch) {
    for (SensorNavigator& one : all)
      navigators_.push_back({.sensor = std::move(one.sensor), .navigator = std::move(one.navigator)});
  }

  std::string_view method() const override { return active().navigator->method(); }
  std::vector<std::string> teaches() const override {
    std::vector<std::string> all;
    for (const MethodNavigator& one : navigators_) all.emplace_back(one.navigator->method());
    return all;
  }
  std::vector<std::string> drives() const override {
    std::vector<std::string> all = teaches();
    for (std::size_t i = 0; i < navigators_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) all.push_back(change_between(all[i], all[j]));
    return all;
  }

  Navigated step(const Sample& sample, const MapView& map) override {
    for (MethodNavigator& one : navigators_) one.moves(sample.motion);
    Navigated all;
    for (MethodNavigator& one : navigators_) {
      const View* const view = sample.of(one.sensor);
      if (view == nullptr && !one.is_due_blind()) continue;
      Sample own{sample.frame, sample.time, {}, one.take_motion(view != nullptr), sample.hand, sample.hand_done};
      if (view != nullptr) own.views.push_back(*view);
      one.last = one.navigator->step(own, map);
      if (one.last.fix) all.fix = one.last.fix;
      if (one.last.exposes) all.exposes = one.last.exposes;
      all.refusals.insert(all.refusals.end(), one.last.refusals.begin(), one.last.refusals.end());
      take_kept(one, std::move(one.last.kept), all.kept);
      std::move(one.last.learned_places.begin(), one.last.learned_places.end(),
                std::back_inserter(all.learned_places));
      one.last.learned_places.clear();
    }
    if (!is_taught()) {
      seed_lost(navigators_, active_, config_, map.window);
      choose(map.window, sample.hand);
    }
    const Navigated& drives = active().last;
    all.command = drives.command;
    all.following = drives.following;
    all.route_at = drives.route_at;
    all.route_freed = drives.route_freed;
    all.lost = drives.lost;
    all.reason = drives.reason;
    return all;
  }

  void begin_teach(const TeachStart& start) override {
    joins_.clear();
    route_.reset();
    for (std::size_t i = 0; i < navigators_.size(); ++i) {
      if (i > start.others.size()) break;
      navigators_[i].teaches = i == 0 ? start.experience : start.others[i - 1];
      navigators_[i].navigator->begin_teach({navigators_[i].teaches, start.robot, {}});
    }
  }

  std::vector<Kept> end_teach(const MapView& map) override {
    std::vector<Kept> all;
    for (MethodNavigator& one : navigators_) take_kept(one, one.navigator->end_teach(map), all);
    // A navigator that has ended already is still to be joined to those that have not.
    const auto goes_on = [](const MethodNavigator& one) { return one.navigator->is_taught(); };
    if (std::none_of(navigators_.begin(), navigators_.end(), goes_on))
      for (MethodNavigator& one : navigators_) one.teaches = {};
    return all;
  }
  bool is_taught() const override { return bool(navigators_.front().teaches); }
  std::vector<Edge> leave_teach() override {
    std::vector<Edge> held;
    for (MethodNavigator& one : navigators_) {
      const std::vector<Edge> more = one.navigator->leave_teach();
      held.insert(held.end(), more.begin(), more.end());
      one.teaches = {};
    }
    return held;
  }

  std::unique_ptr<RunRefiner> refiner(std::string_view method) const override {
    const auto its = std::ranges::find_if(
        navigators_, [&](const MethodNavigator& one) { return one.navigator->method() == method; });
    return its == navigators_.end() ? nullptr : its->navigator->refiner(method);
  }

  /// Keeps a place of the first method: whoever names it knows which robots can go there.
  void keep_place() override { navigators_.front().navigator->keep_place(); }
  OrRefusal<Kept> keep_alone(const TeachStart& start, const MapView& map) override {
    return active().navigator->keep_alone(start, map);
  }

  bool map_changed(const Window& before, const Window& after) override {
    bool has_fallen = false;
    bool stands = false;
    for (MethodNavigator& one : navigators_) {
      const bool stays = one.navigator->map_changed(before, after);
      if (!stays) one.navigator->forget_where();
      has_fallen = has_fallen || !stays;
      stands = stands || one.navigator->estimate().has_value();
    }
    return stands || !has_fallen;
  }
  void forget_taught(const Window& map) override {
    for (MethodNavigator& one : navigators_) one.navigator->forget_taught(map);
  }
  void forget_where() override {
    for (MethodNavigator& one : navigators_) one.navigator->forget_where();
  }
  void believe(const Estimate& told) override { active().navigator->believe(told); }

  void seek(const std::optional<PlaceId>& seed) override {
    // Navigators that are localised keep their estimate; only the lost ones search.
    const bool all_know =
        std::all_of(navigators_.begin(), navigators_.end(), [](const MethodNavigator& one) { return one.knows(); });
    for (MethodNavigator& one : navigators_)
      if (seed || all_know || !one.knows()) one.navigator->seek(seed);
  }
  void look_again() override {
    for (MethodNavigator& one : navigators_) one.navigator->look_again();
  }
  void stop_looking() override {
    for (MethodNavigator& one : navigators_) one.navigator->stop_looking();
  }
  std::optional<Estimate> estimate() const override { return active().navigator->estimate(); }
  /// Returns the question of the first navigator that has one; numbered so that an answer finds back to it.
  const Question* question() const override {
    for (std::size_t i = 0; i < navigators_.size(); ++i) {
      const Question* const open = navigators_[i].navigator->question();
      if (open == nullptr) continue;
      asked_ = *open;
      asked_->number = open->number * navigators_.size() + i;
      return &*asked_;
    }
    return nullptr;
  }
  void propose(std::uint64_t question, const std::vector<PlaceId>& places) override {
    navigators_[question % navigators_.size()].navigator->propose(question / navigators_.size(), places);
  }
  std::optional<PlaceId> suspected() const override {
    for (const MethodNavigator& one : navigators_)
      if (const auto suspected = one.navigator->suspected()) return suspected;
    return std::nullopt;
  }
  std::set<ExperienceId> told_apart() const override {
    std::set<ExperienceId> all;
    for (const MethodNavigator& one : navigators_) all.merge(one.navigator->told_apart());
    return all;
  }
  std::optional<PlaceId> beside() const override {
    for (const MethodNavigator& one : navigators_)
      if (const auto beside = one.navigator->beside()) return beside;
    return std::nullopt;
  }
  std::vector<Diagnostic> diagnostics() const override { return gathered(&Navigator::diagnostics); }
  std::vector<WatchedDiagnostic> watched() const override { return gathered(&Navigator::watched); }
  Result<TeachReport> teach_report() const override { return navigators_.front().navigator->teach_report(); }

  void follow(const Route& route, std::uint32_t from) override {
    if (!route_ || route_->id != route.id || route_->places != route.places) forget_drives();
    route_ = route;
    active().navigator->follow(route, from);
  }
  void stop() override {
    route_.reset();
    forget_drives();
    for (MethodNavigator& one : navigators_) {
      one.last.command = {};
      one.navigator->stop();
    }
  }

 private:
  template <class T>
  std::vector<T> gathered(std::vector<T> (Navigator::*of)() const) const {
    std::vector<T> all;
    for (const MethodNavigator& one : navigators_) {
      std::vector<T> its = ((*one.navigator).*of)();
      std::move(its.begin(), its.end(), std::back_inserter(all));
    }
    return all;
  }
  MethodNavigator& active() { return navigators_[active_]; }
  const MethodNavigator& active() const { return navigators_[active_]; }

  /// Clears what was reported of the last route; a robot that rolls goes on rolling.
  void forget_drives() {
    for (MethodNavigator& one : navigators_) {
      one.last.following = Following::none;
      one.last.route_at = one.last.route_freed = 0;
      one.last.reason = {};
    }
  }

  /// Adds the places that `taker` has kept to `all`, with the edges that join them to those of the first navigator.
  void take_kept(MethodNavigator& taker, std::vector<Kept> kept, std::vector<Kept>& all) {
    MethodNavigator& first = navigators_.front();
    const std::optional<Estimate> there = first.now();
    for (Kept& one : kept) {
      if (&taker != &first && there && there->place.experience == first.teaches) {
        const auto edge = joins_.join(*there, first.navigator->method(), one.place);
        if (edge) one.edges.push_back(*edge);
      }
      all.push_back(std::move(one));
    }
  }

  /// Returns whether a route may begin where that navigator believes to be: its nearest place is near. A ceiling is
  /// seen from metres beside whatever was taught by it.
  bool stands_at_a_place(const MethodNavigator& one) const {
    return one.knows() && norm(one.navigator->estimate()->place_from_robot) <= config_.follow.join_m;
  }

  /// Returns who is to say where the robot is while none drives by what it knows: the active one as long as a route
  /// may begin there, else the first of whom that is true, else the first that knows; null: nobody knows better.
  const MethodNavigator* best_standing() const {
    if (stands_at_a_place(active())) return nullptr;
    for (const MethodNavigator& one : navigators_)
      if (stands_at_a_place(one)) return &one;
    if (active().knows()) return nullptr;
    const auto knows = std::ranges::find_if(navigators_, &MethodNavigator::knows);
    return knows == navigators_.end() ? nullptr : &*knows;
  }

  /// Changes which navigator drives, where the route or what they know asks for it.
  void choose(const Window& window, bool hand) {
    if (!route_ || hand || !active().navigator->estimate()) {
      const MethodNavigator* const best = best_standing();
      if (best == nullptr) return;
      active_ = static_cast<std::size_t>(best - navigators_.data());
      if (route_) active().navigator->follow(*route_, 0);
      return;
    }
    const std::uint32_t at = active().last.route_at;
    correct_mistaken(navigators_, active_, config_, window, *route_, at);
    const auto next = successor(navigators_, active_, config_, window, *route_, at);
    if (!next) return;
    MethodNavigator& drives = navigators_[*next];
    active().navigator->stop();
    drives.navigator->follow(*route_, at);
    // It goes on at the speed of the robot and from where the route was left.
    drives.last.command = active().last.command;
    drives.last.following = active().last.following;
    drives.last.route_at = at;
    drives.last.route_freed = active().last.route_freed;
    active_ = *next;
  }

  NavigationConfig config_;
  MethodNavigators navigators_;
  std::size_t active_ = 0;  ///< who drives
  std::optional<Route> route_;
  Joins joins_;
  mutable std::optional<Question> asked_;  // what `question` points to
};

}  // namespace

std::unique_ptr<Navigator> make_multi_method_navigator(std::vector<SensorNavigator> all,
                                                       const NavigationConfig& config) {
  return std::make_unique<MultiMethodNavigator>(std::move(all), config);
}

}  // namespace weft::agents
