#include "agents/agent/spooler.hpp"

#include <algorithm>
#include <utility>

namespace weft::agents {

namespace {
bool has(const Batch& batch, const PlaceId& place) {
  return batch.experience == place.experience && !batch.places.empty() &&
         batch.places.front().id.index <= place.index && place.index <= batch.places.back().id.index;
}
}  // namespace

Spooler::Spooler(storage::Spool& spool, const SpoolerConfig& config, RobotId self)
    : spool_(&spool), config_(config), self_(self) {}

std::optional<PlaceId> Spooler::newest_durable(ExperienceId experience) const {
  const auto found = newest_durable_.find(experience);
  return found != newest_durable_.end() ? std::optional(found->second) : std::nullopt;
}

void Spooler::begin(ExperienceId experience, const std::string& name) {
  std::erase_if(newest_durable_, [this](const auto& entry) { return !open_.contains(entry.first); });
  Open open;
  open.batch.experience = experience;
  open.batch.sequence = 1;
  open.batch.robot = self_;
  open.batch.name = name;
  open_.insert_or_assign(experience, std::move(open));
}

Result<void> Spooler::add(const Kept& kept, SteadyTime now) {
  const auto found = open_.find(kept.place.id.experience);
  if (found == open_.end()) {
    return fail(ErrorCode::conflict, "experience " + to_string(kept.place.id.experience) + " is not open any more");
  }
  Open& open = found->second;
  if (open.batch.places.empty()) open.since = now;
  open.batch.method = kept.place.method;
  open.batch.places.push_back(kept.place);
  open.batch.edges.insert(open.batch.edges.end(), kept.edges.begin(), kept.edges.end());
  open.contents.push_back(kept.content);
  ++open.places;
  if (open.batch.places.size() >= config_.batch_places) return flush(open, now);
  return {};
}

void Spooler::add(const Edge& edge) {
  const auto found = open_.find(edge.id.b.experience);
  if (found != open_.end()) found->second.batch.edges.push_back(edge);
}

/// Spools what a batch names first: a restarted agent is not to find an edge to a place that was in memory alone.
Result<void> Spooler::flush_what_it_names(const Batch& batch, SteadyTime now) {
  for (const Edge& edge : batch.edges) {
    const auto named = open_.find(edge.id.a.experience);
    if (edge.id.a.experience == batch.experience || named == open_.end()) continue;
    if (!has(named->second.batch, edge.id.a)) continue;
    if (Result<void> spooled = spool(named->second, now); !spooled) return spooled;
  }
  return {};
}

/// Spools an open batch after what it names. On an error the experience is open no more: `open` is gone then.
Result<void> Spooler::flush(Open& open, SteadyTime now) {
  const ExperienceId experience = open.batch.experience;
  if (Result<void> spooled = flush_what_it_names(open.batch, now); !spooled) {
    give_up(experience, now);
    return spooled;
  }
  return spool(open, now);
}

Result<void> Spooler::spool(Open& open, SteadyTime now) {
  Batch& batch = open.batch;
  if (batch.places.empty() && batch.learned.empty() && !batch.seal) return {};
  if (Result<void> appended = spool_->append(batch, open.contents); !appended) {
    give_up(batch.experience, now);
    return appended;
  }
  pending_.push_back({.batch = batch, .send_at = now, .wait = config_.retry});
  if (batch.seal) {
    unsealed_.erase(batch.experience);
    open_.erase(ExperienceId(batch.experience));
    return {};
  }
  unsealed_[batch.experience] = batch.sequence;
  ++batch.sequence;
  batch.places.clear();
  batch.learned.clear();
  batch.edges.clear();
  open.contents.clear();
  return {};
}

Result<void> Spooler::flush(SteadyTime now) {
  std::vector<ExperienceId> open;
  for (const auto& [experience, one] : open_) open.push_back(experience);
  Result<void> all;
  for (const ExperienceId experience : open) {
    const auto found = open_.find(experience);
    if (found == open_.end()) continue;
    if (Result<void> flushed = flush(found->second, now); !flushed) all = flushed;
  }
  return all;
}

Result<void> Spooler::learned(std::vector<Place> places, std::vector<Bytes> contents, ExperienceId fresh,
                              SteadyTime now) {
  if (places.empty()) return {};
  if (!learned_places_.has_value()) {
    learned_places_ = Open{};
    learned_places_->batch.experience = fresh;
    learned_places_->batch.sequence = 1;
    learned_places_->batch.robot = self_;
    learned_places_->batch.name = "learned_places";
    learned_places_->batch.method = places.front().method;
  }
  learned_places_->batch.learned = std::move(places);
  learned_places_->contents = std::move(contents);
  const Result<void> flushed = flush(*learned_places_, now);
  if (!flushed) learned_places_.reset();
  return flushed;
}

Result<void> Spooler::seal(const std::string& reason, SteadyTime now) {
  std::erase_if(open_, [this](const auto& entry) {
    if (entry.second.places == 0) held_.erase(entry.first);
    return entry.second.places == 0;
  });
  for (auto& [experience, open] : open_) {
    open.batch.seal = true;
    open.batch.seal_reason = reason;
    if (const auto held = held_.find(experience); held != held_.end()) {
      held->second = reason;
      open.batch.seal_reason += kUnrefinedSeal;
    }
  }
  return flush(now);
}

void Spooler::drop(ExperienceId experience, std::uint64_t through) {
  std::erase_if(pending_, [&](const Pending& pending) {
    return pending.batch.experience == experience && pending.batch.sequence <= through;
  });
}

Spooler::Heard Spooler::on_ack(const msg::BatchAck& ack, SteadyTime now) {
  Heard heard;
  for (const Pending& pending : pending_) {
    const Batch& batch = pending.batch;
    if (batch.experience != ack.experience || batch.sequence > ack.durable_through) continue;
    AckRecord record{.experience = batch.experience, .sequence = batch.sequence, .first = 0, .places = 0};
    if (!batch.places.empty()) {
      record.first = batch.places.front().id.index;
      record.places = static_cast<std::uint32_t>(batch.places.size());
      newest_durable_[batch.experience] = batch.places.back().id;
    }
    heard.acknowledged.push_back(record);
  }
  drop(ack.experience, ack.durable_through);
  const auto unsealed = unsealed_.find(ack.experience);
  std::uint64_t forget = ack.durable_through;
  if (unsealed != unsealed_.end()) forget = std::min(forget, unsealed->second - 1);
  // What the spool fails to forget it offers again at the next start: a repeat, harmless.
  if (forget > 0) std::ignore = spool_->acknowledged(ack.experience, forget);
  for (const Pending& pending : pending_) {
    if (pending.batch.experience != ack.experience || pending.batch.sequence != ack.durable_through + 1) continue;
    for_each_place(pending.batch, [&](const Place& place) {
      const bool missing = std::find(ack.missing.begin(), ack.missing.end(), place.content.hash) != ack.missing.end();
      if (missing) chunks_.push(place.content.hash, 0, now);
    });
  }
  if (ack.refused_sequence == 0) return heard;
  for (const Pending& pending : pending_) {
    const Batch& batch = pending.batch;
    const bool only_seals =
        batch.experience == ack.experience && batch.sequence == ack.refused_sequence && batch.places.empty();
    // The server has sealed it itself. What holds places is kept for people to look at.
    if (only_seals) std::ignore = spool_->acknowledged(ack.experience, batch.sequence);
  }
  drop(ack.experience, UINT64_MAX);
  unsealed_.erase(ack.experience);
  cut_short_.erase(ack.experience);
  heard.learned_places = learned_places_.has_value() && learned_places_->batch.experience == ack.experience;
  if (heard.learned_places) {
    std::ignore = spool_->acknowledged(ack.experience, learned_places_->batch.sequence);
    learned_places_.reset();
  }
  heard.refused = open_.erase(ack.experience) > 0;
  heard.reason = "the server refused batch " + std::to_string(ack.refused_sequence) + ": " + ack.refusal;
  return heard;
}

/// Returns whether a batch has to wait: it is held back, or the server does not have all that its edges name.
bool Spooler::waits(const Pending& pending) const {
  const Batch& batch = pending.batch;
  if (held_.contains(batch.experience)) return true;
  return std::any_of(batch.edges.begin(), batch.edges.end(), [&](const Edge& edge) {
    return edge.id.a.experience != batch.experience &&
           std::any_of(pending_.begin(), pending_.end(),
                       [&](const Pending& other) { return has(other.batch, edge.id.a); });
  });
}

bool Spooler::is_pending(ExperienceId experience) const {
  return std::any_of(pending_.begin(), pending_.end(),
                     [&](const Pending& pending) { return pending.batch.experience == experience; });
}

void Spooler::on_request(const msg::ContentRequest& request, SteadyTime now) {
  for (const msg::ContentRequest::Item& item : request.items) chunks_.push(item.hash, item.offset, now);
}

void Spooler::server_restarted(SteadyTime now) {
  chunks_.clear();
  for (Pending& pending : pending_) {
    pending.send_at = now;
    pending.wait = config_.retry;
    pending.contents_queued = false;
  }
}

void Spooler::queue_contents(Pending& pending, SteadyTime now) {
  pending.contents_queued = true;
  for_each_place(pending.batch, [&](const Place& place) { chunks_.push(place.content.hash, 0, now); });
}

Result<std::vector<Batch>> Spooler::due(SteadyTime now) {
  seal_cut_short(now);
  std::vector<ExperienceId> old;
  for (const auto& [experience, open] : open_) {
    if (!open.batch.places.empty() && now - open.since >= config_.batch_age) old.push_back(experience);
  }
  for (const ExperienceId experience : old) {
    const auto open = open_.find(experience);
    if (open == open_.end()) continue;
    if (Result<void> flushed = flush(open->second, now); !flushed) return fail(flushed.error());
  }
  std::vector<Batch> batches;
  std::size_t in_flight = 0;
  for (Pending& pending : pending_) {
    if (waits(pending)) continue;
    if (in_flight++ == config_.in_flight) break;
    if (pending.send_at > now) continue;
    batches.push_back(pending.batch);
    if (!pending.contents_queued) queue_contents(pending, now);
    pending.send_at = now + pending.wait;
    pending.wait = std::min(pending.wait * 2, config_.retry_most);
  }
  return batches;
}

Result<std::optional<msg::Chunk>> Spooler::next_chunk(Budget& budget, SteadyTime now) {
  return chunks_.next(
      budget, [this](const ContentHash& hash) { return spool_->content(hash); }, now);
}

std::optional<SteadyTime> Spooler::next() const {
  std::optional<SteadyTime> next;
  const auto sooner = [&next](SteadyTime at) { next = next.has_value() ? std::min(*next, at) : at; };
  for (const auto& [experience, open] : open_)
    if (!open.batch.places.empty()) sooner(open.since + config_.batch_age);
  if (!cut_short_.empty()) sooner(seal_at_);
  std::size_t in_flight = 0;
  for (const Pending& pending : pending_) {
    if (waits(pending)) continue;
    if (in_flight++ == config_.in_flight) break;
    sooner(pending.send_at);
  }
  return next;
}

}  // namespace weft::agents
