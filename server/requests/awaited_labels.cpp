#include "server/requests/awaited_labels.hpp"

#include <algorithm>
#include <chrono>

namespace weft::server {
namespace {
using namespace std::chrono_literals;

/// Is shorter than clients wait for an answer.
constexpr Duration kBetweenTellings = 10s;
}  // namespace

void AwaitedLabels::add(const PlaceId& place, Label label, SteadyTime now) {
  awaited_.emplace(place, Awaited{std::move(label), now + kBetweenTellings});
}

std::vector<AwaitedLabels::Label> AwaitedLabels::take(const PlaceId& place) {
  std::vector<Label> taken;
  const auto [first, last] = awaited_.equal_range(place);
  for (auto at = first; at != last; ++at) taken.push_back(std::move(at->second.label));
  awaited_.erase(first, last);
  return taken;
}

AwaitedLabels::Replies AwaitedLabels::tick(SteadyTime now) {
  Replies replies;
  for (auto& [place, awaited] : awaited_) {
    if (now < awaited.told_again_at) continue;
    awaited.told_again_at = now + kBetweenTellings;
    msg::OperatorReply reply;
    reply.outcome = msg::Outcome::under_way;
    reply.place = place;
    reply.message = to_string(place) + " is kept, and becomes " + awaited.label.label + " when the robot hands it in";
    replies.emplace_back(awaited.label.key, std::move(reply));
  }
  return replies;
}

std::optional<SteadyTime> AwaitedLabels::next() const {
  const auto first =
      std::ranges::min_element(awaited_, {}, [](const auto& entry) { return entry.second.told_again_at; });
  return first == awaited_.end() ? std::nullopt : std::optional(first->second.told_again_at);
}

}  // namespace weft::server
