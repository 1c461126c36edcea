#include "agents/agent/reanchoring.hpp"

#include <utility>

#include "core/network/search.hpp"

namespace weft::agents {
namespace {
constexpr std::uint32_t kMostPlaces = 1000;
}  // namespace

std::optional<Reanchoring::Step> Reanchoring::on_change(const Replica& replica, Navigator& navigator) {
  const std::optional<Estimate> estimate = navigator.estimate();
  if (!before_.has_value()) return begin(replica, estimate);
  Step step{.definition = replica.definition(), .is_over = true, .note = {}};
  if (navigator.map_changed(*before_, replica.window())) {
    if (const std::optional<Estimate> found = navigator.estimate()) step.definition.centre = found->place;
  } else {
    navigator.forget_where();
    step.note = "what it knew around " + to_string(estimate->place) +
                " was taken out of the map: it does not know where it is";
  }
  before_.reset();
  return step;
}

std::optional<Reanchoring::Step> Reanchoring::begin(const Replica& replica, const std::optional<Estimate>& estimate) {
  const Window& before = replica.before();
  const bool has_left = estimate.has_value() && before.place(estimate->place) != nullptr &&
                        replica.window().place(estimate->place) == nullptr;
  if (!has_left) return std::nullopt;
  before_ = before;
  Step step{.definition = replica.definition(), .is_over = false, .note = {}};
  step.definition.centre.reset();
  step.definition.route =
      neighbourhood(*before_, estimate->place, static_cast<std::uint32_t>(before.places.size()), kMostPlaces);
  return step;
}

}  // namespace weft::agents
