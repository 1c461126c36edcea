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
  for (const auto& [name, rule] : edit.rules) {
    Rule put = rule.value_or(Rule{});
    put.name = name;
    transaction.changes.emplace_back(storage::PutRule{.rule = std::move(put), .holds = rule.has_value()});
  }
  for (const auto& [plan, registration] : edit.registrations) {
    Registration put = registration.value_or(Registration{});
    put.plan = plan;
    transaction.changes.emplace_back(
        storage::PutRegistration{.registration = std::move(put), .holds = registration.has_value()});
  }
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
    case Kind::rule_put:
    case Kind::rule_remove:
    case Kind::hold:
    case Kind::unhold:
      return "rule";
    case Kind::plan_register:
    case Kind::plan_remove:
      return "register";
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
    if (request.kind == Kind::rule_put) return putting_rule(snapshot, request.rule);
    if (request.kind == Kind::rule_remove) return removing_rule(snapshot, request.rule.name);
    if (request.kind == Kind::plan_register) return putting_registration(snapshot, request.registration);
    if (request.kind == Kind::plan_remove) return removing_registration(snapshot, request.registration.plan);
    if (request.kind == Kind::hold) return holding_places_of(snapshot, request.robot);
    if (request.kind == Kind::unhold) return freeing_places_of(snapshot, request.robot);
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
  const MapWriter::Served before = context_.snapshots.shared_current();
  const Result<MapWriter::Served> served = context_.writer.commit(transaction_of(edit, who), now);
  if (!served) {
    reply.outcome = msg::Outcome::failed;
    reply.message = (context_.writer.unserved() ? "" : "nothing was changed: ") + served.error().message;
    return reply;
  }
  traffic_.edited(*before);
  dispatcher_.network_edited();
  const Revision revision = (*served)->revision();
  reply.revision = revision;
  reply.message = "revision " + std::to_string(revision.value) + ": " + to_text(edit) +
                  " (weft map undo --revision " + std::to_string(revision.value) + " undoes it)";
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

}  // namespace weft::server
