#include "server/jobs/jobs.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>

#include "server/base/outcome.hpp"

namespace weft::server {
namespace {
using namespace std::chrono_literals;
using Kind = msg::OperatorRequest::Kind;

constexpr Duration kBetweenReplies = 500ms;
constexpr int kPruneStepsAPiece = 4;
constexpr std::size_t kFindingsInReply = 100;

std::string name_of(Kind kind) {
  switch (kind) {
    case Kind::check:
      return "check";
    case Kind::snapshot:
    case Kind::snapshot_verified:
      return "snapshot";
    case Kind::replace:
      return "replace";
    case Kind::compact:
      return "compact";
    case Kind::stats:
      return "stats";
    default:
      return "prune";
  }
}

msg::OperatorReply refusal(const Error& error) {
  msg::OperatorReply reply;
  reply.outcome = outcome_of(error);
  reply.message = error.message;
  return reply;
}

}  // namespace

std::optional<msg::OperatorReply> Jobs::begin(const Key& key, const msg::OperatorRequest& request,
                                              const std::string& who, Now now) {
  if (running_) {
    return refusal({ErrorCode::refused, "a " + name_of(running_->request.kind) + " that " + running_->who +
                                            " asked for is under way: wait for its end"});
  }
  Result<Running> made = make(request);
  if (!made) return refusal(made.error());
  running_ = *std::move(made);
  running_->key = key;
  running_->request = request;
  running_->who = who;
  running_->say_at = now.steady + kBetweenReplies;
  running_->work_at = now.steady;
  return std::nullopt;
}

Result<Jobs::Running> Jobs::make(const msg::OperatorRequest& request) const {
  Running running;
  if (request.kind == Kind::prune || request.kind == Kind::replace) {
    Result<Pruner> pruner = make_pruner(request);
    if (!pruner) return fail(pruner.error());
    running.pruner.emplace(*std::move(pruner));
    return running;
  }
  const bool is_snapshot = request.kind == Kind::snapshot || request.kind == Kind::snapshot_verified;
  if (is_snapshot && !request.work.file.starts_with('/')) {
    return fail(ErrorCode::invalid, "'" + request.work.file +
                                        "' is no absolute path; the file is written where the server runs: name it "
                                        "from / on");
  }
  if (request.kind == Kind::compact && editor_.holds_what_is_out()) {
    return fail(ErrorCode::refused,
                "a robot holds places that are out of the map, and what lay around them is known "
                "from the past alone: wait until it has left them, or weft robot clear");
  }
  Result<std::unique_ptr<storage::StoreJob>> job = store_job(request);
  if (!job) return fail(job.error());
  running.store_job = *std::move(job);
  return running;
}

Result<std::unique_ptr<storage::StoreJob>> Jobs::store_job(const msg::OperatorRequest& request) const {
  switch (request.kind) {
    case Kind::check:
      return context_.maintenance.check();
    case Kind::snapshot:
    case Kind::snapshot_verified:
      return context_.maintenance.snapshot_to(request.work.file);
    case Kind::compact:
      return context_.maintenance.compact(request.work.revision);
    default:
      return context_.maintenance.stats();
  }
}

Result<Pruner> Jobs::make_pruner(const msg::OperatorRequest& request) const {
  const Snapshot& snapshot = context_.snapshots.current();
  PruneRule rule;
  rule.keep = editor_.in_use();
  if (request.work.within_m > 0.0) rule.within_m = request.work.within_m;
  if (request.work.within_rad > 0.0) rule.within_rad = request.work.within_rad;
  if (request.kind == Kind::replace) {
    const Result<ExperienceId> by = experience_of(snapshot, request.label);
    if (!by) return fail(by.error());
    rule.by = *by;
  }
  return Pruner(snapshot, std::move(rule));
}

Jobs::Replies Jobs::tick(Now now) {
  if (!running_) return {};
  running_->work_at = now.steady;
  msg::OperatorReply reply = running_->pruner ? work_on_pruning(now) : work_on_store(now);
  const bool ended = reply.outcome != msg::Outcome::under_way;
  if (!ended && now.steady < running_->say_at) return {};
  running_->say_at = now.steady + kBetweenReplies;
  const Key key = running_->key;
  if (ended) {
    reply.findings = std::move(running_->findings);
    note_end(reply, now);
    running_.reset();
  } else {
    reply.findings = std::exchange(running_->unsaid, {});
  }
  return {{key, std::move(reply)}};
}

msg::OperatorReply Jobs::work_on_store(Now /*now*/) {
  const Result<storage::JobProgress> progress = running_->store_job->step();
  if (!progress) return refusal(running_->written.empty() ? progress.error() : unverified(progress.error()));
  for (const std::string& finding : progress->findings) {
    ++running_->found;
    if (running_->findings.size() < kFindingsInReply) running_->findings.push_back(clipped(finding));
    if (running_->unsaid.size() < kFindingsInReply) running_->unsaid.push_back(clipped(finding));
  }
  msg::OperatorReply reply;
  reply.outcome = msg::Outcome::under_way;
  reply.done = progress->done;
  reply.total = progress->total;
  reply.unit = progress->unit;
  if (!progress->finished) return reply;
  if (running_->request.kind == Kind::snapshot_verified && running_->written.empty()) return verify(*progress, reply);
  reply.outcome = running_->found == 0 ? msg::Outcome::done : msg::Outcome::failed;
  reply.message = running_->written.empty() ? progress->summary : running_->written + "; " + progress->summary;
  if (running_->request.kind == Kind::check) reply.counts.emplace_back("findings", running_->found);
  for (const storage::SpaceUse& use : progress->space) {
    reply.counts.emplace_back(use.kind + ": count", use.count);
    reply.counts.emplace_back(use.kind + ": bytes on disk", use.disk_bytes);
    reply.counts.emplace_back(use.kind + ": bytes as handed in", use.uncompressed_bytes);
  }
  return reply;
}

Error Jobs::unverified(const Error& error) const {
  return {error.code, running_->written + ", but nobody has seen whether it restores: " + error.message};
}

/// Begins to verify the copy that has just ended, so the map that is served is the map of its revision.
msg::OperatorReply Jobs::verify(const storage::JobProgress& copied, msg::OperatorReply reply) {
  running_->written = copied.summary;
  auto job = context_.maintenance.verify(running_->request.work.file, context_.snapshots.current());
  if (!job) return refusal(unverified(job.error()));
  running_->store_job = *std::move(job);
  return reply;
}

msg::OperatorReply Jobs::work_on_pruning(Now now) {
  Pruner& pruner = *running_->pruner;
  for (int i = 0; i < kPruneStepsAPiece; ++i) {
    if (!pruner.step()) return pruned(now);
  }
  msg::OperatorReply reply;
  reply.outcome = msg::Outcome::under_way;
  reply.done = pruner.done();
  reply.total = pruner.total();
  reply.unit = "places";
  return reply;
}

msg::OperatorReply Jobs::pruned(Now now) {
  const Pruner& pruner = *running_->pruner;
  const Snapshot& current = context_.snapshots.current();
  const bool replaces = running_->request.kind == Kind::replace;
  Edit edit;
  edit.kind = replaces ? "replace" : "prune";
  edit.cause = replaces ? "what experience " + running_->request.label + " covers" : "places that others cover";
  if (!only_grew(pruner.snapshot(), current)) {
    return refusal({ErrorCode::refused, "the map was edited meanwhile, nothing was changed: ask again"});
  }
  edit.out = still_unneeded(pruner, current, editor_.in_use());
  const std::uint64_t bytes = content_bytes(current, edit.out);
  msg::OperatorReply reply;
  if (edit.out.empty()) {
    reply.message = replaces ? "experience " + running_->request.label + " covers nothing that could go"
                             : "no place is covered by others: nothing was changed";
  } else if (running_->request.work.only_say) {
    reply.message = "it would be so: " + to_text(edit) + "; nothing was changed";
  } else {
    reply = editor_.commit(edit, running_->who, now);
  }
  reply.counts.emplace_back("places", place_count(edit.out));
  reply.counts.emplace_back("content_bytes", bytes);
  return reply;
}

void Jobs::note_end(const msg::OperatorReply& reply, Now now) {
  context_.writer.note({.at = {},
                        .kind = "map." + name_of(running_->request.kind) + "_ended",
                        .robot = {},
                        .goal = {},
                        .cause = reply.message,
                        .who = running_->who},
                       now);
}

}  // namespace weft::server
