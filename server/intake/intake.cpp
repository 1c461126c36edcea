#include "server/intake/intake.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/network/called.hpp"

namespace weft::server {
namespace {
using namespace std::chrono_literals;

constexpr Duration kRetry = 2s;
constexpr std::size_t kBatchesAhead = 16;               ///< batches of one experience that may wait
constexpr std::uint64_t kWaitingBytes = 256ULL << 20U;  ///< contents that may wait for the rest of their batch
constexpr std::size_t kMissingInAck = 256;
constexpr std::size_t kMostOpenStreams = 1024;
}  // namespace

Intake::Intake(Context& context, const std::map<ExperienceId, std::uint64_t>& durable_through) : context_(context) {
  for (const auto& [experience, through] : durable_through) {
    ExperienceStream& stream = streams_[experience];
    stream.durable_through = through;
    const Experience* const known = context.snapshots.current().experience(experience);
    if (known != nullptr) stream.robot = known->robot;
  }
}

std::vector<Batch> Intake::on_batch(const msg::ExperienceBatch& message, const std::string& who, Now now) {
  const Batch& batch = message.batch;
  const RobotId sender = message.header.sender;
  if (batch.robot != sender || !batch.experience || batch.sequence == 0) {
    ++context_.counters["intake: batch without an id, or of another robot"];
    return {};
  }
  const bool is_new = !streams_.contains(batch.experience);
  if (is_new && streams_.size() >= kMostOpenStreams + context_.snapshots.current().experiences().size()) {
    ++context_.counters["intake: too many unfinished experiences"];
    return {};
  }
  ExperienceStream& stream = streams_[batch.experience];
  if (is_new) stream.robot = sender;
  if (stream.robot != sender) {
    ++context_.counters["intake: experience of another robot"];
    return {};
  }
  const ContentHash hash = weft::hash(batch);
  if (batch.sequence <= stream.durable_through) {
    if (context_.store.batch_hash(batch.experience, batch.sequence) != hash) {
      refuse(stream, batch, hash, {ErrorCode::conflict, "it is on disk with another hash"}, now);
    }
  } else if (const Result<void> taken = accept(stream, message, who, hash); !taken) {
    if (taken.error().code == ErrorCode::exhausted) {
      ++context_.counters["intake: no room, batch to be repeated"];
    } else {
      refuse(stream, batch, hash, taken.error(), now);
    }
  }
  std::vector<Batch> joined = advance(batch.experience, now);
  answer(batch.experience, stream);
  return joined;
}

/// Takes the batch into the queue of its stream. exhausted: there is no room now, it will be repeated. Any other
/// error: it is refused for good.
Result<void> Intake::accept(ExperienceStream& stream, const msg::ExperienceBatch& message, const std::string& who,
                            const ContentHash& hash) {
  const Batch& batch = message.batch;
  const auto found = stream.waiting.find(batch.sequence);
  if (found != stream.waiting.end()) {
    if (found->second.hash == hash) {
      if (found->second.who.empty()) found->second.who = who;  // it can have come before its sender's hello
      return {};
    }
    return fail(ErrorCode::conflict, "it came before with another hash, and that one waits for its contents");
  }
  if (batch.sequence > stream.durable_through + kBatchesAhead) return fail(ErrorCode::exhausted, "too far ahead");
  const Place* wrong = nullptr;
  for_each_place(batch, [&](const Place& place) {
    if (place.content.size == 0 || place.content.size > msg::kContentBytes) wrong = &place;
  });
  if (wrong != nullptr) {
    return fail(ErrorCode::invalid, "content of place " + to_string(wrong->id) + " has " +
                                        std::to_string(wrong->content.size) + " bytes; 1 to " +
                                        std::to_string(msg::kContentBytes) + " are taken");
  }
  std::map<ContentHash, std::uint64_t> needs = contents_needed(batch);
  if (const Result<void> room = make_room(needs); !room) return room;
  for (const auto& [content, size] : needs) expect(content, size);
  stream.waiting.emplace(batch.sequence, Waiting{.batch = batch,
                                                 .hash = hash,
                                                 .needs = std::move(needs),
                                                 .incarnation = message.header.incarnation,
                                                 .who = who});
  return {};
}

void Intake::expect(const ContentHash& content, std::uint64_t size) {
  const auto [at, is_new] = incoming_.try_emplace(content, Incoming{.size = size, .assembly = Assembly(size)});
  ++at->second.wanted_by;
  if (is_new) bytes_ += size;
}

/// Returns true when something is to be asked for again: what was stored when the batch came can be gone when it
/// joins, as a compaction deletes what nothing names, and a check sets damaged contents aside.
bool Intake::expect_missing(Waiting& waiting) {
  bool any = false;
  for_each_place(waiting.batch, [&](const Place& place) {
    const ContentRef& content = place.content;
    if (waiting.needs.contains(content.hash) || context_.store.has_content(content.hash)) return;
    waiting.needs.emplace(content.hash, content.size);
    expect(content.hash, content.size);
    any = true;
  });
  return any;
}

std::map<ContentHash, std::uint64_t> Intake::contents_needed(const Batch& batch) const {
  std::map<ContentHash, std::uint64_t> needs;
  for_each_place(batch, [&](const Place& place) {
    if (!context_.store.has_content(place.content.hash)) needs.emplace(place.content.hash, place.content.size);
  });
  return needs;
}

Result<void> Intake::make_room(const std::map<ContentHash, std::uint64_t>& needs) {
  std::uint64_t more = 0;
  for (const auto& [content, size] : needs) {
    const auto found = incoming_.find(content);
    if (found == incoming_.end()) {
      more += size;
    } else if (found->second.size != size) {
      return fail(ErrorCode::invalid, "content " + to_string(content) + " is stated with two sizes");
    }
  }
  if (more > kWaitingBytes) {
    return fail(ErrorCode::invalid, "the batch's contents have " + std::to_string(more) + " bytes; at most " +
                                        std::to_string(kWaitingBytes) + " are taken at once: send smaller batches");
  }
  if (bytes_ + more > kWaitingBytes) return fail(ErrorCode::exhausted, "contents of other batches wait");
  return {};
}

std::vector<Batch> Intake::on_chunk(const msg::Chunk& chunk, Now now) {
  const auto found = incoming_.find(chunk.hash);
  if (chunk.kind != msg::ContentKind::content || found == incoming_.end()) {
    ++context_.counters["intake: chunk that no batch waits for"];
    return {};
  }
  if (chunk.coding != msg::Coding::raw) {
    ++context_.counters["intake: chunk that is not raw"];
    return {};
  }
  Incoming& incoming = found->second;
  if (incoming.done) return {};
  if (!incoming.assembly.add(chunk)) {
    ++context_.counters["intake: chunk outside of its content"];
    return {};
  }
  if (!incoming.assembly.is_complete()) return {};
  Result<Bytes> bytes = std::move(incoming.assembly).take(chunk.hash);
  incoming.assembly = Assembly(bytes ? 0 : incoming.size);
  if (!bytes) {
    ++context_.counters["intake: content with a wrong hash"];
    context_.writer.note({.at = {},
                          .kind = "intake.content_refused",
                          .robot = chunk.header.sender,
                          .goal = {},
                          .cause = bytes.error().message,
                          .who = "server"},
                         now);
    return {};
  }
  incoming.done = *std::move(bytes);
  std::vector<Batch> joined;
  for (auto& [experience, stream] : streams_) {
    if (stream.waiting.empty() || !stream.waiting.begin()->second.needs.contains(chunk.hash)) continue;
    std::vector<Batch> more = advance_and_answer(experience, stream, now);
    joined.insert(joined.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }
  return joined;
}

bool Intake::is_ready(const Waiting& waiting) const {
  return std::all_of(waiting.needs.begin(), waiting.needs.end(), [this](const auto& need) {
    const auto found = incoming_.find(need.first);
    return (found != incoming_.end() && found->second.done) || context_.store.has_content(need.first);
  });
}

std::vector<Batch> Intake::advance_and_answer(ExperienceId experience, ExperienceStream& stream, Now now) {
  std::vector<Batch> joined = advance(experience, now);
  if (!joined.empty() || stream.refusal) answer(experience, stream);
  return joined;
}

std::vector<Batch> Intake::advance(ExperienceId experience, Now now) {
  std::vector<Batch> joined;
  ExperienceStream& stream = streams_.at(experience);
  while (true) {
    const auto next = stream.waiting.find(stream.durable_through + 1);
    if (next == stream.waiting.end()) return joined;
    const std::uint64_t sequence = next->first;
    // At once, so that nobody sends contents for nothing, and again before it joins.
    const bool ready = is_ready(next->second);
    if (ready || !next->second.is_checked) {
      const std::vector<Error> issues = check(context_.snapshots.current(), next->second.batch);
      if (!issues.empty()) {
        refuse_waiting(stream, sequence, issues.front(), now);
        return joined;
      }
      next->second.is_checked = true;
    }
    if (!ready) return joined;
    if (expect_missing(next->second)) {
      answer(experience, stream);
      return joined;
    }
    drop_late_learning(next->second.batch);
    if (const Result<void> done = commit(stream, next->second, now); !done) {
      const bool never_fits = done.error().code == ErrorCode::conflict || done.error().code == ErrorCode::invalid;
      if (never_fits) {
        refuse_waiting(stream, sequence, done.error(), now);
      } else {
        retry_at_ = now.steady + kRetry;
      }
      return joined;
    }
    seal_abandoned(next->second, now);
    joined.push_back(std::move(next->second.batch));
    forget(stream, sequence);
  }
}

/// Drops what the batch has learned too late: of two robots that learn beside each other the first one counts, and
/// the second one learns anew upon it. The batch keeps the hash under which it was handed in.
void Intake::drop_late_learning(Batch& batch) {
  const std::size_t handed_in = batch.learned.size();
  batch = in_time(context_.snapshots.current(), std::move(batch));
  const std::size_t late = handed_in - batch.learned.size();
  if (late > 0) context_.counters["intake: places learned too late"] += late;
}

Result<void> Intake::commit(ExperienceStream& stream, const Waiting& waiting, Now now) {
  storage::Transaction transaction;
  transaction.note.who = waiting.who;
  std::set<ContentHash> named;
  for_each_place(waiting.batch, [&](const Place& place) { named.insert(place.content.hash); });
  for (const auto& [content, size] : waiting.needs) {
    if (!named.contains(content) || context_.store.has_content(content)) continue;
    transaction.changes.emplace_back(storage::PutContent{
        .hash = content, .kind = msg::ContentKind::content, .bytes = *incoming_.at(content).done});
  }
  transaction.changes.emplace_back(storage::AppendBatch{.batch = waiting.batch, .hash = waiting.hash});
  if (waiting.batch.sequence == 1 || waiting.batch.seal) {
    transaction.changes.emplace_back(storage::PutEvent{
        {.at = {},
         .kind = waiting.batch.seal ? "experience.sealed" : "experience.begun",
         .robot = waiting.batch.robot,
         .goal = {},
         .cause = called(waiting.batch) + (waiting.batch.seal ? ": " + waiting.batch.seal_reason : ""),
         .who = "server"}});
  }
  if (const auto done = context_.writer.commit(std::move(transaction), now); !done) return fail(done.error());
  stream.durable_through = waiting.batch.sequence;
  stream.incarnation = waiting.incarnation;
  ++acknowledged_;
  return {};
}

/// Seals what the robot had left open and has given up, as it begins another experience after a restart: its agent
/// sends what it still has of older ones first.
void Intake::seal_abandoned(const Waiting& waiting, Now now) {
  if (waiting.batch.sequence != 1) return;
  std::vector<ExperienceId> open;
  for (const auto& [id, experience] : context_.snapshots.current().experiences()) {
    if (id == waiting.batch.experience || experience->sealed || experience->robot != waiting.batch.robot) continue;
    const ExperienceStream& stream = streams_[id];
    if (stream.waiting.empty() && stream.incarnation != waiting.incarnation) open.push_back(id);
  }
  for (const ExperienceId id : open) {
    const std::string reason = "its robot began " + to_string(waiting.batch.experience) + " after a restart";
    if (!context_.writer.commit({{storage::SealExperience{.experience = id, .reason = reason},
                                  storage::PutEvent{{.at = {},
                                                     .kind = "experience.sealed",
                                                     .robot = waiting.batch.robot,
                                                     .goal = {},
                                                     .cause = to_string(id) + ": " + reason,
                                                     .who = "server"}}}},
                                now)) {
      return;
    }
  }
}

void Intake::refuse(ExperienceStream& stream, const Batch& batch, const ContentHash& hash, const Error& why,
                    Now now) {
  stream.refusal = why;
  stream.refusal_of = batch.sequence;
  if (stream.last_refused == hash) return;
  stream.last_refused = hash;
  ++refused_;
  refused_batches_.emplace_back(batch, why);
  ++context_.counters[std::string("intake: batch refused, ") + to_string(why.code)];
  context_.writer.note(
      {.at = {},
       .kind = "intake.refused",
       .robot = batch.robot,
       .goal = {},
       .cause = to_string(batch.experience) + " batch " + std::to_string(batch.sequence) + ": " + why.message,
       .who = "server"},
      now);
}

void Intake::refuse_waiting(ExperienceStream& stream, std::uint64_t sequence, const Error& why, Now now) {
  const Waiting& wrong = stream.waiting.at(sequence);
  refuse(stream, wrong.batch, wrong.hash, why, now);
  // What follows a batch that never comes is never taken either.
  while (!stream.waiting.empty()) {
    const auto follower = stream.waiting.begin();
    if (follower->first != sequence) refused_batches_.emplace_back(follower->second.batch, why);
    forget(stream, follower->first);
  }
}

void Intake::forget(ExperienceStream& stream, std::uint64_t sequence) {
  const auto found = stream.waiting.find(sequence);
  if (found == stream.waiting.end()) return;
  for (const auto& [content, size] : found->second.needs) {
    const auto incoming = incoming_.find(content);
    if (incoming == incoming_.end() || --incoming->second.wanted_by > 0) continue;
    bytes_ -= size;
    incoming_.erase(incoming);
  }
  stream.waiting.erase(found);
}

void Intake::answer(ExperienceId experience, ExperienceStream& stream) {
  msg::BatchAck ack;
  ack.to = stream.robot;
  ack.experience = experience;
  ack.durable_through = stream.durable_through;
  if (stream.refusal) {
    ack.refused_sequence = stream.refusal_of;
    ack.refusal = clipped(stream.refusal->message);
    stream.refusal.reset();
  }
  const auto next = stream.waiting.find(stream.durable_through + 1);
  if (next != stream.waiting.end()) {
    for (const auto& [content, size] : next->second.needs) {
      const auto found = incoming_.find(content);
      if (found != incoming_.end() && !found->second.done) ack.missing.push_back(content);
      if (ack.missing.size() == kMissingInAck) break;
    }
  }
  context_.out.send(std::move(ack));
}

std::vector<Batch> Intake::tick(Now now) {
  std::vector<Batch> joined;
  if (!retry_at_ || *retry_at_ > now.steady) return joined;
  retry_at_.reset();
  for (auto& [experience, stream] : streams_) {
    if (stream.waiting.empty()) continue;
    std::vector<Batch> more = advance_and_answer(experience, stream, now);
    joined.insert(joined.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    if (retry_at_) return joined;
  }
  return joined;
}

}  // namespace weft::server
