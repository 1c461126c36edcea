#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>

#include "storage/formats/network_export.hpp"
#include "storage/formats/relation_text.hpp"

namespace weft::formats {
namespace {

constexpr double kLeastVariance = 1e-12;

template <int N>
Eigen::Matrix<double, N, N> information_of(const Eigen::Matrix<double, N, N>& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> axes(covariance);
  if (axes.eigenvalues().minCoeff() >= kLeastVariance) {
    const Eigen::Matrix<double, N, N> inverse = covariance.llt().solve(Eigen::Matrix<double, N, N>::Identity());
    return 0.5 * (inverse + inverse.transpose());
  }
  const Eigen::Matrix<double, N, 1> inverted = axes.eigenvalues().cwiseMax(kLeastVariance).cwiseInverse();
  const Eigen::Matrix<double, N, N> information =
      axes.eigenvectors() * inverted.asDiagonal() * axes.eigenvectors().transpose();
  return 0.5 * (information + information.transpose());
}

SpatialMeasurement spatial(const Relation& relation) {
  if (const auto* const metric = std::get_if<Metric3>(&relation)) {
    return {metric->a_from_b, information_of<6>(metric->covariance.matrix())};
  }
  const Eigen::Matrix3d planar_part = planar_covariance(relation);
  constexpr std::array<int, 3> kOf = {0, 1, 5};  // x, y and the turn about z
  Matrix6d covariance = Matrix6d::Zero();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      covariance(kOf.at(static_cast<std::size_t>(row)), kOf.at(static_cast<std::size_t>(column))) =
          planar_part(row, column);
    }
  }
  return {lift(planar(relation)), information_of<6>(covariance)};
}

Measurement measurement_of(const Relation& relation, bool is_spatial) {
  if (is_spatial) return spatial(relation);
  return PlanarMeasurement{planar(relation), information_of<3>(planar_covariance(relation))};
}

/// Returns the keys of the places, and adds the notes that say so.
std::map<PlaceId, std::uint64_t> keys_of(const Window& network, std::vector<std::string>& notes) {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  std::map<ExperienceId, std::size_t> experiences;
  for (const auto& [id, place] : network.places) experiences.emplace(id.experience, experiences.size());
  const bool symbols = experiences.size() <= kLetters.size();
  std::map<PlaceId, std::uint64_t> keys;
  PlaceId first;
  std::uint64_t first_key = 0;
  std::uint64_t run = 0;
  const auto note = [&] {
    if (run > 0)
      notes.push_back("places " + std::to_string(first_key) + " " + to_string(first) + " " + std::to_string(run));
  };
  for (const auto& [id, place] : network.places) {
    const std::size_t number = experiences.at(id.experience);
    const std::uint64_t key =
        symbols ? (static_cast<std::uint64_t>(kLetters[number]) << 56U) | id.index : keys.size();
    keys.emplace(id, key);
    const bool continues = run > 0 && id.experience == first.experience && id.index == first.index + run;
    if (!continues) {
      note();
      first = id;
      first_key = key;
      run = 0;
    }
    ++run;
  }
  note();
  return keys;
}

tl::unexpected<Error> no_pose(const PlaceId& place) {
  return fail(ErrorCode::not_found, "place " + to_string(place) + " has no pose in the frame of the export");
}

}  // namespace

Result<PoseGraph> pose_graph_of(const Window& network, const Poses& frame_from_place) {
  PoseGraph graph;
  const std::map<PlaceId, std::uint64_t> keys = keys_of(network, graph.notes);
  for (const auto& [label, place] : network.labels) {
    if (keys.contains(place)) graph.notes.push_back("label " + std::to_string(keys.at(place)) + " " + label);
  }
  const bool is_spatial = std::any_of(network.edges.begin(), network.edges.end(), [](const auto& entry) {
    return std::holds_alternative<Metric3>(entry.second.a_from_b);
  });
  for (const auto& [id, key] : keys) {
    const auto pose = frame_from_place.find(id);
    if (pose == frame_from_place.end()) return no_pose(id);
    graph.vertices.push_back({key, is_spatial ? Estimate(lift(pose->second)) : Estimate(pose->second)});
  }
  for (const auto& [id, edge] : network.edges) {
    const std::uint64_t a = keys.at(id.a);
    const std::uint64_t b = keys.at(id.b);
    graph.edges.push_back({a, b, measurement_of(edge.a_from_b, is_spatial)});
    if (edge.origin == Origin::odometry && edge.drivable == Drivable::a_to_b) continue;
    graph.notes.push_back("edge " + std::to_string(a) + " " + std::to_string(b) + " " + to_string(edge.origin) + " " +
                          drivable_text(edge.drivable));
  }
  return graph;
}

Result<Trajectory> trajectory_of(const Window& network, const Poses& frame_from_place, ExperienceId experience) {
  Trajectory trajectory;
  for (const auto& [id, place] : network.places) {
    if (id.experience != experience) continue;
    const auto pose = frame_from_place.find(id);
    if (pose == frame_from_place.end()) return no_pose(id);
    const double time_s = seconds(place.seen_at.time_since_epoch());
    if (!trajectory.samples.empty() && time_s <= trajectory.samples.back().time_s) {
      return fail(ErrorCode::invalid, "place " + to_string(id) +
                                          " was not seen after the one before it: experience " +
                                          to_string(experience) + " has no times of a trajectory");
    }
    trajectory.samples.push_back({time_s, lift(pose->second)});
  }
  if (trajectory.samples.empty()) {
    return fail(ErrorCode::not_found, "experience " + to_string(experience) + " is not in the network");
  }
  return trajectory;
}

}  // namespace weft::formats
