#pragma once
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "agents/methods/topometric/topometric.hpp"

namespace weft::evaluate::topometric {

/// Describes a relation as it was before two contents were compared, and as it came out.
struct Compared {
  Relation guess;
  Relation a_from_b;
};

/// Holds what the method did in one sample.
struct Noted {
  agents::Step step;
  bool has_switched = false;  ///< a belief began in a chart, or was carried into one
  std::vector<Compared> registered;
  std::vector<Compared> related;  ///< with a guess
};

/// Is the method with a note of what a Navigator does not show. Inherited: whatever else the method has stays the
/// navigator's to use.
class NotedTopometric : public agents::Topometric {
 public:
  NotedTopometric(agents::Topometric method, std::shared_ptr<Noted> into)
      : agents::Topometric(std::move(method)), into_(std::move(into)) {}

  agents::Step observe(Odometry& odometry, const agents::View* view, const agents::Motion& motion) const {
    *into_ = Noted{};
    into_->step = agents::Topometric::observe(odometry, view, motion);
    return into_->step;
  }
  Relation registered(const Content& a, const Content& b, const Relation& a_from_b) const {
    Relation result = agents::Topometric::registered(a, b, a_from_b);
    into_->registered.push_back({a_from_b, result});
    return result;
  }
  agents::OrRefusal<agents::Related> relate(const Content& a, const Content& b,
                                            const std::optional<Relation>& guess) const {
    auto related = agents::Topometric::relate(a, b, guess);
    if (related && guess) into_->related.push_back({*guess, related->a_from_b});
    return related;
  }
  Belief begin(const Chart& chart, const agents::Estimate& seed) const {
    into_->has_switched = true;
    return agents::Topometric::begin(chart, seed);
  }
  Belief carried(const Chart& chart, const agents::Estimate& seed, const Belief& before) const {
    into_->has_switched = true;
    return agents::Topometric::carried(chart, seed, before);
  }
  agents::Steering steer(Odometry& odometry, const agents::Around<NotedTopometric>* around,
                         const agents::Ahead& ahead) const {
    if (around == nullptr) return agents::Topometric::steer(odometry, nullptr, ahead);
    const agents::Around<agents::Topometric> same{around->chart, around->belief, around->centre_from_robot};
    return agents::Topometric::steer(odometry, &same, ahead);
  }

 private:
  std::shared_ptr<Noted> into_;
};

}  // namespace weft::evaluate::topometric
