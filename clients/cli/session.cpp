#include "clients/cli/session.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <utility>

namespace weft::cli {
namespace {
using namespace std::chrono_literals;

constexpr Duration kRepeatFirst = 500ms;
constexpr Duration kRepeatMost = 2s;
constexpr Duration kListen = 100ms;
constexpr std::size_t kMostUnkept = 1000;

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// Puts the pieces of one answer together, by their number.
template <class T>
class Pieces {
 public:
  /// Adds a piece. Returns true once all are there.
  bool add(std::uint32_t part, std::uint32_t parts, const T& piece) {
    if (parts == 0 || part >= parts) return false;
    if (parts != parts_) {
      pieces_.clear();
      parts_ = parts;
    }
    pieces_.insert_or_assign(part, piece);
    return pieces_.size() == parts_;
  }
  const std::map<std::uint32_t, T>& all() const { return pieces_; }

 private:
  std::uint32_t parts_ = 0;
  std::map<std::uint32_t, T> pieces_;
};

msg::QueryReply join(const std::map<std::uint32_t, msg::QueryReply>& parts) {
  msg::QueryReply all = parts.begin()->second;
  for (auto part = std::next(parts.begin()); part != parts.end(); ++part) {
    append(all.robots, part->second.robots);
    append(all.goals, part->second.goals);
    append(all.routes, part->second.routes);
    append(all.arrivals, part->second.arrivals);
    append(all.events, part->second.events);
    append(all.alarms, part->second.alarms);
    append(all.log, part->second.log);
    append(all.network.places, part->second.network.places);
    append(all.network.edges, part->second.network.edges);
    append(all.network.aparts, part->second.network.aparts);
    append(all.network.rules, part->second.network.rules);
    append(all.network.registrations, part->second.network.registrations);
    append(all.rules, part->second.rules);
    append(all.registrations, part->second.registrations);
    append(all.experiences, part->second.experiences);
    append(all.awaited_labels, part->second.awaited_labels);
    all.network.labels.insert(part->second.network.labels.begin(), part->second.network.labels.end());
  }
  all.parts = 1;
  return all;
}

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
  while (true) {
    while (const std::optional<msg::Message> message = link_.take()) {
      note_unasked(*message);
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
  Pieces<msg::QueryReply> pieces;
  const Result<void> heard = converse(query, at_most, [&](const msg::Message& message) {
    const auto* const reply = std::get_if<msg::QueryReply>(&message);
    if (reply == nullptr || reply->to != self_ || reply->request != query.request) return false;
    return pieces.add(reply->part, reply->parts, *reply);
  });
  if (!heard) {
    return fail(ErrorCode::timed_out, "the server did not answer in " +
                                          std::to_string(std::lround(seconds(at_most))) +
                                          " s: try again, or give a longer --timeout");
  }
  msg::QueryReply whole = join(pieces.all());
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

Result<void> Session::upload(Uploader& uploader, Duration quiet) {
  SteadyTime give_up = world_.now() + quiet;
  std::size_t acknowledged = uploader.acknowledged();
  while (!uploader.done()) {
    for (msg::Message& message : uploader.due(world_.now())) {
      if (auto* const batch = std::get_if<msg::ExperienceBatch>(&message)) batch->header = header();
      if (auto* const chunk = std::get_if<msg::Chunk>(&message)) chunk->header = header();
      // What a full queue does not take is asked for, or repeated, later.
      std::ignore = link_.send(message);
    }
    while (const std::optional<msg::Message> message = link_.take()) {
      const auto* const ack = std::get_if<msg::BatchAck>(&*message);
      if (ack == nullptr || ack->to != self_) continue;
      if (const Result<void> heard = uploader.hear(*ack); !heard) return heard;
    }
    if (uploader.acknowledged() > acknowledged) {
      acknowledged = uploader.acknowledged();
      give_up = world_.now() + quiet;
    }
    if (world_.now() >= give_up) {
      return fail(ErrorCode::timed_out, "the server has acknowledged " + std::to_string(acknowledged) +
                                            " batches and no more for " +
                                            std::to_string(std::lround(seconds(quiet))) +
                                            " s: look with `weft doctor`, then import again under the same name");
    }
    if (!uploader.done()) world_.wait(kListen);
  }
  return {};
}

Result<void> Session::fetch(ContentFetcher& fetcher, Duration quiet) {
  SteadyTime give_up = world_.now() + quiet;
  std::uint64_t received = 0;
  while (!fetcher.done()) {
    if (std::optional<msg::ContentRequest> request = fetcher.due(world_.now())) {
      request->header = header();
      std::ignore = link_.send(*request);  // what a full queue does not take is asked for again
    }
    while (const std::optional<msg::Message> message = link_.take()) {
      const auto* const chunk = std::get_if<msg::Chunk>(&*message);
      if (chunk == nullptr || chunk->to != self_) continue;
      if (const Result<void> heard = fetcher.hear(*chunk, world_.now()); !heard) return heard;
    }
    if (fetcher.received() > received) {
      received = fetcher.received();
      give_up = world_.now() + quiet;
    }
    if (world_.now() >= give_up) {
      return fail(ErrorCode::timed_out, "the server has sent " + std::to_string(fetcher.fetched()) + " of " +
                                            std::to_string(fetcher.wanted()) + " contents and no more for " +
                                            std::to_string(std::lround(seconds(quiet))) +
                                            " s: look with `weft doctor` and `weft map check`, then try again");
    }
    if (!fetcher.done()) world_.wait(kListen);
  }
  return {};
}

Result<EchoReport> Session::measure(Duration at_most) {
  const SteadyTime give_up = world_.now() + at_most;
  EchoProbe probe(random_.next() | 1U, world_.now());
  while (!probe.done(world_.now())) {
    while (const std::optional<msg::Message> message = link_.take()) {
      const auto* const echo = std::get_if<msg::Echo>(&*message);
      if (echo != nullptr && echo->to == self_) probe.hear(*echo, world_.now());
    }
    if (!probe.reaches() && world_.now() >= give_up) {
      return fail(ErrorCode::timed_out, "the server gave no echo back in " +
                                            std::to_string(std::lround(seconds(at_most))) +
                                            " s: is it of an older version, or measured by others at this moment?");
    }
    if (std::optional<msg::Echo> echo = probe.due(world_.now())) {
      echo->header = header();
      std::ignore = link_.send(*echo);  // what a full queue does not take is lost
    }
    world_.wait(std::clamp(probe.next() - world_.now(), Duration{1ms}, kListen));
  }
  return probe.report();
}

}  // namespace weft::cli
