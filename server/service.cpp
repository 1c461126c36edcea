#include "server/service.hpp"

#include <algorithm>
#include <chrono>
#include <deque>
#include <map>
#include <utility>
#include <variant>

#include "core/names.hpp"
#include "core/utf8.hpp"
#include "server/base/context.hpp"
#include "server/contents/content_server.hpp"
#include "server/dispatcher/dispatcher.hpp"
#include "server/dispatcher/standstills.hpp"
#include "server/eta/arrivals.hpp"
#include "server/fleet/fleet.hpp"
#include "server/intake/intake.hpp"
#include "server/queries/answers.hpp"
#include "server/queries/echoes.hpp"
#include "server/queries/figures.hpp"
#include "server/recognise/recognition.hpp"
#include "server/requests/operator_requests.hpp"
#include "server/routes/routes.hpp"
#include "server/site/site_frames.hpp"
#include "server/traffic/traffic.hpp"
#include "server/traffic/unjoined.hpp"
#include "server/windows/window_publisher.hpp"

namespace weft::server {
namespace {
using namespace std::chrono_literals;

constexpr Duration kBetweenHellos = 2s;
constexpr std::size_t kMostClients = 1024;

/// Wires the parts: passes each message to those that hear it, and tells those that have to know when something
/// changed. Decides nothing itself.
class FleetMapServer final : public Service {
 public:
  FleetMapServer(const ServiceConfig& config, storage::MapStore& store, storage::Stored stored, Random random,
                 Now now)
      : config_(config),
        out_(config.self, config.incarnation, stored.epoch),
        writer_(store, std::move(stored.snapshot), out_, counters_),
        maintenance_(store),
        context_{config_, store, out_, counters_, writer_, writer_.snapshots(), maintenance_},
        fleet_(context_, random.fork(1), stored.robots, stored.holds, now.steady),
        intake_(context_, stored.durable_through),
        window_publisher_(context_),
        content_server_(context_),
        recognition_(context_),
        traffic_(context_, std::move(stored.occupancies), now),
        unjoined_(context_, fleet_, traffic_),
        routes_(context_),
        arrivals_(stored.passes),
        dispatcher_(context_, fleet_, traffic_, routes_, arrivals_, random.fork(2), std::move(stored.goals),
                    std::move(stored.routes), now.steady),
        standstills_(context_, fleet_, dispatcher_),
        site_frames_(context_),
        requests_(context_, fleet_, traffic_, dispatcher_, site_frames_, stored.awaited_labels, now.steady),
        answers_(context_, fleet_, traffic_, unjoined_, standstills_, dispatcher_, intake_, site_frames_,
                 requests_.awaited_labels(), window_publisher_),
        echoes_(context_, now.steady),
        next_hello_(now.steady) {
    for (const std::string& damaged : stored.quarantined) {
      writer_.note(
          {.at = {}, .kind = "store.quarantined", .robot = {}, .goal = {}, .cause = damaged, .who = "server"}, now);
    }
    writer_.note({.at = {},
                  .kind = "server.started",
                  .robot = {},
                  .goal = {},
                  .cause = "epoch " + std::to_string(stored.epoch.value) + ", revision " +
                           std::to_string(context_.snapshots.current().revision().value),
                  .who = config.name},
                 now);
  }

  std::vector<msg::Message> handle(const msg::Message& message, Now now) override {
    const auto take_in = [&](const auto& one) {
      if constexpr (requires { one.header; }) fleet_.count(one.header, now.steady);
      receive(one, now);
    };
    std::visit(take_in, message);
    settle(now);
    return out_.take();
  }

  std::vector<msg::Message> tick(Now now) override {
    if (next_hello_ <= now.steady) say_hello(now.steady);
    writer_.tick(now);
    for (const RobotId& robot : fleet_.tick(now)) requests_.on_silence(robot, now.steady);
    after(intake_.tick(now), now);
    window_publisher_.tick(now.steady);
    content_server_.tick(now);
    recognition_.tick(now);
    requests_.tick(now);
    answers_.tick(now);
    traffic_.tick(now);
    routes_.tick(now);
    site_frames_.tick(now);
    settle(now);
    return out_.take();
  }

  std::optional<SteadyTime> next_tick() const override {
    SteadyTime next = next_hello_;
    for (const std::optional<SteadyTime>& due :
         {writer_.next(), fleet_.next(), intake_.next(), window_publisher_.next(), content_server_.next(),
          recognition_.next(), dispatcher_.next(), standstills_.next(), requests_.next(), answers_.next(),
          traffic_.next(), routes_.next(), site_frames_.next()}) {
      if (due) next = std::min(next, *due);
    }
    return next;
  }

  void was_away(Duration away, Now now) override {
    fleet_.excuse(away, now.steady);
    dispatcher_.excuse(away, now.steady);
    ++counters_["server: away from its inbox for more than a second"];
  }

