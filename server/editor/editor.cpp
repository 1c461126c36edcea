#include "server/editor/editor.hpp"

#include <utility>

#include "server/base/outcome.hpp"

namespace weft::server {
namespace {

using Kind = msg::OperatorRequest::Kind;

storage::Transaction transaction_of(const Edit& edit, const std::string& who) {
  storage::Transaction transaction;
  if (edit.to.value != 0) {
    transaction.changes.emplace_back(storage::RollBack{edit.to});
  }
  if (!edit.out.empty()) transaction.changes.emplace_back(storage::TakeOut{edit.out});
  if (!edit.back.empty()) transaction.changes.emplace_back(storage::BringBack{edit.back});
  if (!edit.known_anew.empty()) transaction.changes.emplace_back(storage::PutPlaces{edit.known_anew});
  for (const auto& [label, place] : edit.labels) transaction.changes.emplace_back(storage::PutLabel{label, place});
  for (const auto& [apart, holds] : edit.aparts) transaction.changes.emplace_back(storage::PutApart{apart, holds});
  transaction.changes.emplace_back(storage::PutEvent{{.at = {},
                                                      .kind = "map." + edit.kind,
                                                      .robot = {},
                                                      .goal = {},
                                                      .cause = edit.cause + ": " + to_text(edit),
                                                      .who = who}});
  transaction.note.kind = edit.kind;
  transaction.note.who = who;
  transaction.note.cause = clipped(edit.cause + ": " + to_text(edit));
  return transaction;
}

/// Nothing but one pair.
bool is_one_apart(const Edit& edit) {
  const bool is_else = !edit.out.empty() || !edit.back.empty() || !edit.known_anew.empty() || !edit.labels.empty();
  return edit.aparts.size() == 1 && !is_else && edit.to.value == 0;
}

const char* edit_name(Kind kind) {
  switch (kind) {
    case Kind::rollback:
      return "rollback";
    case Kind::undo:
      return "undo";
    case Kind::apart:
      return "apart";
    case Kind::label_remove:
    case Kind::label_rename:
      return "label";
    default:
      return "quarantine";
  }
}

}  // namespace

Result<Edit> Editor::edit_for(const msg::OperatorRequest& request) const {
  const Snapshot& snapshot = context_.snapshots.current();
  const msg::MapWork& work = request.work;
  Result<Edit> edit = [&] {
    if (request.kind == Kind::rollback) return rolling_back(snapshot, context_.store, work.revision);
    if (request.kind == Kind::apart) return setting_apart(snapshot, request);
    if (request.kind == Kind::label_remove) return removing_label(snapshot, request.label);
    if (request.kind == Kind::label_rename) return renaming_label(snapshot, request.label, request.new_label);
    const bool is_revision = request.kind == Kind::undo && work.revision.value != 0;
    return is_revision ? undoing(snapshot, context_.store, work.revision) : taking_out(snapshot, request);
  }();
  if (edit) edit->kind = edit_name(request.kind);
  return edit;
}

msg::OperatorReply Editor::on_request(const msg::OperatorRequest& request, const std::string& who, Now now) {
  const Result<Edit> edit = edit_for(request);
  msg::OperatorReply reply;
  if (!edit) {
    reply.outcome = outcome_of(edit.error());
    reply.message = edit.error().message;
    return reply;
  }
  if (!request.work.only_say) return commit(*edit, who, now);
  reply.message = "it would be so: " + to_text(*edit) + "; nothing was changed";
  return reply;
}

msg::OperatorReply Editor::commit(const Edit& edit, const std::string& who, Now now) {
  msg::OperatorReply reply;
  const Result<Revision> revision = context_.record.commit(transaction_of(edit, who), now);
  if (!revision) {
    reply.outcome = msg::Outcome::failed;
    reply.message = "nothing was changed: " + revision.error().message;
    return reply;
  }
  Result<Snapshot> next = edited(edit, *revision);
  if (!next) {
    // What is stored is right; what is served would not be it any more.
    context_.record.give_up({ErrorCode::internal, "the edited map cannot be loaded, the server has to start anew: " +
                                                      next.error().message});
    reply.outcome = msg::Outcome::failed;
    reply.message = "it is stored as revision " + std::to_string(revision->value) +
                    "; the server has to start anew (" + next.error().message + ")";
    return reply;
  }
  const Snapshot before = context_.snapshots.current();
  context_.snapshots.push(*std::move(next));
  traffic_.edited(before);
  dispatcher_.network_edited();
  reply.revision = *revision;
  reply.message = "revision " + std::to_string(revision->value) + ": " + to_text(edit) +
                  " (weft map undo --revision " + std::to_string(revision->value) + " undoes it)";
  return reply;
}

std::set<PlaceId> Editor::in_use() const {
  std::set<PlaceId> places = traffic_.held_places();
  const GoalBook& book = dispatcher_.book();
  for (const auto& [number, id] : book.alive()) {
    places.insert(book.find(id)->to);
    if (const Route* const route = book.route(id)) places.insert(route->places.begin(), route->places.end());
  }
  return places;
}

Result<Snapshot> Editor::edited(const Edit& edit, Revision revision) const {
  const bool only_out = edit.back.empty() && edit.known_anew.empty() && edit.labels.empty() && edit.aparts.empty() &&
                        edit.to.value == 0;
  if (only_out) return without(context_.snapshots.current(), edit.out);
  const Snapshot& current = context_.snapshots.current();
  if (is_one_apart(edit) && is_served(current, edit.aparts.begin()->first)) {
    const auto& [apart, holds] = *edit.aparts.begin();
    return holds ? with_apart(current, apart) : without_apart(current, apart);
  }
  return context_.store.snapshot_at(revision, current);
}

}  // namespace weft::server
