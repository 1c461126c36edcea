#include "server/keeper/subscriptions.hpp"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

#include "server/base/repeating.hpp"
#include "server/keeper/parts.hpp"
#include "server/keeper/untouched.hpp"

namespace weft::server {
namespace {
using namespace std::chrono_literals;

constexpr Duration kBetweenPatches = 500ms;
}  // namespace

void Subscriptions::on_request(const msg::WindowRequest& request, SteadyTime now) {
  const PeerId peer = request.header.sender;
  if (askers_.size() >= kMostAskers && !askers_.contains(peer)) {
    ++context_.counters["keeper: too many askers"];
    return;
  }
  Asker& asker = askers_[peer];
  asker.definition_id = request.definition_id;
  asker.definition = request.definition;
  // A window of another definition is as good a base, as long as both know it.
  const bool holds_what_we_think =
      asker.held && asker.held->revision == request.held && asker.held_digest == request.held_digest;
  if (!holds_what_we_think) {
    believe(asker, request.held, request.held_digest);
  }
  asker.held_digest = request.held_digest;
  asker.behind = true;
  asker.asked = true;
  if (asker.next_patch <= now) serve(peer, asker, now);
}

void Subscriptions::send(const PeerId& peer, std::uint64_t definition_id, const Patch& patch) {
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

void Subscriptions::believe(Asker& asker, Revision revision, const Digest& held_digest) const {
  asker.held = nullptr;
  asker.of = context_.snapshots.at(revision);
  asker.held_definition = asker.definition;
  if (revision == Revision{}) return;
  // A revision that is not kept any more may still look the same from there.
  if (!asker.of) asker.of = context_.snapshots.shared_current();
  Window window = make_window(*asker.of, asker.definition);
  // A window of another definition, or one that went wrong, is no base: the asker gets a fresh one.
  if (digest(window) != held_digest) return;
  window.revision = revision;
  asker.held = std::make_shared<const Window>(std::move(window));
}

std::pair<std::shared_ptr<const Window>, Digest> Subscriptions::window_now(const WindowDefinition& definition) const {
  const Snapshot& current = context_.snapshots.current();
  // Whoever asks again, or asks for what another one has, is told what is there already.
  for (const auto& [peer, asker] : askers_) {
    const bool is_it =
        asker.held && asker.held->revision == current.revision() && asker.held_definition == definition;
    if (is_it) return {asker.held, asker.held_digest};
  }
  auto window = std::make_shared<const Window>(make_window(current, definition));
  const Digest of_it = digest(*window);
  return {std::move(window), of_it};
}

bool Subscriptions::serve(const PeerId& peer, Asker& asker, SteadyTime now) {
  asker.behind = false;
  const std::shared_ptr<const Snapshot> current = context_.snapshots.shared_current();
  if (!asker.asked && asker.held && is_untouched(asker.held_definition, *asker.held, *asker.of, *current)) {
    asker.of = current;
    return false;
  }
  const auto [target, target_digest] = window_now(asker.definition);
  const bool holds_it = asker.held != nullptr && asker.held_digest == target_digest;
  // An asker is answered even if nothing changed: it may be waiting for its new definition to be confirmed.
  if (holds_it && !asker.asked) {
    asker.of = current;
    return true;
  }
  asker.asked = false;
  const Window empty;
  send(peer, asker.definition_id, difference(asker.held ? *asker.held : empty, *target, target_digest));
  asker.held = target;
  asker.of = current;
  asker.held_digest = target_digest;
  asker.held_definition = asker.definition;
  asker.next_patch = now + kBetweenPatches;
  return true;
}

void Subscriptions::network_changed() {
  for (auto& [peer, asker] : askers_) asker.behind = true;
}

void Subscriptions::tick(SteadyTime now) {
  std::vector<std::pair<SteadyTime, PeerId>> due;
  for (const auto& [peer, asker] : askers_) {
    if (asker.behind && asker.next_patch <= now) due.emplace_back(asker.next_patch, peer);
  }
  std::sort(due.begin(), due.end());
  for (const auto& [since, peer] : due) {
    if (serve(peer, askers_.at(peer), now)) return;
  }
}

std::optional<SteadyTime> Subscriptions::next() const {
  std::optional<SteadyTime> next;
  for (const auto& [peer, asker] : askers_) {
    if (asker.behind && (!next || asker.next_patch < *next)) next = asker.next_patch;
  }
  return next;
}

}  // namespace weft::server