  void count(const std::string& what, std::uint64_t times) override { counters_[what] += times; }
  void sent(const msg::Message& message, std::size_t bytes) override {
    if (const auto* const patch = std::get_if<msg::WindowPatch>(&message)) fleet_.sent_window(patch->to, bytes);
    if (const auto* const chunk = std::get_if<msg::Chunk>(&message)) fleet_.sent_content(chunk->to, bytes);
  }
  const Snapshot& snapshot() const override { return context_.snapshots.current(); }
  Figures figures(Now now) const override {
    return figures_of(
        {context_, fleet_, intake_, window_publisher_, content_server_, recognition_, dispatcher_, standstills_},
        now);
  }
  std::vector<Goal> goals() const override {
    std::vector<Goal> goals;
    for (const auto& [id, goal] : dispatcher_.book().goals()) goals.push_back(goal);
    return goals;
  }
  std::optional<Error> broken() const override { return writer_.broken(); }
  std::optional<Error> store_refuses() const override { return writer_.stopped(); }
  GoalId goal_of(const RobotId& robot) const override {
    const Goal* const goal = dispatcher_.goal_of(robot);
    return goal != nullptr ? goal->id : GoalId{};
  }

 private:
  using Verdict = Incarnations::Verdict;

  void settle(Now now) {
    const Revision revision = context_.snapshots.current().revision();
    if (revision != told_revision_) {
      told_revision_ = revision;
      window_publisher_.network_changed();
      window_publisher_.tick(now.steady);
      dispatcher_.network_changed();
    }
    unjoined_.tick(now);
    dispatcher_.tick(now);
    standstills_.tick(now);
  }

  void say_hello(SteadyTime now) {
    next_hello_ = now + kBetweenHellos;
    msg::Hello hello;
    hello.peer = config_.self;
    hello.incarnation = config_.incarnation;
    hello.role = msg::Role::server;
    hello.epoch = out_.epoch();
    hello.name = config_.name;
    hello.software = config_.software;
    hello.vendor = config_.vendor;
    hello.answers = {answers_to_.begin(), answers_to_.end()};
    out_.send(std::move(hello));
  }

  /// Notes a challenge: the next hello shows the asker that this server lives and hears it.
  void note_challenge(std::uint64_t challenge) {
    if (challenge == 0 || std::find(answers_to_.begin(), answers_to_.end(), challenge) != answers_to_.end()) return;
    if (answers_to_.size() == msg::kAnswers) answers_to_.pop_front();
    answers_to_.push_back(challenge);
  }

  void after(const std::vector<Batch>& joined, Now now) {
    for (const Batch& batch : joined) {
      content_server_.joined(batch);
      traffic_.joined(batch);
    }
    if (!joined.empty()) requests_.joined(now);
    for (const auto& [batch, why] : intake_.take_refused()) requests_.refused(batch, why, now);
  }

  /// Returns true when the sender of the message may speak.
  bool admit(const msg::Header& from, bool says_it_is_a_robot, Now now) {
    if (fleet_.is_refused(from.sender)) {
      ++counters_["message from a peer without a common protocol version"];
      return false;
    }
    if (from.epoch > out_.epoch()) ++counters_["message that knows a newer server"];
    const Robot* const before = fleet_.find(from.sender);
    const bool were_twins = before != nullptr && before->incarnations.twins();
    const std::optional<Verdict> verdict = fleet_.hear(from, says_it_is_a_robot, now);
    if (!verdict) return !says_it_is_a_robot;
    if (*verdict == Verdict::fresh) dispatcher_.on_restart(from.sender);
    if (*verdict == Verdict::twin && !were_twins) requests_.on_twins(from.sender, now);
    if (*verdict == Verdict::late) ++counters_["message of a robot's earlier incarnation"];
    if (*verdict == Verdict::twin) ++counters_["message of a robot that runs twice"];
    return *verdict == Verdict::first || *verdict == Verdict::fresh || *verdict == Verdict::current;
  }

  /// Returns the asker's name; a request can come before its client's hello.
  std::string who_asks(const msg::OperatorRequest& request) const {
    if (!request.who.empty()) return as_utf8(request.who, kLongestName);
    const auto known = clients_.find(request.header.sender);
    return known == clients_.end() ? to_string(request.header.sender) : as_utf8(known->second, kLongestName);
  }

  /// Returns the client that hands in what no robot of the fleet has seen; empty: a robot does.
  std::string importer(const msg::Header& from) const {
    const auto known = clients_.find(from.sender);
    return known == clients_.end() ? std::string() : as_utf8(known->second, kLongestName);
  }

