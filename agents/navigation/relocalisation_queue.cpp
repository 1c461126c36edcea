#include "agents/navigation/relocalisation_queue.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "agents/navigation/candidates.hpp"
#include "core/network/search.hpp"

namespace weft::agents {

namespace {

constexpr std::uint32_t cap = 2000;  // places of one pass
constexpr std::uint32_t pause_samples = 5;

std::vector<PlaceId> around_seed(const NavigationConfig& config, const Window& window, const PlaceId& seed) {
  std::vector<PlaceId> order;
  for (const Reached& reached : breadth_first(window, seed, config.locate.seed_hops, cap))
    order.push_back(reached.id);
  return order;
}

std::vector<PlaceId> around_last(const NavigationConfig& config, const Window& window, const Estimate& last) {
  constexpr double reach_m = 10.0;
  std::vector<PlaceId> order;
  for (const Candidate& candidate : candidates(config, window, last, config.locate.most_hops, reach_m, {})) {
    order.push_back(candidate.place);
  }
  return order;
}

std::vector<PlaceId> everywhere(const Window& window, std::vector<PlaceId> first,
                                const std::set<ExperienceId>& left_out) {
  std::vector<PlaceId> order = std::move(first);
  const std::set<PlaceId> placed(order.begin(), order.end());
  for (const auto& [id, place] : window.places) {
    if (order.size() >= cap) break;
    if (!left_out.contains(id.experience) && !placed.contains(id)) order.push_back(id);
  }
  return order;
}

}  // namespace

bool has_others(const Window& window, const ExperienceId& run) {
  return std::any_of(window.places.begin(), window.places.end(),
                     [&run](const auto& entry) { return entry.first.experience != run; });
}

void RelocalisationQueue::start(const std::optional<PlaceId>& seed) {
  *this = RelocalisationQueue{};
  active_ = true;
  seed_ = seed;
}

OrRefusal<void> RelocalisationQueue::prepare(const NavigationConfig& config, const Window& window,
                                             const std::optional<Estimate>& last) {
  if (pause_ > 0) {
    --pause_;
    return tl::unexpected(Refusal{"seek_pause", static_cast<double>(pause_), 0.0});
  }
  if (!order_.empty()) return {};
  if (window.places.empty()) return tl::unexpected(Refusal{"window_empty", 0.0, 1.0});
  ordered_ = seed_.has_value() || last.has_value();
  if (seed_) {
    order_ = around_seed(config, window, *seed_);
  } else {
    std::vector<PlaceId> near = last ? around_last(config, window, *last) : std::vector<PlaceId>{};
    std::erase_if(near, [this](const PlaceId& id) { return leaves_out(id); });
    near_left_ = near.size();
    order_ = everywhere(window, std::move(near), left_out_);
  }
  if (order_.empty()) return tl::unexpected(Refusal{"seed_not_in_window", 0.0, 1.0});
  std::reverse(order_.begin(), order_.end());
  return {};
}

std::optional<PlaceId> RelocalisationQueue::next() {
  if (order_.empty()) return std::nullopt;
  const PlaceId id = order_.back();
  order_.pop_back();
  if (near_left_ > 0) --near_left_;
  if (order_.empty()) pause_ = pause_samples;
  return id;
}

}  // namespace weft::agents
