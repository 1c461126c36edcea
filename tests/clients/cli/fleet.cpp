#include "tests/clients/cli/fleet.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/network/change.hpp"
#include "core/network/codec.hpp"

namespace weft::cli::test {
namespace {
using namespace std::chrono_literals;

constexpr Duration kStep = 20ms;

PeerId peer(std::uint8_t number) {
  PeerId id;
  id.bytes.fill(number);
  return id;
}

/// Returns poses along a closed polyline, so far apart.
std::vector<Pose2> walk(const std::vector<Eigen::Vector2d>& corners, double spacing) {
  std::vector<Pose2> poses;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const Eigen::Vector2d side = corners[i + 1] - corners[i];
    const double heading = std::atan2(side.y(), side.x());
    for (double along = 0.0; along < side.norm() - 1e-9; along += spacing) {
      const Eigen::Vector2d at = corners[i] + side.normalized() * along;
      poses.push_back({at.x(), at.y(), heading});
    }
  }
  return poses;
}

Edge edge_between(const PlaceId& a, const Pose2& site_from_a, const PlaceId& b, const Pose2& site_from_b,
                  Origin origin) {
  Edge edge;
  edge.id = {a, b};
  edge.a_from_b = Metric2{site_from_a.inverse() * site_from_b, Eigen::Matrix3d::Identity() * 1e-4};
  edge.origin = origin;
  edge.method = "floor";
  edge.drivable = origin == Origin::stitch ? Drivable::both : Drivable::a_to_b;
  edge.inliers = origin == Origin::stitch ? 55 : 0;
  edge.overlap = origin == Origin::stitch ? 0.7F : 0.0F;
  return edge;
}

Batch taught(ExperienceId experience, const RobotId& robot, const std::vector<Pose2>& poses) {
  Batch batch;
  batch.experience = experience;
  batch.sequence = 1;
  batch.robot = robot;
  batch.method = "floor";
  for (std::uint32_t i = 0; i < poses.size(); ++i) {
    Place place;
    place.id = {experience, i};
    place.method = "floor";
    place.content = {content_hash(), content_bytes().size()};
    place.robot = robot;
    place.frame = 10 * i;
    batch.places.push_back(place);
    if (i > 0) {
      batch.edges.push_back(edge_between({experience, i - 1}, poses[i - 1], place.id, poses[i], Origin::odometry));
    }
  }
  batch.seal = true;
  batch.seal_reason = "taught to its end";
  return batch;
}

}  // namespace

std::filesystem::path folder() {
  // Tests run side by side.
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "weft_cli" /
                                     (std::string(test.test_suite_name()) + "." + test.name());
  std::filesystem::create_directories(path);
  return path;
}

Bytes content_bytes() {
  return {1, 2, 3};
}
ContentHash content_hash() {
  return hash_bytes(content_bytes());
}

std::vector<Batch> two_loops(ExperienceId first, ExperienceId second, const RobotId& r1, const RobotId& r2) {
  const std::vector<Pose2> one = walk({{0, 0}, {12, 0}, {12, 5}, {0, 5}, {0, 0.5}}, 0.5);
  const std::vector<Pose2> two = walk({{4, 0.1}, {12, 0.1}, {12, -4}, {2, -4}, {2, -1}}, 0.5);
  std::vector<Batch> batches = {taught(first, r1, one), taught(second, r2, two)};
  for (std::uint32_t i = 0; i < two.size(); ++i) {
    for (std::uint32_t j = 0; j < one.size(); ++j) {
      const Pose2 seen = one[j].inverse() * two[i];
      if (seen.translation().norm() > 0.2 || std::abs(seen.heading) > 0.1) continue;
      batches.back().edges.push_back(edge_between({first, j}, one[j], {second, i}, two[i], Origin::stitch));
    }
  }
  return batches;
}

Fleet::Fleet() : disk(std::make_shared<storage::MemoryDisk>()), net_(Random(7)) {
  const std::vector<Batch> batches = two_loops(first, second, peer(11), peer(12));
  const std::unique_ptr<storage::MapStore> store = storage::make_memory_store(disk);
  EXPECT_TRUE(store->open().has_value());
  storage::Transaction transaction;
  transaction.changes.emplace_back(storage::PutContent{content_hash(), msg::ContentKind::content, content_bytes()});
  for (const Batch& batch : batches) transaction.changes.emplace_back(storage::AppendBatch{batch, hash(batch)});
  transaction.changes.emplace_back(storage::PutLabel{"dock", {first, 30}});
  transaction.changes.emplace_back(storage::PutLabel{"packing", {second, 30}});
  const auto committed = store->commit(transaction);
  EXPECT_TRUE(committed.has_value()) << (committed ? "" : committed.error().message);
  restart_server();
  run(100ms);
}

