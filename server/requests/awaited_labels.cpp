#include "server/requests/awaited_labels.hpp"

#include <algorithm>
#include <chrono>

namespace weft::server {
namespace {
using namespace std::chrono_literals;

/// Is shorter than clients wait for an answer.
constexpr Duration kBetweenTellings = 10s;
}  // namespace

AwaitedLabels::AwaitedLabels(const std::map<std::string, Label>& stored, SteadyTime now) {
  for (const auto& [name, label] : stored) awaited_.emplace(name, Awaited{label, {}, now});
}

Result<void> AwaitedLabels::check_room(const std::string& label) const {
  if (awaited_.size() < kMost || awaited_.contains(label)) return {};
  return fail(ErrorCode::refused,
              "label " + label + ": " + std::to_string(awaited_.size()) +
                  " labels wait for places that robots have not handed in, and no more are kept; let a robot hand in "
                  "what it was taught, or withdraw one that waits, such as " +
                  awaited_.begin()->first + " (weft map unlabel " + awaited_.begin()->first + ")");
}

void AwaitedLabels::add(Label label, SteadyTime now) {
  const std::string name = label.label;
  awaited_.insert_or_assign(name, Awaited{std::move(label), {}, now + kBetweenTellings});
}

const AwaitedLabels::Label* AwaitedLabels::find(const std::string& label) const {
  const auto found = awaited_.find(label);
  return found == awaited_.end() ? nullptr : &found->second.label;
}

std::optional<AwaitedLabels::Label> AwaitedLabels::take(const std::string& label) {
  const auto found = awaited_.find(label);
  if (found == awaited_.end()) return std::nullopt;
  Label taken = std::move(found->second.label);
  awaited_.erase(found);
  return taken;
}

void AwaitedLabels::run_ended(const PlaceId& first, const std::string& why) {
  for (auto& [name, awaited] : awaited_) {
    const PlaceId& place = awaited.label.place;
    if (place.experience == first.experience && place.index >= first.index) awaited.never_comes = why;
  }
}

void AwaitedLabels::robot_gone(const RobotId& robot, const std::string& why) {
  for (auto& [name, awaited] : awaited_) {
    if (awaited.label.robot == robot) awaited.never_comes = why;
  }
}

std::vector<AwaitedLabels::Awaited> AwaitedLabels::all() const {
  std::vector<Awaited> all;
  all.reserve(awaited_.size());
  for (const auto& [name, awaited] : awaited_) all.push_back(awaited);
  return all;
}

AwaitedLabels::Replies AwaitedLabels::tick(SteadyTime now) {
  Replies replies;
  for (auto& [name, awaited] : awaited_) {
    if (now < awaited.told_again_at) continue;
    awaited.told_again_at = now + kBetweenTellings;
    const PlaceId& place = awaited.label.place;
    msg::OperatorReply reply;
    reply.outcome = msg::Outcome::under_way;
    reply.place = place;
    reply.message = to_string(place) + " is kept, and becomes " + name + " when the robot hands it in";
    replies.emplace_back(key_of(awaited.label), std::move(reply));
  }
  return replies;
}

std::optional<SteadyTime> AwaitedLabels::next() const {
  const auto first =
      std::ranges::min_element(awaited_, {}, [](const auto& entry) { return entry.second.told_again_at; });
  return first == awaited_.end() ? std::nullopt : std::optional(first->second.told_again_at);
}

}  // namespace weft::server
