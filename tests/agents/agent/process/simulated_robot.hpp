#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "agents/agent/process/equip.hpp"
#include "agents/bodies/sim/sim_body.hpp"
#include "tests/agents/agent/process/programs.hpp"
#include "tests/support/little_server.hpp"

namespace weft::agents::test {

/// Holds a robot of a simulated site with what its agent navigates by, and the map that all of them share.
class SimulatedRobot {
 public:
  SimulatedRobot(const std::string& site, const std::string& name, const std::vector<std::string>& methods,
                 weft::test::LittleServer& map)
      : map_(map) {
    Options options;
    options.name = name;
    options.methods = methods;
    options.body = "sim";
    options.site = site;
    const auto warn = [](const std::string& text) { ADD_FAILURE() << text; };
    body_ = *make_body(kSimulator, options, warn);
    truth_ = dynamic_cast<sim::SimulatedBody*>(body_.get());
    navigator_ = *make_navigator(options, *equip(options, *body_, warn), body_->rig());
    id_.bytes[0] = static_cast<std::uint8_t>(name.back());
  }

  Navigator& navigator() { return *navigator_; }
  Pose2 pose() const { return truth_->site_from_robot(); }
  double elapsed_s() const { return elapsed_s_; }

  Navigated step() {
    const Sample sample = *body_->step(command_);
    has_view_ = !sample.views.empty();
    hand_done_ = sample.hand_done;
    Navigated now = navigator_->step(sample, map_.map());
    command_ = now.command;
    if (now.exposes) {
      EXPECT_TRUE(body_->expose(now.exposes->sensor, now.exposes->exposure));
    }
    elapsed_s_ = seconds(sample.motion.elapsed);
    return now;
  }
  void look_around() {
    navigator_->seek(std::nullopt);
    for (int i = 0; i < 60 && !navigator_->estimate(); ++i) step();
  }
  /// Adds experience `run`, and one more for each further method; true poses of what was kept go to `truth`.
  void be_taught(std::uint64_t run, const std::vector<SitePoint>& way, std::map<PlaceId, Pose2>& truth) {
    truth_->put({way[0].x, way[0].y, std::atan2(way[1].y - way[0].y, way[1].x - way[0].x)}, {});
    const auto led = body_->drive_by_hand(way);
    ASSERT_TRUE(led) << led.error().message;
    navigator_->begin_teach({ExperienceId{run}, id_, {ExperienceId{run + 1}}});
    for (bool done = false; !done; done = hand_done_ && has_view_) take(step().kept, truth);
    take(navigator_->end_teach(map_.map()), truth);
  }

 private:
  void take(const std::vector<Kept>& kept, std::map<PlaceId, Pose2>& truth) {
    for (const Kept& one : kept) {
      truth[one.place.id] = pose();
      map_.take(one.place.id.experience, id_, one.place.method, {one});
    }
  }

  weft::test::LittleServer& map_;
  std::unique_ptr<Body> body_;
  sim::SimulatedBody* truth_ = nullptr;
  std::unique_ptr<Navigator> navigator_;
  RobotId id_;
  Twist command_;
  bool has_view_ = false;
  bool hand_done_ = false;
  double elapsed_s_ = 0.0;
};

}  // namespace weft::agents::test
