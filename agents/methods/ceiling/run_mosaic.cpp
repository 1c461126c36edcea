#include "agents/methods/ceiling/run_mosaic.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "agents/methods/ceiling/height.hpp"
#include "agents/methods/ceiling/rectified.hpp"
#include "agents/perception/lens.hpp"

namespace weft::agents {
namespace {

constexpr std::size_t kSightingsOfPlace = 150;

bool is_same_mount(const Pose3& a, const Pose3& b) {
  constexpr double rounded = 1e-9;
  return (a.translation - b.translation).norm() < rounded && a.rotation.angularDistance(b.rotation) < 1e-6;
}

/// Returns the edge by which a place was joined to the one before; null: there is none of a pose.
const Metric2* step_to(const CeilingRun& run, std::size_t place) {
  for (const Edge& edge : run[place].edges) {
    if (edge.origin == Origin::stitch || edge.id.a != run[place - 1].id || edge.id.b != run[place].id) continue;
    return std::get_if<Metric2>(&edge.a_from_b);
  }
  return nullptr;
}

/// Returns the covariance of a relation as the adjustment takes it: certain about nothing.
Eigen::Matrix3d widened(const Eigen::Matrix3d& covariance) {
  constexpr double least = 1e-8;  // (0.1 mm)^2, (0.1 mrad)^2
  return 0.5 * (covariance + covariance.transpose()) + least * Eigen::Matrix3d::Identity();
}

/// Returns a feature's ray in the frame of its camera, by the mount alone: the attitude is an unknown of the mosaic.
Eigen::Vector3d ray_of(const CameraModel& camera, const PlaneFeature& feature) {
  const Eigen::Vector3d in_robot(feature.on_plane.x(), feature.on_plane.y(), feature.above_floor_m);
  return camera.robot_from_camera.rotation.conjugate() * (in_robot - camera.robot_from_camera.translation);
}

/// Returns the sigma of a ray: of the image's pixel and of the rectified ceiling's, as where contents are related.
double ray_sigma(const CeilingConfig& config, const CeilingContent& content, double away_m) {
  constexpr double image_sigma_px = 0.5;
  return std::hypot(image_sigma_px / focal_px(content.camera),
                    config.feature_sigma_px * metres_per_pixel(config, content.ceiling_m) / away_m);
}

using Positions = std::map<PlaceId, std::uint32_t>;
Positions positions_of(const CeilingRun& run) {
  Positions positions;
  for (std::uint32_t i = 0; i < run.size(); ++i) positions.emplace(run[i].id, i);
  return positions;
}

/// Describes an edge both of whose ends lie in the run.
struct OwnEdge {
  const Edge* edge;
  std::uint32_t a;
  std::uint32_t b;
  Metric2 taught;
};

/// Returns the edges of poses within the run.
std::vector<OwnEdge> own_edges(const CeilingRun& run) {
  const Positions positions = positions_of(run);
  std::vector<OwnEdge> own;
  for (const auto& place : run) {
    for (const Edge& edge : place.edges) {
      const auto a = positions.find(edge.id.a);
      const auto b = positions.find(edge.id.b);
      const auto* const taught = std::get_if<Metric2>(&edge.a_from_b);
      if (taught == nullptr || a == positions.end() || b == positions.end() || a == b) continue;
      own.push_back({&edge, a->second, b->second, *taught});
    }
  }
  return own;
}

void add_places_and_links(const CeilingRun& run, Mosaic& mosaic) {
  constexpr double least_sigma = 1e-4;
  for (std::size_t i = 0; i < run.size(); ++i) {
    const CeilingContent& content = *run[i].content;
    const Pose2 map_from_place =
        i == 0 ? Pose2{} : mosaic.places.back().map_from_place * taught_step(run, i).a_from_b;
    mosaic.places.push_back({map_from_place, content.attitude, content.attitude_sigma.cwiseMax(least_sigma)});
  }
  for (const OwnEdge& own : own_edges(run))
    mosaic.links.push_back(
        {own.a, own.b, own.taught.a_from_b, widened(own.taught.covariance), own.edge->origin == Origin::stitch});
}

const PlaneFeature& feature_of(const CeilingRun& run, const RunFeature& of) {
  return run[of.place].content->features[of.feature];
}

/// Returns the corners that two places or more show, those that most show first.
std::vector<std::size_t> by_length(const std::vector<std::vector<RunFeature>>& corners) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (corners[i].size() >= 2) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return corners[a].size() > corners[b].size(); });
  return order;
}

