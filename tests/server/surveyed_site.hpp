#pragma once
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "core/network/change.hpp"
#include "core/random.hpp"
#include "server/traffic/proximity.hpp"

/// Makes lanes of a floor, taught with what odometry by the floor states of itself and errors that are drawn from it.
namespace weft::server::test {

inline constexpr double kSpacing_m = 0.25;

/// Makes a path that is driven: straight on and round bends, a place each quarter of a metre.
class Lane {
 public:
  explicit Lane(Pose2 start) : poses_{start} {}
  Lane& ahead(double metres) { return drive(metres, 0.0); }
  /// Adds a bend of so many radians, left positive, over as many metres.
  Lane& bend(double radians, double metres) { return drive(metres, radians); }
  const std::vector<Pose2>& poses() const { return poses_; }

 private:
  Lane& drive(double metres, double radians) {
    const int steps = static_cast<int>(std::lround(metres / kSpacing_m));
    for (int i = 0; i < steps; ++i) {
      poses_.push_back(poses_.back() * se2_exp({metres / steps, 0.0, radians / steps}));
    }
    return *this;
  }

  std::vector<Pose2> poses_;
};

class SurveyedSite {
 public:
  explicit SurveyedSite(std::uint64_t seed) : random_(seed) {}

  /// Returns the run's number, from 1.
  std::uint64_t teach(const Lane& lane) {
    Batch batch;
    batch.experience = ExperienceId{truth_.size() + 1};
    batch.method = "floor";
    const std::vector<Pose2>& poses = lane.poses();
    for (std::uint32_t i = 0; i < poses.size(); ++i) {
      Place place;
      place.id = {batch.experience, i};
      batch.places.push_back(place);
      if (i > 0) batch.edges.push_back(edge({batch.experience, i - 1}, place.id, poses[i - 1].inverse() * poses[i]));
    }
    truth_.push_back(poses);
    network_ = with(network_, batch);
    return batch.experience.value;
  }
  /// Teaches nothing: what a localisation found, with its own uncertainty.
  Edge stitch(const PlaceId& a, const PlaceId& b) {
    Batch batch;
    batch.experience = b.experience;
    batch.edges.push_back(edge(a, b, pose(a).inverse() * pose(b)));
    batch.edges.back().origin = Origin::stitch;
    network_ = with(network_, batch);
    return batch.edges.back();
  }

  const Pose2& pose(const PlaceId& place) const { return truth_[place.experience.value - 1][place.index]; }
  double distance_m(const PlaceId& a, const PlaceId& b) const {
    return (pose(a).translation() - pose(b).translation()).norm();
  }
  std::uint32_t places(std::uint64_t run) const { return static_cast<std::uint32_t>(truth_[run - 1].size()); }
  static PlaceId place(std::uint64_t run, std::uint32_t index) { return {ExperienceId{run}, index}; }
  const Snapshot& network() const { return network_; }
  Snapshot& network() { return network_; }

 private:
  /// Makes an edge with 4.3 mm along, 3.5 mm aside and 0.73 mrad per metre; steps are independent.
  Edge edge(const PlaceId& a, const PlaceId& b, const Pose2& truly) {
    const double root = std::sqrt(std::max(kSpacing_m, truly.translation().norm()));
    const Eigen::Vector3d sigma = root * Eigen::Vector3d(0.0043, 0.0035, 0.00073);
    Eigen::Vector3d error;
    for (Eigen::Index i = 0; i < 3; ++i) error(i) = random_.normal(0.0, sigma(i));
    Metric2 relation{truly * se2_exp(error), Eigen::Matrix3d::Zero()};
    relation.covariance.diagonal() = sigma.cwiseAbs2();
    Edge made;
    made.id = {a, b};
    made.a_from_b = relation;
    made.method = "floor";
    return made;
  }

  Random random_;
  Snapshot network_;
  std::vector<std::vector<Pose2>> truth_;
};

inline std::shared_ptr<const Snapshot> shared(const Snapshot& snapshot) {
  return std::make_shared<const Snapshot>(snapshot);
}

/// Makes one with everything laid out.
inline Proximity proximity_of(const Snapshot& snapshot) {
  Proximity proximity(2.2);
  proximity.layout().lay(shared(snapshot));
  proximity.layout().work(1'000'000);
  return proximity;
}

}  // namespace weft::server::test
