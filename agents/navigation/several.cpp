#include "agents/navigation/several.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "agents/navigation/hand_over.hpp"
#include "agents/navigation/parts.hpp"

namespace weft::agents {
namespace {

class Several final : public Navigator {
 public:
  Several(std::vector<Looking> all, const NavigationConfig& config) : config_(config), joins_(config.stitch) {
    for (Looking& one : all)
      parts_.push_back({.sensor = std::move(one.sensor), .navigator = std::move(one.navigator)});
  }

  std::string_view method() const override { return active().navigator->method(); }
  std::vector<std::string> teaches() const override {
    std::vector<std::string> all;
    for (const Part& part : parts_) all.emplace_back(part.navigator->method());
    return all;
  }
  std::vector<std::string> drives() const override {
    std::vector<std::string> all = teaches();
    for (std::size_t i = 0; i < parts_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) all.push_back(change_between(all[i], all[j]));
    return all;
  }

  Navigated step(const Sample& sample, const MapView& map) override {
    for (Part& part : parts_) part.moves(sample.motion);
    Navigated all;
    for (Part& part : parts_) {
      const View* const view = sample.of(part.sensor);
      if (view == nullptr && !part.is_due_blind()) continue;
      Sample own{sample.frame, sample.time, {}, part.take_motion(view != nullptr), sample.hand, sample.hand_done};
      if (view != nullptr) own.views.push_back(*view);
      part.last = part.navigator->step(own, map);
      if (part.last.fix) all.fix = part.last.fix;
      if (part.last.exposes) all.exposes = part.last.exposes;
      all.refusals.insert(all.refusals.end(), part.last.refusals.begin(), part.last.refusals.end());
      take_kept(part, std::move(part.last.kept), all.kept);
      std::move(part.last.lessons.begin(), part.last.lessons.end(), std::back_inserter(all.lessons));
      part.last.lessons.clear();
    }
    if (!is_taught()) {
      tell_who_does_not_know(parts_, active_, config_, map.window);
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
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (i > start.others.size()) break;
      parts_[i].teaches = i == 0 ? start.experience : start.others[i - 1];
      parts_[i].navigator->begin_teach({parts_[i].teaches, start.robot, {}});
    }
  }

  std::vector<Kept> end_teach(const MapView& map) override {
    std::vector<Kept> all;
    for (Part& part : parts_) take_kept(part, part.navigator->end_teach(map), all);
    // Whoever has ended already is still to be joined to those that have not.
    const auto goes_on = [](const Part& part) { return part.navigator->is_taught(); };
    if (std::none_of(parts_.begin(), parts_.end(), goes_on)) leave_teach();
    return all;
  }
  bool is_taught() const override { return bool(parts_.front().teaches); }
  void leave_teach() override {
    for (Part& part : parts_) {
      part.navigator->leave_teach();
      part.teaches = {};
    }
  }

  /// Of the first method: whoever names a place knows which robots can go there.
  void keep_place() override { parts_.front().navigator->keep_place(); }
  OrRefusal<Kept> keep_alone(const TeachStart& start, const MapView& map) override {
    return active().navigator->keep_alone(start, map);
  }

  bool map_changed(const Window& before, const Window& after) override {
    bool has_fallen = false;
    bool stands = false;
    for (Part& part : parts_) {
      const bool stays = part.navigator->map_changed(before, after);
      if (!stays) part.navigator->forget_where();
      has_fallen = has_fallen || !stays;
      stands = stands || part.navigator->estimate().has_value();
    }
    return stands || !has_fallen;
  }
  void forget_taught(const Window& map) override {
    for (Part& part : parts_) part.navigator->forget_taught(map);
  }
  void forget_where() override {
    for (Part& part : parts_) part.navigator->forget_where();
  }
  void believe(const Estimate& told) override { active().navigator->believe(told); }

