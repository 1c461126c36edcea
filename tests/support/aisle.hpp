#pragma once
#include <cmath>
#include <memory>

#include "agents/bodies/sim/sim_body.hpp"

namespace weft::test {

/// Returns a site: an aisle of 16 m between racks with stock, along x at y = 6 m, and a robot that looks ahead in it.
inline agents::sim::Site aisle_site() {
  using namespace agents::sim;
  Site site;
  site.name = "aisle";
  site.floor.x_max = 24.0;
  site.floor.material = "worn-concrete";
  for (const double y : {3.5, 8.5}) site.boxes.push_back({Box::Kind::rack, "rack", {12.0, y, 0.0}, 16.2, 1.0, 4.5});
  for (const double x : {4.0, 12.0, 20.0}) site.lamps.push_back({x, 6.0, 6.0, 1.0});
  RobotStart robot{"r1", {4.0, 6.0, 0.0}, 1};
  robot.looks = {agents::Gaze::ahead};
  site.forward_camera.exposes_itself = false;  // nothing to wait for
  site.robots.push_back(robot);
  return site;
}

/// Looks from wherever it is put: what a robot sees that stands there.
class Lookout {
 public:
  explicit Lookout(const agents::sim::Site& site, std::uint64_t day = 0) {
    agents::sim::SimBodyConfig config;
    config.site = site;
    config.site.disturbances.dropped_frames = 0.0;
    config.robot = "r1";
    config.day = day;
    body_ = *agents::sim::make_sim_body(config);
  }
  agents::CameraModel camera() const { return body_->rig().camera(); }
  agents::View from(const Pose2& site_from_robot) {
    body_->put(site_from_robot, {});
    return body_->step({})->views.front();
  }

 private:
  std::unique_ptr<agents::sim::SimulatedBody> body_;
};

}  // namespace weft::test