server::Now Fleet::both() const {
  return {now, WallTime{1'700'000'000s} + now.time_since_epoch()};
}

void Fleet::restart_server() {
  server_link_.reset();
  service.reset();
  store_ = storage::make_memory_store(disk);
  server::ServiceConfig config;
  config.self = peer(1);
  config.incarnation = ++starts_;
  config.software = "0.1.0";
  config.vendor = "inprocess";
  auto started = server::start(config, *store_, Random(starts_), both());
  ASSERT_TRUE(started.has_value()) << started.error().message;
  service = std::move(*started);
  server_link_ = std::make_unique<bus::Link>(net_.attach(msg::Role::server, peer(1)));
}

void Fleet::serve() {
  if (!server_lives) return;
  std::vector<msg::Message> out = service->tick(both());
  while (const std::optional<msg::Message> message = server_link_->take()) {
    if (const auto* const query = std::get_if<msg::Query>(&*message)) ++asked[query->kind];
    for (msg::Message& answer : service->handle(*message, both())) out.push_back(std::move(answer));
  }
  for (const msg::Message& message : out) EXPECT_TRUE(server_link_->send(message).has_value());
}

template <class M>
void Fleet::say(Puppet& puppet, M message) {
  message.header = {
      .sender = puppet.id, .incarnation = 1, .epoch = {}, .sequence = ++puppet.sequence, .signature = {}};
  EXPECT_TRUE(puppet.link->send(std::move(message)).has_value());
}

Puppet& Fleet::add_robot(const std::string& name, const std::string& software) {
  auto puppet = std::make_unique<Puppet>();
  puppet->id = peer(static_cast<std::uint8_t>(11 + puppets.size()));
  puppet->name = name;
  puppet->state.name = name;
  puppet->link = std::make_unique<bus::Link>(net_.attach(msg::Role::agent, puppet->id));
  msg::Hello hello;
  hello.peer = puppet->id;
  hello.incarnation = 1;
  hello.name = name;
  hello.vendor = "inprocess";
  hello.software = software;
  EXPECT_TRUE(puppet->link->send(hello).has_value());
  msg::RobotDescription description;
  description.name = name;
  description.body = "sim";
  description.methods = {"floor"};
  description.can_be_taught_along = true;
  say(*puppet, description);
  puppets.push_back(std::move(puppet));
  run(100ms);
  return *puppets.back();
}

void Fleet::play(Puppet& puppet) {
  while (const std::optional<msg::Message> message = puppet.link->take()) {
    if (const auto* const command = std::get_if<msg::AgentCommand>(&*message)) {
      puppet.told.push_back(*command);
      msg::AgentReply reply;
      reply.command = command->command;
      reply.done = true;
      puppet.how(*command, reply);
      if (puppet.answers) say(puppet, reply);
    }
    if (const auto* const order = std::get_if<msg::RouteOrder>(&*message)) {
      puppet.route = order->route;
      if (order->route.ended) puppet.route.reset();
    }
  }
  if (now < puppet.speak_at) return;
  puppet.speak_at = now + 500ms;
  puppet.state.goal = puppet.route.has_value() ? puppet.route->goal : GoalId{};
  puppet.state.route = puppet.route.has_value() ? puppet.route->id : RouteId{};
  puppet.state.route_version = puppet.route.has_value() ? puppet.route->version : 0;
  if (puppet.route.has_value()) puppet.state.mode = msg::RobotMode::driving;
  say(puppet, puppet.state);
  if (!puppet.route.has_value()) return;
  msg::RouteProgress progress;
  progress.goal = puppet.route->goal;
  progress.route = puppet.route->id;
  progress.version = puppet.route->version;
  progress.phase = puppet.phase;
  progress.released = puppet.route->released;
  if (puppet.phase == msg::RoutePhase::arrived) {
    progress.at = static_cast<std::uint32_t>(puppet.route->places.size() - 1);
    progress.freed = progress.at;
    puppet.state.place = puppet.route->places.back();
  }
  say(puppet, progress);
}

void Fleet::turn(Duration step) {
  now += step;
  net_.deliver_until(now);
  serve();
  for (const auto& puppet : puppets) play(*puppet);
}

void Fleet::run(Duration duration) {
  for (const SteadyTime end = now + duration; now < end;) turn(kStep);
}

Said Fleet::weft(const std::vector<std::string>& arguments) {
  std::vector<const char*> argv = {"weft"};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  Said said;
  const auto parsed = parse(static_cast<int>(argv.size()), argv.data(), {});
  if (const auto* const not_run = std::get_if<NotRun>(&parsed)) {
    said.exit = static_cast<Exit>(not_run->exit_code);
    said.err = not_run->text;
    return said;
  }
  const PeerId self = identity(std::get<Invocation>(parsed), peer(static_cast<std::uint8_t>(100 + operators_++)));
  bus::Link link(net_.attach(msg::Role::client, self));
  const World world{[this] { return now; }, [this] { return both().wall; },
                    [this](Duration at_most) { turn(std::min(std::max(at_most, Duration{1ms}), kStep)); },
                    interrupted};
  Session session(link, world, Random(operators_), self, "tester");
  std::ostringstream out;
  std::ostringstream err;
  said.exit = cli::run(session, std::get<Invocation>(parsed), {out, err});
  said.out = out.str();
  said.err = err.str();
  return said;
}

}  // namespace weft::cli::test