  void seek(const std::optional<PlaceId>& seed) override {
    // Who knows goes on knowing while another one looks for itself.
    const bool all_know = std::all_of(parts_.begin(), parts_.end(), [](const Part& part) { return part.knows(); });
    for (Part& part : parts_)
      if (seed || all_know || !part.knows()) part.navigator->seek(seed);
  }
  void look_again() override {
    for (Part& part : parts_) part.navigator->look_again();
  }
  void stop_looking() override {
    for (Part& part : parts_) part.navigator->stop_looking();
  }
  std::optional<Estimate> estimate() const override { return active().navigator->estimate(); }
  /// Of the first one that asks; numbered so that an answer finds back to it.
  const Question* question() const override {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const Question* const open = parts_[i].navigator->question();
      if (open == nullptr) continue;
      asked_ = *open;
      asked_->number = open->number * parts_.size() + i;
      return &*asked_;
    }
    return nullptr;
  }
  void propose(std::uint64_t question, const std::vector<PlaceId>& places) override {
    parts_[question % parts_.size()].navigator->propose(question / parts_.size(), places);
  }
  std::optional<PlaceId> suspected() const override {
    for (const Part& part : parts_)
      if (const auto suspected = part.navigator->suspected()) return suspected;
    return std::nullopt;
  }
  std::optional<MountReport> mount() const override {
    for (const Part& part : parts_)
      if (auto report = part.navigator->mount()) return report;
    return std::nullopt;
  }
  Result<TaughtWay> taught_way() const override { return parts_.front().navigator->taught_way(); }

  void follow(const Route& route, std::uint32_t from) override {
    if (!route_ || route_->id != route.id || route_->places != route.places) forget_drives();
    route_ = route;
    active().navigator->follow(route, from);
  }
  void stop() override {
    route_.reset();
    forget_drives();
    for (Part& part : parts_) {
      part.last.command = {};
      part.navigator->stop();
    }
  }

 private:
  Part& active() { return parts_[active_]; }
  const Part& active() const { return parts_[active_]; }

  /// What was said of another route is not to be said of the next one. A robot that rolls goes on rolling.
  void forget_drives() {
    for (Part& part : parts_) {
      part.last.following = Following::none;
      part.last.route_at = part.last.route_freed = 0;
      part.last.reason = {};
    }
  }

  /// Places of `part`, with what joins them to those of the first one.
  void take_kept(Part& part, std::vector<Kept> kept, std::vector<Kept>& all) {
    Part& first = parts_.front();
    const std::optional<Estimate> there = first.now();
    for (Kept& one : kept) {
      if (&part != &first && there && there->place.experience == first.teaches) {
        const auto edge = joins_.join(*there, first.navigator->method(), one.place);
        if (edge) one.edges.push_back(*edge);
      }
      all.push_back(std::move(one));
    }
  }

  /// Who drives from now on.
  void choose(const Window& window, bool hand) {
    if (!route_ || hand || !active().navigator->estimate()) {
      const auto knows = std::find_if(parts_.begin(), parts_.end(), [](const Part& part) { return part.knows(); });
      if (active().knows() || knows == parts_.end()) return;
      active_ = static_cast<std::size_t>(knows - parts_.begin());
      if (route_) active().navigator->follow(*route_, 0);
      return;
    }
    const std::uint32_t at = active().last.route_at;
    tell_who_is_mistaken(parts_, active_, config_, window, *route_, at);
    const auto next = successor(parts_, active_, config_, window, *route_, at);
    if (!next) return;
    Part& drives = parts_[*next];
    active().navigator->stop();
    drives.navigator->follow(*route_, at);
    // As fast as the robot rolls, and not before where it has been.
    drives.last.command = active().last.command;
    drives.last.following = active().last.following;
    drives.last.route_at = at;
    drives.last.route_freed = active().last.route_freed;
    active_ = *next;
  }

  NavigationConfig config_;
  Parts parts_;
  std::size_t active_ = 0;  ///< who drives
  std::optional<Route> route_;
  Joins joins_;
  mutable std::optional<Question> asked_;  // what `question` points to
};

}  // namespace

std::unique_ptr<Navigator> make_several(std::vector<Looking> all, const NavigationConfig& config) {
  return std::make_unique<Several>(std::move(all), config);
}

}  // namespace weft::agents
