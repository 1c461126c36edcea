#include "agents/adjustment/mosaic.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace weft::agents {
namespace {

std::string at(const char* kind, std::size_t index, const std::string& what) {
  return std::string(kind) + " " + std::to_string(index) + ": " + what;
}

std::string beyond(const char* kind, std::size_t index, const char* whose, std::uint32_t number, std::size_t size) {
  return at(kind, index,
            std::string(whose) + " " + std::to_string(number) + " is not one of " + std::to_string(size));
}

bool is_covariance(const Eigen::Matrix3d& matrix) {
  return matrix.allFinite() && matrix.llt().info() == Eigen::Success;
}

}  // namespace

std::optional<Eigen::Vector3d> met(const Mosaic& mosaic, const MosaicSighting& sighting, double height_m) {
  const MosaicPlace& place = mosaic.places[sighting.place];
  const Pose3 map_from_camera =
      lift(place.map_from_place) * level_from_body(place.attitude) * mosaic.robot_from_camera;
  const Eigen::Vector3d direction = map_from_camera.rotation * sighting.ray;
  const double metres = (height_m - map_from_camera.translation.z()) / direction.z();
  if (!(metres > 0.0) || !std::isfinite(metres)) return std::nullopt;
  return map_from_camera.translation + metres * direction;
}

std::string problem_of(const Mosaic& mosaic) {
  for (std::size_t i = 0; i < mosaic.places.size(); ++i) {
    const MosaicPlace& place = mosaic.places[i];
    if (!is_finite(place.map_from_place) || !place.attitude.vector().allFinite())
      return at("place", i, "its pose or attitude is not finite");
    if (!(place.attitude_sigma.minCoeff() > 0.0)) return at("place", i, "a sigma of its attitude is not above 0");
  }
  for (std::size_t i = 0; i < mosaic.points.size(); ++i) {
    const MosaicPoint& point = mosaic.points[i];
    if (!point.in_map.allFinite() || !std::isfinite(point.told_m)) return at("point", i, "it is not finite");
    if (!(point.told_sigma_m > 0.0)) return at("point", i, "the sigma of its told height is not above 0");
  }
  for (std::size_t i = 0; i < mosaic.sightings.size(); ++i) {
    const MosaicSighting& sighting = mosaic.sightings[i];
    if (sighting.place >= mosaic.places.size())
      return beyond("sighting", i, "place", sighting.place, mosaic.places.size());
    if (sighting.point >= mosaic.points.size())
      return beyond("sighting", i, "point", sighting.point, mosaic.points.size());
    constexpr double rounded = 1e-6;
    if (!(std::abs(sighting.ray.norm() - 1.0) < rounded)) return at("sighting", i, "its ray is not a unit vector");
    if (!(sighting.sigma_rad > 0.0)) return at("sighting", i, "its sigma is not above 0");
  }
  for (std::size_t i = 0; i < mosaic.links.size(); ++i) {
    const MosaicLink& link = mosaic.links[i];
    for (const std::uint32_t end : {link.from, link.to})
      if (end >= mosaic.places.size()) return beyond("link", i, "place", end, mosaic.places.size());
    if (link.from == link.to) return at("link", i, "it joins a place to itself");
    if (!is_finite(link.from_from_to) || !is_covariance(link.covariance))
      return at("link", i, "its relation is not finite, or its covariance not positive definite");
  }
  return {};
}

}  // namespace weft::agents
