#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/network/change.hpp"
#include "core/random.hpp"

/// Makes networks for tests from a seed: valid, and with nothing regular about them.
namespace weft::support {

template <class Id>
Id random_id(Random& random) {
  Id id;
  for (auto& byte : id.bytes) byte = static_cast<std::uint8_t>(random.next());
  return id;
}

template <int N>
Eigen::Matrix<double, N, N> random_covariance(Random& random, double scale = 1e-3) {
  Eigen::Matrix<double, N, N> root;
  for (Eigen::Index i = 0; i < N * N; ++i) root(i) = random.normal(0.0, scale);
  return root * root.transpose();
}

inline Metric2 random_metric2(Random& random, double reach_m = 1.0) {
  return {{random.uniform(-reach_m, reach_m), random.uniform(-reach_m, reach_m), random.uniform(-3.1, 3.1)},
          random_covariance<3>(random)};
}

inline Metric3 random_metric3(Random& random, double reach_m = 1.0) {
  Vector6d twist;
  for (double& axis : twist) axis = random.uniform(-reach_m, reach_m);
  return {se3_exp(twist), random_covariance<6>(random)};
}

inline AlongPath random_along_path(Random& random, double reach_m = 1.0) {
  return {random.uniform(-reach_m, reach_m), random.uniform(), random.uniform(-3.1, 3.1), random.uniform()};
}

inline Relation random_relation(Random& random) {
  switch (random.below(3)) {
    case 0:
      return random_metric2(random);
    case 1:
      return random_metric3(random);
    default:
      return random_along_path(random);
  }
}

/// Returns one step of a planar teach: forward, turning a little.
inline Relation random_step(Random& random) {
  return Metric2{{random.uniform(0.1, 0.5), random.normal(0.0, 0.02), random.normal(0.0, 0.2)},
                 random_covariance<3>(random)};
}

struct BatchPlan {
  ExperienceId experience;  ///< continued if it is there, begun otherwise
  RobotId robot;
  std::uint64_t sequence = 1;
  std::uint32_t places = 5;
  std::uint32_t stitches = 3;  ///< as many as find an end
  std::string method = "marks";
};

inline Place make_place(Random& random, const BatchPlan& plan, std::uint32_t index) {
  Place place;
  place.id = {plan.experience, index};
  place.method = plan.method;
  place.content = {random_id<ContentHash>(random), 1 + random.below(1000)};
  place.robot = plan.robot;
  place.frame = 10 * index;
  place.seen_at = SensorTime(from_seconds(0.5 * index));
  return place;
}

inline Edge make_odometry(Random& random, const PlaceId& a, const std::string& method) {
  Edge edge;
  edge.id = {a, {a.experience, a.index + 1}};
  edge.a_from_b = random_step(random);
  edge.origin = random.chance(0.1) ? Origin::blind : Origin::odometry;
  edge.method = method;
  return edge;
}

inline Edge make_stitch(Random& random, const PlaceId& a, const PlaceId& b, const std::string& method) {
  Edge edge;
  edge.id = {a, b};
  edge.a_from_b = random_metric2(random, 0.3);
  edge.origin = Origin::stitch;
  edge.method = method;
  edge.drivable = random.chance(0.8) ? Drivable::both : Drivable::none;
  edge.inliers = static_cast<std::uint32_t>(20 + random.below(100));
  edge.overlap = static_cast<float>(random.uniform());
  return edge;
}

/// Returns any place of the snapshot, which must have one.
inline PlaceId pick_place(Random& random, const Snapshot& snapshot) {
  std::uint64_t number = random.below(snapshot.place_count());
  for (const auto& [id, experience] : snapshot.experiences()) {
    if (number < experience->places.size()) return experience->places[number].id;
    number -= experience->places.size();
  }
  return {};
}

/// Makes a batch that fits the snapshot.
inline Batch make_batch(Random& random, const Snapshot& snapshot, const BatchPlan& plan) {
  Batch batch;
  batch.experience = plan.experience;
  batch.sequence = plan.sequence;
  batch.robot = plan.robot;
  batch.name = "run";
  batch.method = plan.method;
  const Experience* const known = snapshot.experience(plan.experience);
  const auto first = known == nullptr ? 0U : static_cast<std::uint32_t>(known->places.size());
  for (std::uint32_t index = first; index < first + plan.places; ++index) {
    batch.places.push_back(make_place(random, plan, index));
    if (index > 0) batch.edges.push_back(make_odometry(random, {plan.experience, index - 1}, plan.method));
  }
  if (snapshot.place_count() == 0 || plan.places == 0) return batch;
  for (std::uint32_t i = 0; i < plan.stitches; ++i) {
    const PlaceId a = pick_place(random, snapshot);
    const PlaceId b{plan.experience, first + static_cast<std::uint32_t>(random.below(plan.places))};
    bool taken = a.experience == b.experience && b.index - a.index == 1;
    for (const Edge& edge : batch.edges) taken = taken || (edge.id.a == a && edge.id.b == b);
    if (!taken) batch.edges.push_back(make_stitch(random, a, b, plan.method));
  }
  return batch;
}

/// Makes a network: experiences in turns, each in batches; labels on some places.
inline Snapshot make_network(Random& random, std::uint32_t experiences = 3, std::uint32_t batches = 3,
                             std::uint32_t places = 5, std::uint32_t stitches = 3) {
  std::vector<BatchPlan> plans;
  for (std::uint32_t i = 0; i < experiences; ++i) {
    plans.push_back({ExperienceId{random.next() | 1U}, random_id<RobotId>(random), 0, places, stitches, "marks"});
  }
  Snapshot snapshot;
  for (std::uint32_t turn = 0; turn < batches; ++turn) {
    for (BatchPlan& plan : plans) {
      ++plan.sequence;
      snapshot = with(snapshot, make_batch(random, snapshot, plan));
    }
    snapshot = with_label(snapshot, "station" + std::to_string(turn), pick_place(random, snapshot));
  }
  return snapshot;
}

}  // namespace weft::support
