// A robot with a camera that looks down is led through an aisle, turned round at its end and led back: what it keeps
// says at every metre where the other direction lies.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <vector>

#include "agents/agent/process/equip.hpp"
#include "agents/bodies/sim/sim_body.hpp"
#include "tests/support/little_server.hpp"

namespace weft::agents::test {
namespace {

/// Westwards through the second aisle, round at its end, and back on the same line.
std::vector<SitePoint> there_and_back(double east_m, double west_m) {
  constexpr double radius_m = 1.0;
  constexpr double step_m = 0.2;
  Pose2 at{east_m, 6.4, std::numbers::pi};
  std::vector<SitePoint> line = {{at.x, at.y}};
  const auto go = [&](double metres, double turn_rad) {
    const double steps = std::ceil(metres / step_m);
    for (double i = 0.0; i < steps; i += 1.0) {
      at = at * exp2({metres / steps, 0.0, turn_rad / steps});
      line.push_back({at.x, at.y});
    }
  };
  constexpr double sixth = std::numbers::pi / 3.0;
  go(east_m - west_m, 0.0);
  for (const double turn : {-sixth, 5.0 * sixth, -sixth}) go(radius_m * std::abs(turn), turn);
  go(east_m - west_m, 0.0);
  return line;
}

struct TaughtBack {
  std::map<PlaceId, Pose2> truth;
  std::vector<Edge> met;  ///< stitches to places that look the other way, in the order of the run
};

TaughtBack be_taught_along(const std::vector<SitePoint>& line) {
  const ExperienceId run{10};
  Options options;
  options.name = "r1";
  options.method = "floor";
  options.body = "sim";
  options.site = WEFT_SITE;
  const auto warn = [](const std::string& text) { ADD_FAILURE() << text; };
  const std::unique_ptr<Body> body = *make_body(options, warn);
  auto* const simulated = dynamic_cast<sim::SimulatedBody*>(body.get());
  const std::unique_ptr<Navigator> navigator = *make_navigator(options, *make_cameras(options, *body, warn));
  weft::test::LittleServer map;
  TaughtBack taught;
  const auto take = [&](const std::vector<Kept>& kept) {
    for (const Kept& one : kept) {
      taught.truth[one.place.id] = simulated->site_from_robot();
      map.take(run, RobotId{{1}}, one.place.method, {one});
      for (const Edge& edge : one.edges) {
        const bool turned = std::abs(wrap_angle(planar(edge.a_from_b).heading)) > 3.0 * std::numbers::pi / 4.0;
        if (edge.origin == Origin::stitch && turned) taught.met.push_back(edge);
      }
    }
  };
  simulated->put({line[0].x, line[0].y, std::atan2(line[1].y - line[0].y, line[1].x - line[0].x)}, {});
  EXPECT_TRUE(body->drive_by_hand(line));
  navigator->begin_teach({run, RobotId{{1}}, {}});
  for (bool done = false; !done;) {
    const Sample sample = *body->step({});
    done = sample.hand_done;
    const View* const view = sample.view ? &*sample.view : nullptr;
    take(navigator->step(view, sample.frame, sample.time, sample.motion, sample.hand, map.map()).kept);
  }
  return taught;
}

TEST(ThereAndBack, TheFloorShowsAtEveryMetreWhereTheOtherDirectionLies) {
  const TaughtBack taught = be_taught_along(there_and_back(10.0, 4.7));
  ASSERT_GE(taught.met.size(), 5U);
  EXPECT_LE(taught.met.size(), 10U);  // one in 0.6 m at most
  for (std::size_t i = 0; i < taught.met.size(); ++i) {
    const Edge& edge = taught.met[i];
    EXPECT_EQ(edge.drivable, Drivable::none);
    const Pose2 truly = taught.truth.at(edge.id.a).inverse() * taught.truth.at(edge.id.b);
    EXPECT_LT((truly.inverse() * planar(edge.a_from_b)).translation().norm(), 0.05);
    if (i == 0) continue;
    const Pose2& before = taught.truth.at(taught.met[i - 1].id.b);
    EXPECT_LE((taught.truth.at(edge.id.b).translation() - before.translation()).norm(), 1.0) << i;
  }
}

}  // namespace
}  // namespace weft::agents::test
