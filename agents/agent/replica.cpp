#include "agents/agent/replica.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr Duration kRetry = 500ms;
constexpr Duration kRetryMost = 8s;
/// Sets the least time between requests: two patches that pass each other on the way make no storm of them.
constexpr Duration kBetweenRequests = 250ms;
/// Sets how often to ask all the same: the server sends what changes, but may wrongly believe to have done so.
constexpr Duration kRefresh = 30s;

template <class T>
void append(std::vector<T>& all, std::vector<T>& more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}
}  // namespace

Replica::Replica(WindowDefinition definition, std::uint64_t first_id, SteadyTime now)
    : definition_(std::move(definition)),
      first_id_(first_id),
      definition_id_(first_id),
      digest_(weft::digest(window_)),
      ask_at_(now),
      asked_at_(now - kBetweenRequests),
      wait_(kRetry) {}

void Replica::define(WindowDefinition definition, SteadyTime now) {
  if (definition == definition_) return;
  definition_ = std::move(definition);
  ++definition_id_;
  parts_.reset();
  ask(now);
}

void Replica::ask(SteadyTime now) {
  wait_ = kRetry;
  ask_at_ = std::max(now, asked_at_ + kBetweenRequests);
}

void Replica::server_restarted(SteadyTime now) {
  parts_.reset();
  ask(now);
}

std::optional<msg::WindowRequest> Replica::due(SteadyTime now) {
  if (now < ask_at_) return std::nullopt;
  asked_at_ = now;
  if (is_settled() && !fresh_) {
    ask_at_ = now + kRefresh;
  } else {
    ask_at_ = now + wait_;
    wait_ = std::min(wait_ * 2, kRetryMost);
  }
  msg::WindowRequest request;
  request.definition_id = definition_id_;
  request.definition = definition_;
  if (!fresh_) {
    request.held = window_.revision;
    request.held_digest = digest_;
  }
  return request;
}

std::optional<Patch> Replica::join(const msg::WindowPatch& part) {
  if (part.parts == 0 || part.part >= part.parts) {
    ++counters_["patch: part beyond its parts"];
    return std::nullopt;
  }
  const Patch& patch = part.patch;
  const bool same = parts_.has_value() && parts_->base == patch.base && parts_->target == patch.target &&
                    parts_->digest == patch.digest && parts_->parts.size() == part.parts;
  if (!same) parts_ = Parts{patch.base, patch.target, patch.digest, std::vector<std::optional<Patch>>(part.parts)};
  parts_->parts[part.part] = patch;
  for (const std::optional<Patch>& have : parts_->parts) {
    if (!have.has_value()) return std::nullopt;
  }
  Patch joined = std::move(*parts_->parts.front());
  for (std::size_t i = 1; i < parts_->parts.size(); ++i) {
    Patch& more = *parts_->parts[i];
    append(joined.added, more.added);
    append(joined.changed, more.changed);
    append(joined.removed, more.removed);
    append(joined.edges, more.edges);
    append(joined.edges_removed, more.edges_removed);
    append(joined.labels_removed, more.labels_removed);
    joined.labels.merge(more.labels);
  }
  parts_.reset();
  return joined;
}

Replica::Heard Replica::on_patch(const msg::WindowPatch& part, SteadyTime now) {
  if (part.definition_id != definition_id_) {
    ++counters_["patch: of another window"];
    return Heard::ignored;
  }
  const bool old = is_settled() && !fresh_ && part.patch.target <= window_.revision;
  if (old && (part.patch.target < window_.revision || part.patch.digest == digest_)) return Heard::ignored;
  const std::optional<Patch> patch = join(part);
  if (!patch.has_value()) return Heard::incomplete;
  const bool from_nothing = patch->base.value == 0;
  Result<Window> applied = apply(from_nothing ? Window{} : window_, *patch);
  if (!applied) {
    const bool corrupt = applied.error().code == ErrorCode::corrupt;
    ++counters_[corrupt ? "patch: digest differs" : "patch: not of the revision held"];
    fresh_ = fresh_ || corrupt;
    ask(now);
    return Heard::ignored;
  }
  before_ = std::exchange(window_, std::move(*applied));
  digest_ = patch->digest;
  ++generation_;
  held_id_ = definition_id_;
  fresh_ = false;
  wait_ = kRetry;
  ask_at_ = now + kRefresh;
  return Heard::changed;
}

}  // namespace weft::agents
