#include "tests/server/arranged_site.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <iterator>
#include <utility>

#include "core/network/codec.hpp"
#include "core/random.hpp"
#include "idl/bus/link.hpp"

namespace weft::server::test {

RobotId robot_id(std::uint8_t number) {
  RobotId id;
  id.bytes[0] = number;
  return id;
}

GoalId goal_id(std::uint8_t number) {
  GoalId id;
  id.bytes[0] = number;
  return id;
}

namespace {

Metric2 metric(double x, double y) {
  Metric2 relation;
  relation.a_from_b = {x, y, 0.0};
  relation.covariance = Eigen::Vector3d(1e-6, 1e-6, 1e-6).asDiagonal();
  return relation;
}

/// Fails the test when those who hear the message would refuse it.
void expect_readable(const msg::Message& message) {
  const Result<bus::Encoded> encoded = bus::encode(message, msg::Role::server);
  ASSERT_TRUE(encoded.has_value()) << encoded.error().message;
  const Result<msg::Message> read = bus::decode(encoded->topic, encoded->cdr);
  EXPECT_TRUE(read.has_value()) << read.error().message;
}

}  // namespace

Handed TaughtRun::next(std::uint32_t places, std::size_t content_bytes, std::uint64_t values) {
  Handed handed;
  Batch& batch = handed.batch;
  batch.experience = experience_;
  batch.sequence = ++sequence_;
  batch.robot = robot_;
  batch.name = "run";
  batch.method = "marks";
  for (std::uint32_t i = 0; i < places; ++i, ++places_) {
    Random random(experience_.value * 1'000'000 + places_);
    Bytes content(content_bytes);
    for (std::uint8_t& byte : content) byte = static_cast<std::uint8_t>(random.below(values));
    Place place;
    place.id = {experience_, places_};
    place.method = "marks";
    place.content = {hash_bytes(content), content.size()};
    place.robot = robot_;
    place.frame = places_;
    if (places_ > 0) {
      Edge edge;
      edge.id = {{experience_, places_ - 1}, {experience_, places_}};
      edge.a_from_b = metric(spacing_m_, 0.0);
      edge.method = "marks";
      batch.edges.push_back(edge);
    }
    batch.places.push_back(std::move(place));
    handed.contents.push_back(std::move(content));
  }
  return handed;
}

Handed TaughtRun::seal() {
  Handed handed = next(0);
  handed.batch.seal = true;
  handed.batch.seal_reason = "the operator ended it";
  return handed;
}

Edge stitch(const PlaceId& older, const PlaceId& newer, double x, double y) {
  Edge edge;
  edge.id = {older, newer};
  edge.a_from_b = metric(x, y);
  edge.origin = Origin::stitch;
  edge.method = "marks";
  edge.drivable = Drivable::both;
  edge.inliers = 20;
  edge.overlap = 0.8F;
  return edge;
}

Edge turned(Edge stitch, double heading_rad) {
  std::get<Metric2>(stitch.a_from_b).a_from_b.heading = heading_rad;
  return stitch;
}

Site::Site(std::shared_ptr<storage::MemoryDisk> on, Signers signers)
    : disk(std::move(on)), signers_(std::move(signers)) {
  start_server();
}

void Site::start_server() {
  store_ = storage::make_memory_store(disk);
  ServiceConfig config;
  config.self = robot_id(255);
  config.incarnation = ++starts_;
  config.software = "test";
  config.vendor = "inprocess";
  config.signers = signers_;
  config.unjoined = unjoined;
  config.charge = charge;
  Result<std::unique_ptr<Service>> started = start(config, *store_, Random(42 + starts_), now);
  ASSERT_TRUE(started) << started.error().message;
  service_ = *std::move(started);
  take(service_->tick(now));
}

void Site::restart() {
  service_.reset();
  said_.clear();
  start_server();
}

void Site::take(std::vector<msg::Message> messages) {
  for (const msg::Message& message : messages) expect_readable(message);
  std::move(messages.begin(), messages.end(), std::back_inserter(said_));
}

void Site::say(const msg::Message& message) {
  take(service_->handle(message, now));
}

void Site::pass(Duration duration) {
  const SteadyTime end = now.steady + duration;
  const WallTime wall_end = now.wall + duration;
  for (int turns = 0; turns < 100'000; ++turns) {
    const std::optional<SteadyTime> next = service_->next_tick();
    if (!next || *next > end) break;
    const SteadyTime at = std::max(*next, now.steady);
    now.wall += at - now.steady;
    now.steady = at;
    take(service_->tick(now));
  }
  now = {.steady = end, .wall = wall_end};
}

void Site::hello(Peer& robot) {
  msg::Hello hello;
  hello.peer = robot.id;
  hello.incarnation = robot.incarnation;
  hello.role = msg::Role::agent;
  hello.name = robot.name;
  hello.vendor = "inprocess";
  say(hello);
}

void Site::arrive(Peer& robot, const std::optional<PlaceId>& place) {
  hello(robot);
  msg::RobotDescription description;
  description.header = robot.header();
  description.name = robot.name;
  description.body = "sim";
  description.methods = {"marks"};
  description.knows_limits = robot.knows_limits;
  say(description);
  say(state(robot, place));
}

msg::RobotState Site::state(Peer& robot, const std::optional<PlaceId>& place) const {
  msg::RobotState state;
  state.header = robot.header();
  state.name = robot.name;
  state.localised = place.has_value();
  state.place = place.value_or(PlaceId{});
  return state;
}

msg::RobotState Site::driving(Peer& robot, const Route& route, const PlaceId& place) const {
  msg::RobotState driving = state(robot, place);
  driving.mode = msg::RobotMode::driving;
  driving.goal = route.goal;
  driving.route = route.id;
  driving.route_version = route.version;
  return driving;
}

void Site::stand_stopped(Peer& robot, const PlaceId& place) {
  msg::RobotState stopped = state(robot, place);
  stopped.mode = msg::RobotMode::stopped;
  say(stopped);
}

void Site::stand(Peer& robot, const PlaceId& place, int seconds) {
  for (int second = 0; second < seconds; ++second) {
    say(state(robot, place));
    pass(1s);
  }
}

void Site::power(Peer& robot, double share, bool is_charging) {
  msg::RobotPower power;
  power.header = robot.header();
  power.share = share;
  power.is_charging = is_charging;
  say(power);
}

void Site::progress(Peer& robot, const Route& route, msg::RoutePhase phase, std::uint32_t freed,
                    std::optional<std::uint32_t> at) {
  msg::RouteProgress progress;
  progress.header = robot.header();
  progress.goal = route.goal;
  progress.route = route.id;
  progress.version = route.version;
  progress.phase = phase;
  progress.at = at.value_or(freed);
  progress.freed = freed;
  progress.released = route.released;
  say(progress);
}

void Site::send_batch(Peer& robot, const Batch& batch) {
  say(msg::ExperienceBatch{.header = robot.header(), .batch = batch});
}

void Site::send_content(Peer& robot, const Bytes& bytes) {
  const ContentHash hash = hash_bytes(bytes);
  for (std::size_t offset = 0; offset < bytes.size(); offset += msg::kChunkBytes) {
    const std::size_t size = std::min(msg::kChunkBytes, bytes.size() - offset);
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(offset);
    msg::Chunk chunk;
    chunk.header = robot.header();
    chunk.hash = hash;
    chunk.total = bytes.size();
    chunk.offset = offset;
    chunk.data = Bytes(begin, begin + static_cast<std::ptrdiff_t>(size));
    say(chunk);
  }
}

void Site::hand_in(Peer& robot, const Handed& handed) {
  send_batch(robot, handed.batch);
  for (const Bytes& content : handed.contents) send_content(robot, content);
}

msg::QueryReply Site::read(msg::Query::Kind kind) {
  msg::Query query;
  query.header = client.header();
  query.kind = kind;
  say(query);
  return last<msg::QueryReply>().value();
}

msg::MapInfo Site::info() {
  return read(msg::Query::Kind::info).info;
}

msg::RobotRow Site::row(const std::string& robot) {
  const msg::QueryReply reply = read(msg::Query::Kind::robots);
  for (const msg::RobotRow& row : reply.robots) {
    if (row.description.name == robot) return row;
  }
  ADD_FAILURE() << "no row of " << robot;
  return {};
}

std::uint64_t Site::counted(const std::string& what) {
  for (const auto& [counter, times] : info().counters) {
    if (counter == what) return times;
  }
  return 0;
}

void Site::label(const std::string& name, const PlaceId& place) {
  msg::OperatorRequest label = request(msg::OperatorRequest::Kind::label);
  label.label = name;
  label.place = place;
  const msg::OperatorReply reply = ask(label);
  ASSERT_EQ(reply.outcome, msg::Outcome::done) << reply.message;
}

msg::OperatorRequest Site::request(msg::OperatorRequest::Kind kind) {
  msg::OperatorRequest request;
  request.header = client.header();
  request.request = ++request_;
  request.kind = kind;
  return request;
}

msg::OperatorReply Site::ask(const msg::OperatorRequest& request) {
  say(request);
  msg::OperatorReply found;
  bool is_answered = false;
  for (const msg::OperatorReply& reply : heard<msg::OperatorReply>()) {
    if (reply.request != request.request || reply.to != request.header.sender) continue;
    found = reply;
    is_answered = true;
  }
  EXPECT_TRUE(is_answered) << "no answer to request " << request.request;
  return found;
}

msg::OperatorReply Site::send_goal(std::uint8_t number, const std::string& label, const std::string& robot) {
  msg::OperatorRequest send = request(msg::OperatorRequest::Kind::goal_send);
  send.goal = goal_id(number);
  send.label = label;
  send.robot = robot;
  send.no_return = true;  // most sites are one road
  return ask(send);
}

msg::OperatorReply Site::put_rule(const Rule& rule) {
  msg::OperatorRequest put = request(msg::OperatorRequest::Kind::rule_put);
  put.rule = rule;
  return ask(put);
}

const Goal& Site::goal(std::uint8_t number) {
  found_ = Goal{};
  for (const Goal& goal : service_->goals()) {
    if (goal.id == goal_id(number)) found_ = goal;
  }
  EXPECT_EQ(found_.id, goal_id(number)) << "there is no such goal";
  return found_;
}

std::vector<Goal> Site::goals_of(GoalKind kind) {
  std::vector<Goal> found;
  for (const Goal& goal : service_->goals()) {
    if (goal.kind == kind) found.push_back(goal);
  }
  return found;
}

std::optional<Route> Site::order_to(const Peer& robot) const {
  std::optional<Route> found;
  for (const msg::RouteOrder& order : heard<msg::RouteOrder>()) {
    if (order.to == robot.id && !order.route.ended) found = order.route;
  }
  return found;
}

std::vector<std::string> Site::events_of(const std::string& kind) const {
  std::vector<std::string> causes;
  for (const msg::Event& event : disk->events) {
    if (event.kind == kind) causes.push_back(event.cause);
  }
  return causes;
}

}  // namespace weft::server::test
