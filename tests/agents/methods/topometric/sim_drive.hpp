#pragma once
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "agents/bodies/sim/sim_body.hpp"
#include "agents/methods/topometric/topometric.hpp"
#include "tests/agents/bodies/sim/scenes.hpp"

namespace weft::agents::test {

inline sim::Site topometric_site(const std::string& name) {
  return sim::scene_in(std::string(WEFT_SITES) + "/topometric/", name + ".toml");
}

/// Drives a simulated robot, and has the method see what its pair sees.
class SimDrive {
 public:
  SimDrive(const sim::Site& site, const Pose2& site_from_robot, std::uint64_t seed = 1001, std::uint64_t day = 0,
           const TopometricConfig& config = {}) {
    sim::SimBodyConfig of_body;
    of_body.site = site;
    of_body.robot = "r1";
    of_body.seed = seed;
    of_body.day = day;
    Result<std::unique_ptr<sim::SimulatedBody>> body = sim::make_sim_body(of_body);
    EXPECT_TRUE(body) << body.error().message;
    body_ = std::move(*body);
    body_->put(site_from_robot, {});
    Result<Topometric> made = Topometric::make(config, body_->rig());
    EXPECT_TRUE(made) << made.error().message;
    method_ = std::make_unique<Topometric>(std::move(*made));
  }

  /// Goes on for one sample.
  Step step(const Twist& command) {
    const Result<Sample> sample = body_->step(command);
    EXPECT_TRUE(sample) << sample.error().message;
    const View* const view = sample->of("stereo");
    if (view != nullptr) view_ = *view;
    return method_->observe(odometry_, view, sample->motion);
  }
  /// Goes on until so much is driven or turned; at most 600 samples.
  void drive(double metres, double speed_m_s = 0.4) {
    const Pose2 from = truth();
    for (int i = 0; i < 600 && (from.inverse() * truth()).translation().norm() < metres; ++i) step({speed_m_s, 0.0});
  }
  void turn(double radians) {
    double turned = 0.0;
    for (int i = 0; i < 600 && turned < std::abs(radians); ++i) {
      const Pose2 before = truth();
      step({0.0, radians > 0.0 ? 0.5 : -0.5});
      turned += std::abs((before.inverse() * truth()).heading);
    }
  }

  OrRefusal<TopometricContent> extract() const { return method_->extract(odometry_, view_); }
  /// Returns what a place here stores; fails the test where that is refused.
  TopometricContent place() const {
    OrRefusal<TopometricContent> content = extract();
    EXPECT_TRUE(content) << content.error().reason << " " << content.error().measured;
    return content ? std::move(*content) : TopometricContent{};
  }
  Pose2 truth() const { return body_->site_from_robot(); }
  const Topometric& method() const { return *method_; }
  const Topometric::Odometry& odometry() const { return odometry_; }
  const View& view() const { return view_; }

 private:
  std::unique_ptr<sim::SimulatedBody> body_;
  std::unique_ptr<Topometric> method_;
  Topometric::Odometry odometry_;
  View view_;
};

}  // namespace weft::agents::test
