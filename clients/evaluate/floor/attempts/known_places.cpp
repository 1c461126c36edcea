#include "clients/evaluate/floor/attempts/known_places.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "agents/bodies/sim/base.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/plane/geometry.hpp"

namespace weft::evaluate::floor {
namespace {

using namespace agents;

Eigen::Vector2d middle_of(const Polygon& polygon) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& corner : polygon) sum += corner;
  return sum / static_cast<double>(polygon.size());
}

bool has_room(const sim::Site& site, const Pose2& robot, const Eigen::Vector2d& looks_at) {
  const sim::FloorSetup& floor = site.floor;
  const double radius = site.base.radius_m;
  const bool is_inside = robot.x > floor.x_min + radius && robot.x < floor.x_max - radius &&
                         robot.y > floor.y_min + radius && robot.y < floor.y_max - radius;
  return is_inside && std::all_of(site.boxes.begin(), site.boxes.end(), [&](const sim::Box& box) {
           return sim::distance_to(box, robot.x, robot.y) > radius &&
                  sim::distance_to(box, looks_at.x(), looks_at.y()) > 0.0;
         });
}

}  // namespace

Shows shows_of(FloorContent content, const Pose2& site_from_robot, double far_m) {
  SeenPlane floor{footprint(content.camera, content.attitude, far_m),
                  camera_from_floor(content.camera, content.attitude)};
  const Eigen::Vector2d middle = middle_of(floor.footprint);
  return {std::move(content), site_from_robot, std::move(floor), middle};
}

double shared(const Shows& a, const Shows& b) {
  return share_of_b_seen_in_a(a.floor, b.floor, a.site_from_robot.inverse() * b.site_from_robot);
}

Apart apart(const Shows& a, const Shows& b) {
  return {(a.site_from_robot * a.middle - b.site_from_robot * b.middle).norm(),
          std::abs(wrap_angle(a.site_from_robot.heading - b.site_from_robot.heading))};
}

Result<KnownPlaces> KnownPlaces::make(const Taught& taught, const Floor& method) {
  KnownPlaces known;
  for (const auto& [id, place] : taught.map.view().window.places) {
    const auto truth = taught.places.site_from_place.find(id);
    if (truth == taught.places.site_from_place.end()) continue;
    Result<FloorContent> content = method.decode(*taught.map.find(place.content.hash));
    if (!content) return fail(content.error());
    Signature signature = method.sign(*content).value_or(Signature{});
    known.all_.push_back(
        {id, shows_of(std::move(*content), truth->second, method.config().far_m), std::move(signature)});
  }
  return known;
}

std::vector<std::size_t> KnownPlaces::that_share(const Shows& view, double least) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < all_.size(); ++i) {
    if (shared(all_[i].shows, view) >= least) found.push_back(i);
  }
  return found;
}

std::vector<std::size_t> KnownPlaces::that_share_nothing(const Shows& view) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < all_.size(); ++i) {
    if (shared(all_[i].shows, view) <= 0.0) found.push_back(i);
  }
  return found;
}

std::size_t KnownPlaces::alike(const std::vector<std::size_t>& some, const Signature& signature,
                               Random& random) const {
  constexpr std::size_t kFew = 5;
  std::vector<std::pair<double, std::size_t>> by_distance;
  for (const std::size_t i : some) by_distance.emplace_back(distance2(all_[i].signature, signature), i);
  std::sort(by_distance.begin(), by_distance.end());
  return by_distance[random.below(std::min(kFew, by_distance.size()))].second;
}

std::optional<Pose2> spot_near(const Shows& place, const sim::Site& site, double most_m, Random& random) {
  constexpr int kDraws = 50;
  for (int i = 0; i < kDraws; ++i) {
    const double heading = random.uniform(-std::numbers::pi, std::numbers::pi);
    const double away_m = random.uniform(0.0, most_m);
    const double towards = random.uniform(-std::numbers::pi, std::numbers::pi);
    const Eigen::Vector2d looks_at =
        place.site_from_robot * place.middle + away_m * Eigen::Vector2d(std::cos(towards), std::sin(towards));
    Pose2 robot{0.0, 0.0, heading};
    const Eigen::Vector2d at = looks_at - robot * place.middle;
    robot.x = at.x();
    robot.y = at.y();
    if (has_room(site, robot, looks_at)) return robot;
  }
  return std::nullopt;
}

}  // namespace weft::evaluate::floor