  void receive(const msg::Hello& hello, Now now) {
    if (hello.role == msg::Role::server) {
      ++counters_["hello of another server"];
      return;
    }
    note_challenge(hello.challenge);
    // One that is too new or too old hears that too: hellos are understood by all.
    if (!fleet_.on_hello(hello, now)) return say_hello(now.steady);
    if (hello.role == msg::Role::client) {
      if (clients_.size() >= kMostClients && !clients_.contains(hello.peer)) clients_.erase(clients_.begin());
      clients_[hello.peer] = hello.name;
    }
    const bool is_agent = hello.role == msg::Role::agent;
    if (is_agent) std::ignore = admit({hello.peer, hello.incarnation, {}, 0, {}}, true, now);
    say_hello(now.steady);
  }
  void receive(const msg::RobotDescription& description, Now now) {
    if (!admit(description.header, true, now)) return;
    fleet_.on_description(description, now);
    traffic_.set_footprint(description.header.sender, description.footprint_radius_m);
    routes_.want({description.methods.begin(), description.methods.end()});
  }
  void receive(const msg::RobotState& state, Now now) {
    if (!admit(state.header, true, now)) return;
    const Robot* const robot = fleet_.on_state(state, now);
    if (robot == nullptr) return;
    dispatcher_.on_state(*robot, now);
    requests_.on_state(*robot, now);
  }
  void receive(const msg::RobotPower& power, Now now) {
    if (admit(power.header, true, now)) fleet_.on_power(power);
  }
  void receive(const msg::ExperienceBatch& batch, Now now) {
    // What was seen stays true whichever incarnation hands it in. A client that imports a file is no robot of the
    // fleet, and its batch can come before its hello: whoever is a robot says so otherwise.
    const bool is_robot = fleet_.find(batch.header.sender) != nullptr;
    std::ignore = admit(batch.header, is_robot, now);
    if (!fleet_.is_refused(batch.header.sender)) after(intake_.on_batch(batch, importer(batch.header), now), now);
  }
  void receive(const msg::Chunk& chunk, Now now) {
    if (!fleet_.is_refused(chunk.header.sender)) after(intake_.on_chunk(chunk, now), now);
  }
  void receive(const msg::ContentRequest& request, Now now) {
    if (!admit(request.header, false, now)) return;
    content_server_.on_request(request, now.steady);
    content_server_.tick(now);
  }
  void receive(const msg::WindowRequest& request, Now now) {
    if (admit(request.header, false, now)) window_publisher_.on_request(request, now.steady);
  }
  void receive(const msg::Recognise& question, Now now) {
    if (admit(question.header, true, now)) recognition_.on_question(question, now.steady);
  }
  void receive(const msg::RouteProgress& progress, Now now) {
    if (admit(progress.header, true, now)) dispatcher_.on_progress(progress, now);
  }
  void receive(const msg::AgentReply& reply, Now now) {
    if (admit(reply.header, true, now)) requests_.on_reply(reply, now);
  }
  void receive(const msg::Echo& echo, Now now) {
    if (admit(echo.header, false, now)) echoes_.on_echo(echo, now.steady);
  }
  void receive(const msg::ClockReply& reply, Now now) {
    if (admit(reply.header, false, now)) fleet_.on_clock_reply(reply, now);
  }
  void receive(const msg::OperatorRequest& request, Now now) {
    if (admit(request.header, false, now)) requests_.on_request(request, who_asks(request), now);
  }
  void receive(const msg::Query& query, Now now) {
    if (admit(query.header, false, now)) answers_.on_query(query, now);
  }
  /// Counts everything else, which only servers say.
  template <class M>
  void receive(const M& /*message*/, Now /*now*/) {
    ++counters_["message that only a server sends"];
  }

  const ServiceConfig config_;
  Counters counters_;
  Outbox out_;
  MapWriter writer_;
  Maintenance maintenance_;
  Context context_;
  Fleet fleet_;
  Intake intake_;
  WindowPublisher window_publisher_;
  ContentServer content_server_;
  Recognition recognition_;
  Traffic traffic_;
  UnjoinedWatch unjoined_;
  Routes routes_;
  Arrivals arrivals_;
  Dispatcher dispatcher_;
  Standstills standstills_;
  SiteFrames site_frames_;
  OperatorRequests requests_;
  Answers answers_;
  Echoes echoes_;
  std::map<PeerId, std::string> clients_;
  std::deque<std::uint64_t> answers_to_;  ///< challenges, the latest last
  Revision told_revision_;
  SteadyTime next_hello_;
};

}  // namespace

Result<std::unique_ptr<Service>> start(const ServiceConfig& config, storage::MapStore& store, Random random,
                                       Now now) {
  const bool is_bound = config.robot_silent_after_s > 0 && config.robot_silent_after_s <= 3600;
  if (!is_bound) {
    return fail(ErrorCode::invalid, "robot_silent_after_s is " + std::to_string(config.robot_silent_after_s) +
                                        "; it must be over 0 and at most 3600");
  }
  if (const Result<void> good = check(config.charge); !good) return fail(good.error());
  Result<storage::Stored> stored = store.open();
  if (!stored) return fail(stored.error());
  return std::make_unique<FleetMapServer>(config, store, *std::move(stored), random, now);
}

}  // namespace weft::server
