#include "clients/cli/session.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "clients/cli/answer_parts.hpp"

namespace weft::cli {
namespace {
using namespace std::chrono_literals;

constexpr Duration kRepeatFirst = 500ms;
constexpr Duration kRepeatMost = 2s;
constexpr Duration kListen = 100ms;
/// Bounds how long nobody answers before the link is opened anew, and doubles each time: what was known of the server
/// may be of where it was, though it is heard.
constexpr Duration kUnanswered = 10s;

/// Returns whether the server says that to this client, which it then has heard.
bool is_for(const msg::Message& message, const PeerId& self) {
  const auto* const reply = std::get_if<msg::OperatorReply>(&message);
  const auto* const answer = std::get_if<msg::QueryReply>(&message);
  return (reply != nullptr && reply->to == self) || (answer != nullptr && answer->to == self);
}
constexpr std::size_t kMostUnkept = 1000;

}  // namespace

Session::Session(bus::Link& link, World world, Random random, PeerId self, std::string name)
    : link_(link),
      world_(std::move(world)),
      random_(random),
      self_(self),
      name_(std::move(name)),
      incarnation_(random_.next() | 1U),
      challenge_(random_.next() | 1U) {}

msg::Header Session::header() {
  return {.sender = self_,
          .incarnation = incarnation_,
          .epoch = server_.has_value() ? server_->epoch : Epoch{},
          .sequence = ++sequence_,
          .signature = {}};
}

msg::Hello Session::hello() const {
  msg::Hello own;
  own.peer = self_;
  own.incarnation = incarnation_;
  own.role = msg::Role::client;
  own.name = name_;
  own.software = WEFT_VERSION;
  own.vendor = link_.bus().vendor();
  own.challenge = challenge_;
  return own;
}

void Session::note(const msg::Hello& hello) {
  if (hello.role != msg::Role::server) return;
  is_server_heard_ = true;
  // Whoever does not answer may be an old message of a server that is gone.
  if (std::ranges::find(hello.answers, challenge_) == hello.answers.end()) return;
  if (!server_.has_value() || hello.epoch >= server_->epoch) server_ = hello;
}

void Session::note(const msg::EventNote& event) {
  if (!event.is_kept && unkept_.size() < kMostUnkept) unkept_.push_back(event.event);
}

void Session::note_unasked(const msg::Message& message) {
  if (const auto* const hello = std::get_if<msg::Hello>(&message)) note(*hello);
  if (const auto* const event = std::get_if<msg::EventNote>(&message)) note(*event);
}

void Session::listen(SteadyTime until) {
  while (const std::optional<msg::Message> message = link_.take()) note_unasked(*message);
  world_.wait(std::max(Duration{}, std::min(kListen, until - world_.now())));
}

GoalId Session::new_goal() {
  GoalId id;
  for (std::uint8_t& byte : id.bytes) byte = static_cast<std::uint8_t>(random_.next() >> 8U);
  return id;
}

Result<void> Session::converse(const msg::Message& question, Duration at_most,
                               const std::function<bool(const msg::Message&)>& heard) {
  const SteadyTime end = world_.now() + at_most;
  SteadyTime send_at = world_.now();
  Duration wait = kRepeatFirst;
  Duration patience = kUnanswered;
  SteadyTime anew_at = world_.now() + patience;
  while (true) {
    while (const std::optional<msg::Message> message = link_.take()) {
      note_unasked(*message);
      if (is_for(*message, self_)) anew_at = world_.now() + patience;
      if (heard(*message)) return {};
    }
    const SteadyTime now = world_.now();
    if (now >= end || world_.interrupted()) return fail(ErrorCode::timed_out, "no answer in time");
    if (now >= send_at) {
      // A full queue is one more reason to send again later.
      std::ignore = link_.send(question);
      send_at = now + wait;
      wait = std::min(wait * 2, kRepeatMost);
    }
    if (now >= anew_at) {
      link_.bus().open_anew();
      patience *= 2;
      anew_at = now + patience;
    }
    world_.wait(std::min({kListen, send_at - now, end - now}));
  }
}

Result<msg::Hello> Session::connect(Duration at_most) {
  const Result<void> heard = converse(hello(), at_most, [this](const msg::Message&) { return server_.has_value(); });
  if (!heard && is_server_heard_) {
    return fail(ErrorCode::unavailable, "a server is heard, but has not answered within " +
                                            std::to_string(std::lround(seconds(at_most))) +
                                            " s: can its machine reach this one (--listen, firewall)?");
  }
  if (!heard) {
    return fail(ErrorCode::unavailable,
                "no server was heard within " + std::to_string(std::lround(seconds(at_most))) +
                    " s: is weft-server running, and do --server, --domain and WEFT_SERVER name it?");
  }
  if (server_->protocol_min > msg::kProtocolVersion || server_->protocol_max < msg::kProtocolVersion) {
    return fail(ErrorCode::refused, "the server speaks protocol " + std::to_string(server_->protocol_min) + " to " +
                                        std::to_string(server_->protocol_max) + ", this program " +
                                        std::to_string(msg::kProtocolVersion) + ": update the older one");
  }
  return *server_;
}

Result<msg::OperatorReply> Session::ask(msg::OperatorRequest request, Duration at_most, const Progress& under_way) {
  request.header = header();
  request.who = name_;
  request.request = random_.next() | 1U;
  std::optional<msg::OperatorReply> answer;
  const auto hear = [&](const msg::Message& message) {
    const auto* const reply = std::get_if<msg::OperatorReply>(&message);
    if (reply == nullptr || reply->to != self_ || reply->request != request.request) return false;
    answer = *reply;
    return true;
  };
  Result<void> heard = converse(request, at_most, hear);
  while (heard && answer->outcome == msg::Outcome::under_way) {
    if (under_way) under_way(*answer);
    heard = converse(request, at_most, hear);
  }
  if (!heard) {
    return fail(ErrorCode::timed_out, "the server did not answer in " +
                                          std::to_string(std::lround(seconds(at_most))) +
                                          " s; what was asked may still happen: look with `weft robots` and "
                                          "`weft goal list`, or give a longer --timeout");
  }
  return *answer;
}

Result<msg::QueryReply> Session::query(msg::Query query, Duration at_most) {
  query.header = header();
  query.request = random_.next() | 1U;
  AnswerParts parts;
  const Result<void> heard = converse(query, at_most, [&](const msg::Message& message) {
    const auto* const reply = std::get_if<msg::QueryReply>(&message);
    if (reply == nullptr || reply->to != self_ || reply->request != query.request) return false;
    return parts.add(*reply);
  });
  if (!heard) {
    return fail(ErrorCode::timed_out, "the server did not answer in " +
                                          std::to_string(std::lround(seconds(at_most))) +
                                          " s: try again, or give a longer --timeout");
  }
  msg::QueryReply whole = parts.joined();
  if (whole.outcome == msg::Outcome::refused) return fail(ErrorCode::refused, std::move(whole.message));
  if (whole.outcome == msg::Outcome::failed) return fail(ErrorCode::internal, std::move(whole.message));
  return whole;
}

Result<Window> Session::network(Wanted wanted, Duration at_most, const PageProgress& under_way) {
  msg::Query query;
  query.kind = msg::Query::Kind::network;
  query.at = wanted.at;
  query.apart_from = wanted.apart_from;
  PagedNetwork network;
  while (!network.is_whole()) {
    Result<msg::QueryReply> reply = this->query(query, at_most);
    if (!reply) return fail(reply.error());
    if (const Result<void> added = network.add(std::move(reply->network)); !added) return fail(added.error());
    query.at = network.revision();
    query.after = network.after();
    if (under_way) under_way(network);
  }
  return network.take();
}

}  // namespace weft::cli
