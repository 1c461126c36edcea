#include <cmath>
#include <optional>
#include <utility>

#include "core/network/way_on.hpp"
#include "server/base/outcome.hpp"
#include "server/requests/operator_requests.hpp"

namespace weft::server {
namespace {

/// Bounds how far from a place a robot stands exactly on it.
constexpr double kOnPlace_m = 0.03;
constexpr double kOnPlace_rad = 0.035;

bool stands_on_its_place(const msg::RobotState& state) {
  return state.localised && state.place && distance_m(state.place_from_robot) <= kOnPlace_m &&
         std::abs(heading_rad(state.place_from_robot)) <= kOnPlace_rad;
}

std::string waits_no_longer(const AwaitedLabels::Label& label, const std::string& why) {
  return label.label + " waits no longer for " + to_string(label.place) + ": " + why;
}

std::string given_by(const std::string& who, const PlaceId& place) {
  return who + " gave the label to " + to_string(place);
}

}  // namespace

/// Returns, for people, where the label is from now on, and where it was.
std::string OperatorRequests::label_moves(const std::string& label, const PlaceId& place) const {
  const Snapshot::Labels& labels = context_.snapshots.current().labels();
  const auto known = labels.find(label);
  const bool moves = known != labels.end() && known->second != place;
  return label + " is " + to_string(place) + (moves ? ", no longer " + to_string(known->second) : "");
}

/// Sets the label; what waited under it waits no longer, in the same commit.
Result<void> OperatorRequests::put_label(const std::string& label, const PlaceId& place, const std::string& who,
                                         Now now) {
  if (const Result<void> good = check_name("label", label); !good) return fail(good.error());
  const Snapshot& snapshot = context_.snapshots.current();
  if (snapshot.place(place) == nullptr) return fail(ErrorCode::not_found, "the map has no place " + to_string(place));
  const auto known = snapshot.labels().find(label);
  const bool is_set = known != snapshot.labels().end() && known->second == place;
  const bool is_awaited = awaited_labels_.find(label) != nullptr;
  if (is_set && !is_awaited) return {};
  storage::Transaction transaction;
  transaction.note.who = who;
  if (is_awaited) transaction.changes.emplace_back(storage::PutAwaitedLabel{.label = label});
  if (!is_set) {
    transaction.changes.emplace_back(storage::PutLabel{.label = label, .place = place});
    transaction.changes.emplace_back(storage::PutEvent{
        {.at = {}, .kind = "map.label", .robot = {}, .goal = {}, .cause = label_moves(label, place), .who = who}});
  }
  if (const auto done = context_.writer.commit(std::move(transaction), now); !done) return fail(done.error());
  if (const std::optional<AwaitedLabels::Label> awaited = awaited_labels_.take(label)) {
    msg::OperatorReply reply;
    reply.outcome = awaited->place == place ? msg::Outcome::done : msg::Outcome::failed;
    reply.message =
        awaited->place == place ? label + " is " + to_string(place) : waits_no_longer(*awaited, given_by(who, place));
    reply.place = place;
    answer(key_of(*awaited), std::move(reply));
  }
  return {};
}

void OperatorRequests::label(const Key& key, const msg::OperatorRequest& request, const std::string& who, Now now) {
  msg::OperatorReply reply;
  reply.message = label_moves(request.label, request.place);
  const Result<void> done = put_label(request.label, request.place, who, now);
  if (!done) return answer(key, outcome_of(done.error()), done.error().message);
  reply.place = request.place;
  const Snapshot& network = context_.snapshots.current();
  if (const std::string why = no_way_on(network, request.place, methods_in(network)); !why.empty()) {
    reply.message += "; " + why;
  }
  answer(key, std::move(reply));
}

void OperatorRequests::label_here(const Key& key, const msg::OperatorRequest& request, const std::string& who,
                                  Now now) {
  if (const Result<void> good = check_name("label", request.label); !good) {
    return answer(key, msg::Outcome::refused, good.error().message);
  }
  const Result<const Robot*> robot = reachable(request.robot);
  if (!robot) return answer(key, msg::Outcome::refused, robot.error().message);
  const std::optional<msg::RobotState>& state = (*robot)->state;
  const bool stands_there = state && stands_on_its_place(*state) && state->mode != msg::RobotMode::teaching &&
                            context_.snapshots.current().place(state->place) != nullptr;
  if (stands_there) {
    msg::OperatorRequest named = request;
    named.place = state->place;
    return label(key, named, who, now);
  }
  if (const Result<void> room = awaited_labels_.check_room(request.label); !room) {
    return answer(key, outcome_of(room.error()), room.error().message);
  }
  msg::AgentCommand command;
  command.to = (*robot)->id;
  command.kind = msg::AgentCommand::Kind::keep_place;
  command.name = request.label;
  asked_by_[key] = who;
  send_for(key, std::move(command), now.steady);
}

/// Removes a label from the map, and what waits under it.
void OperatorRequests::remove_label(const Key& key, const msg::OperatorRequest& request, const std::string& who,
                                    Now now) {
  const bool is_awaited = awaited_labels_.find(request.label) != nullptr;
  const bool is_set = context_.snapshots.current().labels().contains(request.label);
  msg::OperatorReply reply;
  if (is_set || !is_awaited) reply = editor_.on_request(request, who, now);
  const bool withdraws = is_awaited && reply.outcome == msg::Outcome::done && !request.work.only_say;
  if (withdraws) withdraw_label(request.label, who + " removed the label", who, reply, now);
  answer(key, std::move(reply));
}

/// Renames a label of the map; what waits under the new name would take the name away from it later.
void OperatorRequests::rename_label(const Key& key, const msg::OperatorRequest& request, const std::string& who,
                                    Now now) {
  msg::OperatorReply reply = editor_.on_request(request, who, now);
  const bool is_awaited = awaited_labels_.find(request.new_label) != nullptr;
  const bool withdraws = is_awaited && reply.outcome == msg::Outcome::done && !request.work.only_say;
  if (withdraws) {
    withdraw_label(request.new_label, who + " calls " + request.label + " so from now on", who, reply, now);
  }
  answer(key, std::move(reply));
}

/// Drops what waits under the label, and adds to the reply what became of that.
void OperatorRequests::withdraw_label(const std::string& label, const std::string& why, const std::string& who,
                                      msg::OperatorReply& reply, Now now) {
  const std::string text = waits_no_longer(*awaited_labels_.find(label), why);
  const Result<void> dropped = drop_label(label, why, who, now);
  if (!dropped) reply.outcome = msg::Outcome::failed;
  reply.message += reply.message.empty() ? "" : "; ";
  reply.message += dropped ? text : "label " + label + " still waits: " + dropped.error().message;
}

/// Sets the label of a place that the robot has kept, once that place is on disk; until then the label waits in the
/// store.
void OperatorRequests::label_kept_place(AwaitedLabels::Label label, Now now) {
  const Key key = key_of(label);
  if (!label.place) {
    return answer(key, msg::Outcome::failed, "the robot named no place for label " + label.label + "; give it again");
  }
  if (context_.snapshots.current().place(label.place) != nullptr) {
    const Result<void> done = put_label(label.label, label.place, label.who, now);
    msg::OperatorReply answered;
    answered.outcome = done ? msg::Outcome::done : msg::Outcome::failed;
    answered.message = done ? label.label + " is " + to_string(label.place) : done.error().message;
    answered.place = label.place;
    return answer(key, std::move(answered));
  }
  Result<void> stored = awaited_labels_.check_room(label.label);
  if (stored) {
    if (const auto done = context_.writer.commit({{label}}, now); !done) stored = fail(done.error());
  }
  if (!stored) {
    return answer(key, outcome_of(stored.error()),
                  to_string(label.place) + " is kept, and " + label.label +
                      " cannot wait for it: " + stored.error().message + "; give the label again");
  }
  const std::optional<AwaitedLabels::Label> earlier = awaited_labels_.take(label.label);
  if (earlier && key_of(*earlier) != key) {
    answer(key_of(*earlier), msg::Outcome::failed, waits_no_longer(*earlier, given_by(label.who, label.place)));
  }
  awaited_labels_.add(std::move(label), now.steady);
}

void OperatorRequests::settle_labels(Now now) {
  for (const AwaitedLabels::Awaited& awaited : awaited_labels_.all()) settle_label(awaited, now);
}

/// Sets a label whose place has come, and drops one whose place never comes. When the store does not take it, the
/// label waits on.
void OperatorRequests::settle_label(const AwaitedLabels::Awaited& awaited, Now now) {
  const AwaitedLabels::Label& label = awaited.label;
  const Snapshot& map = context_.snapshots.current();
  std::string never = awaited.never_comes;
  if (map.place(label.place) != nullptr) {
    const Result<void> done = put_label(label.label, label.place, label.who, now);
    if (done || outcome_of(done.error()) != msg::Outcome::refused) return;
    never = done.error().message;
  }
  const auto run = map.experiences().find(label.place.experience);
  if (never.empty() && run != map.experiences().end() && run->second->sealed) {
    never = "nothing more comes of its run, and the map has no such place";
  }
  if (!never.empty()) std::ignore = drop_label(label.label, never, "server", now);
}

/// Takes out what waits under the label, and tells who waits for it why.
Result<void> OperatorRequests::drop_label(const std::string& label, const std::string& why, const std::string& who,
                                          Now now) {
  const AwaitedLabels::Label& awaited = *awaited_labels_.find(label);
  const std::string text = waits_no_longer(awaited, why);
  const auto done = context_.writer.commit(
      {{storage::PutAwaitedLabel{.label = label},
        storage::PutEvent{
            {.at = {}, .kind = "map.label", .robot = awaited.robot, .goal = {}, .cause = text, .who = who}}}},
      now);
  if (!done) return fail(done.error());
  const Key key = key_of(awaited);
  awaited_labels_.take(label);
  answer(key, msg::Outcome::failed, text);
  return {};
}

void OperatorRequests::refused(const Batch& batch, const Error& why, Now now) {
  if (batch.places.empty()) return;
  awaited_labels_.run_ended(batch.places.front().id, "its run is not taken into the map: " + why.message);
  settle_labels(now);
}

}  // namespace weft::server
