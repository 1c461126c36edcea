#include "tests/simulation/fleet.hpp"

#include <algorithm>
#include <stdexcept>

#include "agents/navigation/navigator_of.hpp"
#include "tests/simulation/stored_map.hpp"
#include "tests/support/marks.hpp"
#include "tests/support/refining_marks.hpp"

namespace weft::simulation {
namespace {

constexpr double kFootprint_m = 0.4;
constexpr Duration kLookEvery = std::chrono::seconds(60);
constexpr Duration kLookAtTrafficEvery = std::chrono::seconds(4);

template <class T>
T need(Result<T> result, const char* what) {
  if (!result) throw std::runtime_error(std::string(what) + ": " + result.error().message);
  return std::move(*result);
}

std::optional<agents::Signature> sign_marks(ByteView content) {
  const agents::MarksMethod method;
  const auto decoded = method.decode(content);
  return decoded ? method.sign(*decoded) : std::nullopt;
}

/// Returns the navigator of a robot that refines what it was taught, or of one that does not: every second one does.
std::unique_ptr<agents::Navigator> make_navigator(bool refines) {
  if (refines) return agents::make_navigator(agents::RefiningMarks(), agents::NavigationConfig());
  return agents::make_navigator(agents::MarksMethod(), agents::NavigationConfig());
}

/// Rejects what may not happen to a message. One that finds the link closed is lost, like one on its way.
void check_not_sent(const Error& error) {
  if (error.code != ErrorCode::unavailable) throw std::runtime_error(error.message);
}

Site site_of(const FleetConfig& config, Random random) {
  if (config.map == MapFrom::stored) return make_large_site(config.robots, random);
  return make_site(config.site, random);
}

}  // namespace

Fleet::Fleet(const FleetConfig& config)
    : random_(config.seed),
      now_(std::chrono::hours(1)),
      site_(std::make_shared<const Site>(site_of(config, random_.fork(1)))),
      net_(random_.fork(2)),
      ledger_(kFootprint_m, config.told),
      checks_waits_(config.checks_waits) {
  net_.set_now(now_);
  server_.id = draw_id();
  server_.disk = std::make_shared<storage::MemoryDisk>();
  server_.wall_offset = from_seconds(random_.uniform(-2.0, 2.0));
  server_.wire.address = next_address();
  const std::size_t robots = config.robots;
  if (config.map == MapFrom::stored) store_map(robots);
  start_server();
  client_.id = draw_id();
  client_.incarnation = random_.next();
  client_.wire.address = next_address();
  open(client_.wire, msg::Role::client, client_.id);
  robots_.resize(robots);
  for (std::size_t i = 0; i < robots; ++i) {
    RobotProcess& robot = robots_[i];
    robot.id = draw_id();
    robot.name = "r" + std::to_string(i);
    robot.wire.address = next_address();
    robot.disk = std::make_shared<storage::SpoolDisk>();
    const Pose2 start = site_->pose(site_->course().start_m(i, robots), {});
    robot.body = std::make_unique<MarksBody>(site_, start, random_.fork(100 + i));
    ledger_.robots[robot.id].body = robot.body.get();
    ledger_.robots[robot.id].name = robot.name;
    ledger_.robots[robot.id].refines = refines(i);
    start_robot(i);
  }
}

void Fleet::store_map(std::size_t robots) {
  const StoredMap map(*site_, robots, draw_id(), random_.fork(5));
  if (!map.write(server_.disk)) throw std::runtime_error("the stored map: the disk refuses it");
  for (const auto& [place, pose] : map.places()) ledger_.stored(place, pose);
}

PeerId Fleet::draw_id() {
  PeerId id;
  for (std::uint8_t& byte : id.bytes) byte = static_cast<std::uint8_t>(random_.next());
  return id;
}

void Fleet::start_server() {
  server_.steady_offset = from_seconds(random_.uniform(0.0, 1000.0));
  server_.store = storage::make_memory_store(server_.disk);
  auto started = server::start({.self = server_.id,
                                .incarnation = random_.next(),
                                .name = "server",
                                .software = "simulated",
                                .vendor = "inprocess",
                                .signers = {{{"marks", agents::MarksMethod::content_format}, sign_marks}}},
                               *server_.store, random_.fork(3), server_now());
  if (!started) {  // a full disk cannot take the next epoch: it is tried again
    server_.store.reset();
    return;
  }
  server_.service = std::move(*started);
  open(server_.wire, msg::Role::server, server_.id);
  ledger_.server_up(now_);
  note_wake();
}

void Fleet::crash_server() {
  close(server_.wire, server_.id);
  server_.hung_since.reset();
  server_.service.reset();
  server_.store.reset();
}

void Fleet::start_robot(std::size_t index) {
  RobotProcess& robot = robots_[index];
  robot.steady_offset = from_seconds(random_.uniform(0.0, 1000.0));
  robot.wall_offset = from_seconds(random_.uniform(-2.0, 2.0));
  robot.spool = storage::make_memory_spool(robot.disk);
  agents::AgentConfig config;
  config.self = robot.id;
  config.incarnation = random_.next();
  config.name = robot.name;
  config.software = "simulated";
  config.vendor = "inprocess";
  config.body = robot.body->kind();
  config.can_be_taught_along = true;
  config.footprint_radius_m = kFootprint_m;
  auto navigator = make_navigator(refines(index));
  auto started = agents::start(config, std::move(navigator), *robot.spool, random_.fork(4), clock(robot));
  look_at_spool(robot);
  if (!started && robot.disk->faults.full) {  // it seals what it left open first
    robot.spool.reset();
    return;
  }
  robot.agent = need(std::move(started), "agent");
  open(robot.wire, msg::Role::agent, robot.id);
  robot.command = {};
  robot.due = now_;
  robot.next.reset();
  ledger_.agent_started(robot.id, *robot.agent, *robot.disk);
  note_wake(robot);
}

void Fleet::crash_robot(std::size_t index) {
  RobotProcess& robot = robots_[index];
  close(robot.wire, robot.id);
  robot.hung_since.reset();
  ledger_.agent_ended(robot.id);
  robot.agent.reset();
  robot.spool.reset();
  robot.body->stop_hand();
  robot.command = {};  // a base stops when nobody speaks to it
}

void Fleet::note_wake() {
  const std::optional<SteadyTime> due = server_.service->next_tick();
  server_.wakes = due ? *due - server_.steady_offset : SteadyTime::max();
}

void Fleet::note_wake(RobotProcess& robot) {
  const std::optional<SteadyTime> due = robot.agent->next_tick();
  robot.wakes = due ? *due - robot.steady_offset : SteadyTime::max();
}

SteadyTime Fleet::next_event() const {
  SteadyTime next = std::min({next_look_, next_look_at_traffic_, next_look_at_links_});
  if (const auto due = net_.next_delivery()) next = std::min(next, *due);
  if (server_.service && !server_.hung_since) next = std::min(next, server_.wakes);
  for (const RobotProcess& robot : robots_) {
    if (robot.hung_since) continue;
    next = std::min(next, robot.due);
    if (robot.agent) next = std::min(next, robot.wakes);
  }
  return std::max(next, now_);
}

void Fleet::run_until(SteadyTime until) {
  for (SteadyTime next = next_event(); next <= until; next = next_event()) play(next);
  now_ = until;
  net_.deliver_until(now_);
}

void Fleet::play(SteadyTime at) {
  now_ = at;
  ledger_.set_now(now_);
  net_.deliver_until(now_);
  if (now_ >= next_look_at_links_) look_at_links();
  if (server_.service && !server_.hung_since) serve();
  for (RobotProcess& robot : robots_) {
    if (robot.hung_since) continue;
    if (robot.agent) serve(robot);
    if (robot.due <= now_) sample(robot);
  }
  hear_client();
  look();
}

void Fleet::look() {
  if (now_ >= next_look_at_traffic_) {
    next_look_at_traffic_ = now_ + kLookAtTrafficEvery;
    const bool is_served = server_.service && !server_.hung_since;
    ledger_.look_at_goals(*server_.disk, is_served);
    if (is_served) {
      const std::vector<msg::RobotRow> rows = robot_rows();
      ledger_.look_at_silence(rows);
      if (checks_waits_) ledger_.look_at_waits(rows, *server_.disk);
    }
  }
  if (now_ >= next_look_) {
    next_look_ = now_ + kLookEvery;
    if (server_.service) ledger_.look(*server_.service, *server_.disk);
  }
}

/// Asks as `weft goal why` does, and keeps the answer from the network.
std::vector<msg::RobotRow> Fleet::robot_rows() {
  msg::Query query;
  query.header.sender = client_.id;
  query.header.incarnation = client_.incarnation;
  query.header.sequence = ++client_.sequence;
  query.kind = msg::Query::Kind::robots;
  query.request = client_.sequence;
  std::vector<msg::RobotRow> rows;
  std::vector<msg::Message> others;
  for (msg::Message& message : server_.service->handle(query, server_now())) {
    auto* const answer = std::get_if<msg::QueryReply>(&message);
    if (answer == nullptr || answer->request != query.request) {
      others.push_back(std::move(message));
    } else {
      rows.insert(rows.end(), answer->robots.begin(), answer->robots.end());
    }
  }
  send_all(others);
  note_wake();
  return rows;
}

std::uint64_t Fleet::ways_made() const {
  const auto& events = server_.disk->events;
  return static_cast<std::uint64_t>(std::ranges::count_if(events, [](const msg::Event& event) {
    return event.kind == "traffic.makes_way" || event.kind == "traffic.standstill_over";
  }));
}

void Fleet::serve() {
  bool has_heard = false;
  while (const auto message = server_.wire.link->take()) {
    has_heard = true;
    ledger_.server_heard(*message);
    send_all(server_.service->handle(*message, server_now()));
  }
  if (has_heard) note_wake();
  if (server_.wakes > now_) return;
  send_all(server_.service->tick(server_now()));
  note_wake();
}

void Fleet::send_all(const std::vector<msg::Message>& messages) {
  for (const msg::Message& message : messages) {
    record(message);
    ledger_.server_sent(message, *server_.service);
    const auto sent = server_.wire.link->send(message);
    if (sent) {
      server_.service->sent(message, *sent);
    } else {
      check_not_sent(sent.error());
    }
  }
}

void Fleet::serve(RobotProcess& robot) {
  bool has_heard = false;
  while (const auto message = robot.wire.link->take()) {
    has_heard = true;
    ledger_.agent_heard(robot.id, *message, *server_.disk);
    carry_out(robot, robot.agent->handle(*message, clock(robot), wall(robot.wall_offset)));
    if (std::holds_alternative<msg::RouteOrder>(*message)) ledger_.agent_took(robot.id);
  }
  if (has_heard) note_wake(robot);
  if (robot.wakes > now_) return;
  carry_out(robot, robot.agent->tick(clock(robot)));
  note_wake(robot);
}

void Fleet::sample(RobotProcess& robot) {
  if (robot.next && robot.agent) {
    agents::AgentOutput output = robot.agent->step(*robot.next, clock(robot));
    robot.command = output.command;
    ledger_.agent_stepped(robot.id, *robot.next, output);
    carry_out(robot, std::move(output));
    note_wake(robot);
  }
  robot.next = need(robot.body->step(robot.command), "body");
  ledger_.body_moved(robot.id);
  robot.due = now_ + robot.next->motion.elapsed;
}

void Fleet::carry_out(RobotProcess& robot, agents::AgentOutput output) {
  look_at_spool(robot);  // what was refused in this step is why what follows is sent
  for (const msg::Message& message : output.send) {
    record(message);
    ledger_.agent_sent(robot.id, message);
    if (const auto sent = robot.wire.link->send(message); !sent) check_not_sent(sent.error());
  }
  if (output.hand_stop) robot.body->stop_hand();
  if (output.hand_start) {
    const Result<void> answer = robot.body->drive_by_hand(*output.hand_start);
    carry_out(robot, robot.agent->hand_answered(answer, clock(robot)));
  }
}

bool Fleet::take_by_hand(std::size_t robot, const std::vector<agents::SitePoint>& along) {
  return robots_[robot].body->drive_by_hand(along).has_value();
}

template <class Asked>
void Fleet::send_as_client(Asked asked) {
  asked.header.sender = client_.id;
  asked.header.incarnation = client_.incarnation;
  asked.header.sequence = ++client_.sequence;
  record(asked);
  if (const auto sent = client_.wire.link->send(asked); !sent) check_not_sent(sent.error());
}

void Fleet::send(msg::OperatorRequest request) {
  send_as_client(std::move(request));
}

void Fleet::send(msg::Query query) {
  send_as_client(std::move(query));
}

void Fleet::hear_client() {
  while (const auto message = client_.wire.link->take()) {
    ledger_.client_heard(*message);
    if (const auto* reply = std::get_if<msg::OperatorReply>(&*message)) client_.replies.push_back(*reply);
    if (const auto* answer = std::get_if<msg::QueryReply>(&*message)) client_.answers.push_back(*answer);
  }
}

std::vector<msg::OperatorReply> Fleet::take_replies() {
  return std::exchange(client_.replies, {});
}

std::vector<msg::QueryReply> Fleet::take_answers() {
  return std::exchange(client_.answers, {});
}

std::vector<std::string> Fleet::diary() const {
  std::vector<std::string> lines;
  const auto name_of = [this](const RobotId& id) {
    const auto found = ledger_.robots.find(id);
    return found == ledger_.robots.end() ? std::string("-") : found->second.name;
  };
  for (const msg::Event& event : server_.disk->events) {
    lines.push_back(std::to_string(seconds(event.at.time_since_epoch())) + " " + event.kind + " " +
                    name_of(event.robot) + " " + (event.goal ? to_string(event.goal).substr(0, 6) : "-") + " " +
                    event.who + ": " + event.cause);
  }
  for (const auto& [id, goal] : server_.disk->goals) {
    lines.push_back("goal " + to_string(id).substr(0, 6) + " to " + goal.label + " " + to_string(goal.state) + ": " +
                    goal.history.back().cause);
  }
  if (server_.service) {
    for (const auto& [id, experience] : server_.service->snapshot().experiences()) {
      std::size_t both = 0;
      for (const Edge& stitch : experience->stitches) both += stitch.drivable == Drivable::both ? 1 : 0;
      lines.push_back("experience " + to_string(id) + " of " + name_of(experience->robot) + ": " +
                      std::to_string(experience->places.size()) + " places, " +
                      std::to_string(experience->stitches.size()) + " stitches, " + std::to_string(both) +
                      " drivable");
    }
  }
  for (const auto& [id, robot] : ledger_.robots) {
    if (robot.agent != nullptr) {
      std::string counts = "counters " + robot.name + ":";
      for (const auto& [name, count] : robot.agent->counters()) counts += " " + name + "=" + std::to_string(count);
      lines.push_back(counts);
    }
    const Pose2& truth = robot.body->site_from_robot();
    lines.push_back("robot " + robot.name + " " + to_string(robot.state.mode) + " at " +
                    to_string(robot.state.place) + ", truly (" + std::to_string(truth.x) + ", " +
                    std::to_string(truth.y) + ") m, " + std::to_string(truth.heading) +
                    " rad: " + robot.state.reason);
  }
  return lines;
}

Removal Fleet::some_places(Random& random) const {
  std::vector<const Experience*> ended;
  if (!server_.service) return {};
  for (const auto& [id, experience] : server_.service->snapshot().experiences()) {
    if (experience->sealed && experience->places.size() > 10) ended.push_back(experience.get());
  }
  if (ended.empty()) return {};
  const Experience& experience = *ended[random.below(ended.size())];
  const auto first = static_cast<std::uint32_t>(random.below(experience.extent));
  return {
      {{experience.id, first, std::min(first + static_cast<std::uint32_t>(random.below(12)), experience.extent - 1)}},
      {}};
}

void Fleet::look_when_quiet() {
  if (server_.service) ledger_.look_when_quiet(*server_.service, *server_.disk);
}

/// Mixes time, kind and some fields of the message into the run's hash: FNV-1a (Fowler, Noll & Vo).
void Fleet::record(const msg::Message& message) {
  ++messages_;
  const auto mix = [this](std::uint64_t value) {
    for (int i = 0; i < 8; ++i) trace_ = (trace_ ^ ((value >> (8 * i)) & 0xffU)) * 1099511628211ULL;
  };
  mix(static_cast<std::uint64_t>(now_.time_since_epoch().count()));
  mix(message.index());
  if (const auto* state = std::get_if<msg::RobotState>(&message)) {
    mix(state->frame);
    mix(static_cast<std::uint64_t>(state->mode));
    mix(state->place.index);
  }
}

std::string Fleet::trace() const {
  const ExperienceId as_text{trace_};
  return to_string(as_text);
}

}  // namespace weft::simulation
