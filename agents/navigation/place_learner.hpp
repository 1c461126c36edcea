#pragma once
#include <cmath>
#include <limits>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "agents/navigation/config.hpp"
#include "agents/navigation/decoded_contents.hpp"
#include "agents/navigation/navigator.hpp"

namespace weft::agents {

/// Learns, for a robot that drives by itself, of the places that it comes by: once a pass, from the view nearest to
/// the place, upon the content that all robots share. What is learned is kept from pass to pass, the least recently
/// passed place forgotten, and given out when it is worth sharing.
template <Learns M>
class PlaceLearner {
 public:
  using Content = typename M::Content;
  using Pointer = std::shared_ptr<const Content>;

  PlaceLearner(const M& method, const LearnConfig& config) : method_(&method), config_(config) {}

  void advance(const Step& step) { driven_m_ += std::abs(distance_m(step.previous_from_current)); }

  /// Drops what has been seen of the place here: the robot does not drive by itself, or not know where it is.
  void leave() {
    nearest_.reset();
    fixed_at_m_ = kNever;
  }

  /// Takes note that `seen` has shown the robot at `fix`. Returns what it has learned of the place that it has
  /// thereby passed, if it is worth sharing.
  std::optional<LearnedPlace> pass(const Fix& fix, const Pointer& seen, const MapView& map,
                                   DecodedContents<M>& decoded) {
    std::optional<LearnedPlace> learned_place;
    if (nearest_ && nearest_->fix.place != fix.place) {
      learned_place = learn(*nearest_, map, decoded);
      nearest_.reset();
    }
    const bool is_sure = driven_m_ - fixed_at_m_ <= config_.sure_m;
    fixed_at_m_ = driven_m_;
    const auto off_m = [](const Fix& one) { return std::abs(planar(one.place_from_robot).x); };
    if (is_sure && (!nearest_ || off_m(fix) < off_m(nearest_->fix))) nearest_ = Pass{fix, seen};
    return learned_place;
  }

 private:
  static constexpr double kNever = -std::numeric_limits<double>::infinity();

  /// Describes the pass of the place that the robot is at.
  struct Pass {
    Fix fix;
    Pointer seen;
  };
  /// Holds the knowledge of a place beyond what is shared.
  struct Known {
    PlaceId place;
    ContentHash made_of;
    Pointer learned;         ///< null: nothing yet
    Pointer shared;          ///< or given out last
    double passed_at_m = 0;  ///< driven until then
  };

  std::optional<LearnedPlace> learn(const Pass& pass, const MapView& map, DecodedContents<M>& decoded) {
    const Place* const place = map.window.place(pass.fix.place);
    if (place == nullptr) return std::nullopt;
    const auto shared = decoded.find(*place, map.contents);
    if (!shared) return std::nullopt;
    Known& known = known_of(*place, *shared);
    if (driven_m_ - known.passed_at_m < kAnotherPassM) return std::nullopt;
    std::optional<Content> learned =
        method_->learn(known.learned ? *known.learned : **shared, *pass.seen, pass.fix.place_from_robot);
    if (!learned) return std::nullopt;
    known.passed_at_m = driven_m_;
    known.learned = std::make_shared<const Content>(std::move(*learned));
    if (!method_->is_worth_sharing(*known.shared, *known.learned)) return std::nullopt;
    known.shared = known.learned;
    return LearnedPlace{place->id, place->content.hash, M::learned_format, method_->encode(*known.learned)};
  }

  /// Forgets what was learned upon another content, and of the place that was passed longest ago.
  Known& known_of(const Place& place, const Pointer& shared) {
    const auto found = by_place_.find(place.id);
    if (found != by_place_.end()) {
      latest_.splice(latest_.begin(), latest_, found->second);
    } else {
      latest_.push_front({place.id, place.content.hash, nullptr, shared, kNever});
      by_place_[place.id] = latest_.begin();
    }
    if (latest_.size() > config_.places) {
      by_place_.erase(latest_.back().place);
      latest_.pop_back();
    }
    Known& known = latest_.front();
    if (known.made_of != place.content.hash)
      known = {place.id, place.content.hash, nullptr, shared, known.passed_at_m};
    return known;
  }

  /// Sets how many metres at least lie between two passes: a robot that sways between two places passes neither anew.
  static constexpr double kAnotherPassM = 1.0;

  const M* method_;
  LearnConfig config_;
  std::optional<Pass> nearest_;
  double driven_m_ = 0.0;
  double fixed_at_m_ = kNever;  // at the last fix
  std::list<Known> latest_;     // passed last first
  std::map<PlaceId, typename std::list<Known>::iterator> by_place_;
};

/// Does nothing: it is the learner of a method that does not learn.
struct NoPlaceLearner {
  template <class... Args>
  explicit NoPlaceLearner(const Args&...) {}
  void advance(const Step&) {}
  void leave() {}
};
template <class M>
struct PlaceLearnerOrNone {
  using Type = NoPlaceLearner;
};
template <Learns M>
struct PlaceLearnerOrNone<M> {
  using Type = PlaceLearner<M>;
};

}  // namespace weft::agents
