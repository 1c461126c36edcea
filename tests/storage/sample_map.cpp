#include "tests/storage/sample_map.hpp"

#include "core/network/codec.hpp"

namespace weft::storage::sample {
namespace {

template <class Id>
Id id_from(std::uint64_t number, std::uint8_t first) {
  Id id;
  id.bytes[0] = first;
  for (std::size_t at = 0; at < 8; ++at) id.bytes[8 + at] = static_cast<std::uint8_t>(number >> (8 * at));
  return id;
}

Edge odometry(const PlaceId& from, Random& random) {
  Edge edge;
  edge.id = {from, {from.experience, from.index + 1}};
  edge.a_from_b = Metric2{{random.uniform(0.2, 0.4), random.normal(0.0, 0.02), random.normal(0.0, 0.05)},
                          Eigen::Matrix3d::Identity() * 1e-4};
  edge.method = "marks";
  return edge;
}

std::string text(const Bytes& bytes) {
  return to_string(hash_bytes(bytes));
}

}  // namespace

RobotId robot(std::uint64_t number) {
  return id_from<RobotId>(number, 0x17);
}
GoalId goal_id(std::uint64_t number) {
  return id_from<GoalId>(number, 0x60);
}

Bytes content(Random& random, std::size_t size) {
  Bytes bytes(size);
  for (std::size_t at = 0; at < size; ++at) bytes[at] = static_cast<std::uint8_t>(random.below(16));
  return bytes;
}

Transaction transaction(const Delivery& delivery) {
  Transaction transaction;
  for (const Bytes& bytes : delivery.contents) {
    transaction.changes.emplace_back(PutContent{hash_bytes(bytes), msg::ContentKind::content, bytes});
  }
  transaction.changes.emplace_back(AppendBatch{delivery.batch, hash(delivery.batch)});
  return transaction;
}

Run::Run(std::uint64_t experience, std::uint64_t seed) : random_(seed), experience_{experience} {}

Delivery Run::next(std::uint32_t places, std::size_t content_bytes) {
  Delivery delivery;
  Batch& batch = delivery.batch;
  batch.experience = experience_;
  batch.sequence = ++sequence_;
  batch.robot = robot(experience_.value);
  batch.name = "run-" + std::to_string(experience_.value);
  batch.method = "marks";
  for (std::uint32_t at = 0; at < places; ++at, ++places_) {
    delivery.contents.push_back(content(random_, content_bytes));
    Place place;
    place.id = {experience_, places_};
    place.method = "marks";
    place.content = {hash_bytes(delivery.contents.back()), content_bytes};
    place.robot = batch.robot;
    place.frame = 10ULL * places_;
    place.seen_at = SensorTime(std::chrono::milliseconds(100 * places_));
    batch.places.push_back(place);
    if (places_ > 0) batch.edges.push_back(odometry({experience_, places_ - 1}, random_));
  }
  return delivery;
}

Edge stitch(const PlaceId& older, const PlaceId& newer) {
  Edge edge;
  edge.id = {older, newer};
  edge.a_from_b = Metric2{{0.05, -0.1, 0.2}, Eigen::Matrix3d::Identity() * 1e-3};
  edge.origin = Origin::stitch;
  edge.method = "marks";
  edge.drivable = Drivable::both;
  edge.inliers = 40;
  edge.overlap = 0.5F;
  return edge;
}

Place known_anew(const Place& place, const Bytes& better, const RobotId& by) {
  Place anew = place;
  ++anew.entity_version;
  anew.content = {hash_bytes(better), better.size()};
  anew.robot = by;
  return anew;
}

Goal goal(std::uint64_t number, const PlaceId& to) {
  Goal goal;
  goal.id = goal_id(number);
  goal.label = "dock";
  goal.to = to;
  goal.number = number;
  goal.history.push_back({WallTime(std::chrono::seconds(1)), GoalState::pending, "asked for", "tests"});
  return goal;
}

Route route(std::uint64_t number, const PlaceId& from, const PlaceId& to) {
  Route route;
  route.goal = goal_id(number);
  route.id = id_from<RouteId>(number, 0x70);
  route.made_of = {3};
  route.robot = robot(1);
  route.places = {from, to};
  route.relations = {Metric2{{1.0, 0.0, 0.0}, Eigen::Matrix3d::Identity()}};
  route.released = 1;
  return route;
}

std::vector<std::string> describe(const Snapshot& snapshot) {
  std::vector<std::string> lines{"revision " + std::to_string(snapshot.revision().value)};
  for (const auto& [id, experience] : snapshot.experiences()) {
    if (experience->places.empty()) continue;
    lines.push_back("experience " + to_string(id) + " " + to_string(experience->robot) + " " + experience->name +
                    " " + experience->method + (experience->sealed ? " sealed: " + experience->seal_reason : ""));
    for (const Place& place : experience->places)
      lines.push_back("place " + to_string(place.id) + text(encode(place)));
    for (const Edge& edge : experience->chain) lines.push_back("edge " + to_string(edge.id.a) + text(encode(edge)));
    for (const Edge& edge : experience->stitches) {
      lines.push_back("stitch " + to_string(edge.id.a) + " " + to_string(edge.id.b) + text(encode(edge)));
    }
  }
  for (const auto& [label, place] : snapshot.labels()) lines.push_back("label " + label + " " + to_string(place));
  for (const auto& [name, rule] : snapshot.rules()) lines.push_back("rule " + name + text(encode(rule)));
  for (const auto& [plan, registration] : snapshot.registrations())
    lines.push_back("plan " + plan + text(encode(registration)));
  for (const Apart& apart : snapshot.aparts()) lines.push_back("apart " + to_string(apart));
  return lines;
}

std::vector<std::string> describe(const Stored& stored) {
  std::vector<std::string> lines = describe(stored.snapshot);
  for (const auto& [id, through] : stored.durable_through) {
    lines.push_back("durable " + to_string(id) + " through " + std::to_string(through));
  }
  for (const auto& [id, goal] : stored.goals) lines.push_back("goal " + to_string(id) + text(encode(goal)));
  for (const auto& [id, route] : stored.routes) lines.push_back("route of " + to_string(id) + text(encode(route)));
  for (const auto& [id, held] : stored.occupancies) {
    lines.push_back("occupancy " + to_string(id) + " " + std::to_string(held.from) + " - " + std::to_string(held.to) +
                    text(encode(held.held)));
  }
  for (const auto& [id, name] : stored.robots) lines.push_back("robot " + to_string(id) + " " + name);
  for (const auto& [label, awaited] : stored.awaited_labels) {
    lines.push_back("awaited " + label + " " + to_string(awaited.place) + " " + to_string(awaited.robot) + " " +
                    to_string(awaited.asker) + " " + std::to_string(awaited.request) + " " + awaited.who);
  }
  for (const std::string& damage : stored.quarantined) lines.push_back("quarantined " + damage);
  return lines;
}

}  // namespace weft::storage::sample
