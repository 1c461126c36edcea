// A route over what two robots were taught, driven by a third one: bearings all along.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "clients/evaluate/bearing/course.hpp"
#include "clients/evaluate/bearing/trials.hpp"

namespace weft::evaluate::bearing {
namespace {

using namespace agents;

/// Holds a robot in the hall of the lemniscate, and the map that all of them share.
class Robot {
 public:
  Robot(const sim::Site& site, std::uint64_t seed, TaughtMap& map) : map_(map) {
    sim::SimBodyConfig config;
    config.site = site;
    config.robot = "r1";
    config.seed = seed;
    config.day = seed;
    body_ = *sim::make_sim_body(config);
    navigator_ = *make_navigator(body_->rig().camera(), Parts::all);
  }

  sim::SimulatedBody& body() { return *body_; }
  Navigator& navigator() { return *navigator_; }

  Navigated step() {
    const Sample sample = *body_->step(command_);
    has_view_ = !sample.views.empty();
    hand_done_ = sample.hand_done;
    Navigated now = navigator_->step(sample, map_.view());
    command_ = now.command;
    expose(*body_, now);
    return now;
  }
  bool finds_itself() {
    navigator_->seek(std::nullopt);
    for (int i = 0; i < 60 && !navigator_->estimate(); ++i) step();
    return navigator_->estimate().has_value();
  }
  /// Teaches a run along the line. True poses of what was kept go to `truth`.
  void be_taught(ExperienceId run, const std::vector<SitePoint>& line, std::map<PlaceId, Pose2>& truth) {
    ASSERT_TRUE(body_->drive_by_hand(line));
    navigator_->begin_teach({run, {{static_cast<std::uint8_t>(run.value)}}});
    const auto take = [&](const std::vector<Kept>& kept) {
      for (const Kept& one : kept) truth[one.place.id] = body_->site_from_robot();
      ASSERT_TRUE(map_.take(run, {{static_cast<std::uint8_t>(run.value)}}, Bearing::name, kept));
    };
    for (bool done = false; !done; done = hand_done_ && has_view_) take(step().kept);
    take(navigator_->end_teach(map_.view()));
  }

 private:
  TaughtMap& map_;
  std::unique_ptr<sim::SimulatedBody> body_;
  std::unique_ptr<Navigator> navigator_;
  Twist command_;
  bool has_view_ = false;
  bool hand_done_ = false;
};

Pose2 pose_on(const std::vector<SitePoint>& line, std::size_t at) {
  return {line[at].x, line[at].y, std::atan2(line[at + 1].y - line[at].y, line[at + 1].x - line[at].x)};
}

std::vector<Edge> stitches_of(const TaughtMap& map) {
  std::vector<Edge> stitches;
  for (const auto& [id, edge] : map.view().window.edges) {
    if (edge.origin == Origin::stitch) stitches.push_back(edge);
  }
  return stitches;
}

TEST(BearingRuns, ARouteLeadsOverWhatTwoRobotsWereTaught) {
  const Result<Scene> scene = read_scene(std::filesystem::path(WEFT_SITES) / "bearing", "lemniscate", "lemniscate");
  ASSERT_TRUE(scene);
  const std::vector<SitePoint>& line = scene->line;  // a point each 0.1 m
  TaughtMap map;
  std::map<PlaceId, Pose2> truth;
  Robot first(scene->site, 1, map);
  first.be_taught({1}, {line.begin(), line.begin() + 90}, truth);

  Robot second(scene->site, 2, map);
  second.body().put(pose_on(line, 65), {});
  ASSERT_TRUE(second.finds_itself());
  second.be_taught({2}, {line.begin() + 65, line.begin() + 130}, truth);

  const std::vector<Edge> stitches = stitches_of(map);
  ASSERT_FALSE(stitches.empty());
  for (const Edge& stitch : stitches) {
    const Pose2 truly = truth.at(stitch.id.a).inverse() * truth.at(stitch.id.b);
    const auto& said = std::get<AlongPath>(stitch.a_from_b);
    EXPECT_NEAR(said.distance_m, truly.x, std::max(0.1, 4.0 * std::sqrt(said.distance_variance_m2)));
    EXPECT_NEAR(said.heading_shift_rad, truly.heading, 0.06);
  }

  Robot third(scene->site, 3, map);
  third.body().put(pose_on(line, 10) * Pose2{0.0, 0.2, 0.0}, {});
  ASSERT_TRUE(third.finds_itself());
  const PlaceId goal = truth.rbegin()->first;
  EXPECT_EQ(goal.experience, ExperienceId{2});
  const Result<Route> route = map.route(third.navigator().estimate()->place, goal, Bearing::name);
  ASSERT_TRUE(route) << route.error().message;
  EXPECT_EQ(route->places.front().experience, ExperienceId{1});
  third.navigator().follow(*route);
  Navigated now;
  for (int i = 0; i < 800 && now.following != Following::arrived && now.following != Following::failed; ++i)
    now = third.step();
  EXPECT_EQ(now.following, Following::arrived) << now.reason;
  const Pose2 goal_from_robot = truth.at(goal).inverse() * third.body().site_from_robot();
  EXPECT_LT(goal_from_robot.translation().norm(), 0.12);
  EXPECT_LT(std::abs(goal_from_robot.heading), 0.05);
}

}  // namespace
}  // namespace weft::evaluate::bearing
