#include "server/windows/window_publisher.hpp"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

#include "server/base/repeating.hpp"
#include "server/windows/patch_parts.hpp"
#include "server/windows/untouched.hpp"

namespace weft::server {
namespace {
using namespace std::chrono_literals;

constexpr Duration kBetweenPatches = 500ms;
}  // namespace

void WindowPublisher::on_request(const msg::WindowRequest& request, SteadyTime now) {
  const PeerId peer = request.header.sender;
  if (subscribers_.size() >= kMostPeers && !subscribers_.contains(peer)) {
    ++context_.counters["keeper: too many askers"];
    return;
  }
  Subscriber& subscriber = subscribers_[peer];
  subscriber.definition_id = request.definition_id;
  subscriber.definition = request.definition;
  // A window of another definition is as good a base, as long as both know it.
  const bool holds_what_we_think =
      subscriber.held && subscriber.held->revision == request.held && subscriber.held_digest == request.held_digest;
  if (!holds_what_we_think) {
    assume_held(subscriber, request.held, request.held_digest);
  }
  subscriber.held_digest = request.held_digest;
  subscriber.behind = true;
  subscriber.asked = true;
  if (subscriber.next_patch <= now) serve(peer, subscriber, now);
}

void WindowPublisher::send(const PeerId& peer, std::uint64_t definition_id, const Patch& patch) {
  std::vector<Patch> parts = parts_of(patch, msg::kPatchEntities);
  const auto count = static_cast<std::uint32_t>(parts.size());
  for (std::uint32_t part = 0; part < count; ++part) {
    context_.out.send(msg::WindowPatch{.header = {},
                                       .to = peer,
                                       .definition_id = definition_id,
                                       .part = part,
                                       .parts = count,
                                       .patch = std::move(parts[part])});
  }
}

void WindowPublisher::assume_held(Subscriber& subscriber, Revision revision, const Digest& held_digest) const {
  subscriber.held = nullptr;
  subscriber.of = context_.snapshots.at(revision);
  subscriber.held_definition = subscriber.definition;
  if (revision == Revision{}) return;
  // A revision that is not kept any more may still look the same from there.
  if (!subscriber.of) subscriber.of = context_.snapshots.shared_current();
  Window window = make_window(*subscriber.of, subscriber.definition);
  // A window of another definition, or one that went wrong, is no base: the subscriber gets a fresh one.
  if (digest(window) != held_digest) return;
  window.revision = revision;
  subscriber.held = std::make_shared<const Window>(std::move(window));
}

std::pair<std::shared_ptr<const Window>, Digest> WindowPublisher::window_now(
    const WindowDefinition& definition) const {
  const Snapshot& current = context_.snapshots.current();
  // Whoever asks again, or asks for what another one has, is told what is there already.
  for (const auto& [peer, subscriber] : subscribers_) {
    const bool is_it = subscriber.held && subscriber.held->revision == current.revision() &&
                       subscriber.held_definition == definition;
    if (is_it) return {subscriber.held, subscriber.held_digest};
  }
  auto window = std::make_shared<const Window>(make_window(current, definition));
  const Digest of_it = digest(*window);
  return {std::move(window), of_it};
}

bool WindowPublisher::serve(const PeerId& peer, Subscriber& subscriber, SteadyTime now) {
  subscriber.behind = false;
  const std::shared_ptr<const Snapshot> current = context_.snapshots.shared_current();
  if (!subscriber.asked && subscriber.held &&
      is_untouched(subscriber.held_definition, *subscriber.held, *subscriber.of, *current)) {
    subscriber.of = current;
    return false;
  }
  const auto [target, target_digest] = window_now(subscriber.definition);
  const bool holds_it = subscriber.held != nullptr && subscriber.held_digest == target_digest;
  // A subscriber is answered even if nothing changed: it may be waiting for its new definition to be confirmed.
  if (holds_it && !subscriber.asked) {
    subscriber.of = current;
    return true;
  }
  subscriber.asked = false;
  const Window empty;
  send(peer, subscriber.definition_id,
       difference(subscriber.held ? *subscriber.held : empty, *target, target_digest));
  subscriber.held = target;
  subscriber.of = current;
  subscriber.held_digest = target_digest;
  subscriber.held_definition = subscriber.definition;
  subscriber.next_patch = now + kBetweenPatches;
  return true;
}

void WindowPublisher::network_changed() {
  for (auto& [peer, subscriber] : subscribers_) subscriber.behind = true;
}

void WindowPublisher::tick(SteadyTime now) {
  std::vector<std::pair<SteadyTime, PeerId>> due;
  for (const auto& [peer, subscriber] : subscribers_) {
    if (subscriber.behind && subscriber.next_patch <= now) due.emplace_back(subscriber.next_patch, peer);
  }
  std::sort(due.begin(), due.end());
  for (const auto& [since, peer] : due) {
    if (serve(peer, subscribers_.at(peer), now)) return;
  }
}

std::optional<SteadyTime> WindowPublisher::next() const {
  std::optional<SteadyTime> next;
  for (const auto& [peer, subscriber] : subscribers_) {
    if (subscriber.behind && (!next || subscriber.next_patch < *next)) next = subscriber.next_patch;
  }
  return next;
}

bool WindowPublisher::is_current(const PeerId& peer, const Digest& digest) const {
  const auto found = subscribers_.find(peer);
  if (found == subscribers_.end()) return false;
  const Subscriber& subscriber = found->second;
  return !subscriber.behind && !subscriber.asked && subscriber.held && subscriber.held_digest == digest;
}

std::size_t WindowPublisher::behind() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      subscribers_, [](const auto& entry) { return entry.second.behind || entry.second.asked; }));
}

}  // namespace weft::server