/// Adds a corner with those of its features whose places are not full yet; nothing, where they are fewer than two.
void add_corner(const CeilingConfig& config, const CeilingRun& run, const std::vector<RunFeature>& corner,
                std::vector<std::size_t>& counts, RunMosaic& out) {
  std::vector<RunFeature> open;
  std::copy_if(corner.begin(), corner.end(), std::back_inserter(open),
               [&](const RunFeature& seen) { return counts[seen.place] < kSightingsOfPlace; });
  if (open.size() < 2) return;
  const RunFeature best = *std::min_element(open.begin(), open.end(), [&](const RunFeature& a, const RunFeature& b) {
    return feature_of(run, a).above_floor_sigma_m < feature_of(run, b).above_floor_sigma_m;
  });
  const auto point = static_cast<std::uint32_t>(out.mosaic.points.size());
  const auto sighting_of = [&](const RunFeature& seen) {
    const CeilingContent& content = *run[seen.place].content;
    const Eigen::Vector3d ray = ray_of(content.camera, feature_of(run, seen));
    return MosaicSighting{seen.place, point, ray.normalized(), ray_sigma(config, content, ray.norm())};
  };
  const auto in_map = met(out.mosaic, sighting_of(best), feature_of(run, best).above_floor_m);
  if (!in_map) return;
  const PlaneFeature& told = feature_of(run, best);
  const double told_sigma_m = std::max(told.above_floor_sigma_m, config.flat_sigma_m);
  out.mosaic.points.push_back({*in_map, told.above_floor_m, told_sigma_m, 0.0});
  for (const RunFeature& seen : open) {
    out.mosaic.sightings.push_back(sighting_of(seen));
    out.features.push_back(seen.feature);
    ++counts[seen.place];
  }
}

/// Returns how many sigmas a sighting lies off the point that it shows.
double off_sigmas(const Mosaic& mosaic, const MosaicSighting& sighting) {
  const MosaicPlace& place = mosaic.places[sighting.place];
  const Pose3 map_from_camera =
      lift(place.map_from_place) * level_from_body(place.attitude) * mosaic.robot_from_camera;
  const Eigen::Vector3d there = map_from_camera.inverse() * mosaic.points[sighting.point].in_map;
  return there.normalized().cross(sighting.ray).norm() / sighting.sigma_rad;
}

/// Returns a point's height, where the adjustment has told one that can be a ceiling's.
std::optional<Height> told_height(const CeilingConfig& config, double ceiling_m, const Mosaic& mosaic,
                                  const MosaicPoint& point) {
  const HeightPrior prior = height_prior(config, ceiling_m, mosaic.robot_from_camera.translation.z());
  if (!(point.height_sigma_m > 0.0) || point.in_map.z() < prior.lowest_m) return std::nullopt;
  // The poses have their own error, which the point's sigma leaves out.
  return Height{std::min(point.in_map.z(), ceiling_m), std::hypot(point.height_sigma_m, prior.flat_sigma_m)};
}

}  // namespace

bool is_adjustable(const CeilingRun& run) {
  if (run.size() < 2) return false;
  const auto is_like_first = [&](const ExperiencePlace<CeilingContent>& place) {
    return place.content && place.content->ceiling_m == run.front().content->ceiling_m &&
           is_same_mount(place.content->camera.robot_from_camera, run.front().content->camera.robot_from_camera);
  };
  if (!run.front().content || !std::all_of(run.begin(), run.end(), is_like_first)) return false;
  for (std::size_t i = 1; i < run.size(); ++i)
    if (step_to(run, i) == nullptr) return false;
  return true;
}

Metric2 taught_step(const CeilingRun& run, std::size_t place) {
  return *step_to(run, place);
}

RunMosaic mosaic_of(const CeilingConfig& config, const CeilingRun& run,
                    const std::vector<std::vector<RunFeature>>& corners) {
  RunMosaic out;
  out.mosaic.robot_from_camera = run.front().content->camera.robot_from_camera;
  add_places_and_links(run, out.mosaic);
  std::vector<std::size_t> counts(run.size(), 0);
  for (const std::size_t corner : by_length(corners)) add_corner(config, run, corners[corner], counts, out);
  return out;
}

Amendments<CeilingContent> amendments_of(const CeilingConfig& config, const CeilingRun& run, const Mosaic& adjusted,
                                         const std::vector<std::uint32_t>& features) {
  constexpr double most_sigmas = 4.0;
  Amendments<CeilingContent> changes;
  for (const OwnEdge& own : own_edges(run)) {
    const Pose2 a_from_b = adjusted.places[own.a].map_from_place.inverse() * adjusted.places[own.b].map_from_place;
    changes.edges.push_back({own.edge->id, Metric2{a_from_b, own.taught.covariance}});
  }
  for (std::size_t i = 0; i < run.size(); ++i) {
    changes.places.push_back({run[i].id, *run[i].content});
    changes.places.back().content.attitude = adjusted.places[i].attitude;
  }
  for (std::size_t i = 0; i < adjusted.sightings.size(); ++i) {
    const MosaicSighting& sighting = adjusted.sightings[i];
    CeilingContent& content = changes.places[sighting.place].content;
    PlaneFeature& feature = content.features[features[i]];
    const std::optional<Height> height =
        told_height(config, content.ceiling_m, adjusted, adjusted.points[sighting.point]);
    if (!height || height->sigma_m >= feature.above_floor_sigma_m) continue;
    if (off_sigmas(adjusted, sighting) < most_sigmas) set_height(content.camera, *height, feature);
  }
  return changes;
}

}  // namespace weft::agents
