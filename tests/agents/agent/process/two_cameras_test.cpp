// Robots teach a part each by one method, one with both joins the parts, and one that was taught nothing drives from
// the first to the last: by one method, then by the other, without standing in between.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "agents/agent/process/equip.hpp"
#include "agents/bodies/sim/sim_body.hpp"
#include "tests/support/little_server.hpp"

namespace weft::agents::test {
namespace {

const std::string kFolder = std::string(WEFT_SITES) + "/two-cameras/";

std::vector<SitePoint> line_of(const std::string& name) {
  std::ifstream in(kFolder + name);
  std::vector<SitePoint> line;
  for (SitePoint point; in >> point.x >> point.y;) line.push_back(point);
  return line;
}

/// A robot of that site, and the map that all of them share.
class Robot {
 public:
  Robot(const std::string& name, const std::string& method, weft::test::LittleServer& map) : map_(map) {
    Options options;
    options.name = name;
    options.method = method;
    options.body = "sim";
    options.site = kFolder + "hall.toml";
    const auto warn = [](const std::string& text) { ADD_FAILURE() << text; };
    body_ = *make_body(options, warn);
    truth_ = dynamic_cast<sim::SimulatedBody*>(body_.get());
    navigator_ = *make_navigator(options, *make_cameras(options, *body_, warn));
    id_.bytes[0] = static_cast<std::uint8_t>(name.back());
  }

  Navigator& navigator() { return *navigator_; }
  Pose2 pose() const { return truth_->site_from_robot(); }
  double elapsed_s() const { return elapsed_s_; }

  Navigated step() {
    const Sample sample = *body_->step(command_);
    has_view_ = sample.view.has_value();
    hand_done_ = sample.hand_done;
    Navigated now = navigator_->step(has_view_ ? &*sample.view : nullptr, sample.frame, sample.time, sample.motion,
                                     sample.hand, map_.map());
    command_ = now.command;
    if (now.exposes) {
      EXPECT_TRUE(body_->expose(now.exposes->camera, now.exposes->exposure));
    }
    elapsed_s_ = seconds(sample.motion.elapsed);
    return now;
  }
  void look_around() {
    navigator_->seek(std::nullopt);
    for (int i = 0; i < 60 && !navigator_->estimate(); ++i) step();
  }
  /// Experiences `run`, and one more for each further method; true poses of what was kept go to `truth`.
  void be_taught(std::uint64_t run, const std::string& line, std::map<PlaceId, Pose2>& truth) {
    const std::vector<SitePoint> way = line_of(line);
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

/// Who teaches the way's two parts.
struct Teachers {
  std::string first, first_by, second, second_by;
};

class TwoCameras : public testing::TestWithParam<Teachers> {};

TEST_P(TwoCameras, HandOverWithoutStopping) {
  const Teachers& teachers = GetParam();
  weft::test::LittleServer map;
  std::map<PlaceId, Pose2> truth;
  {
    Robot first(teachers.first, teachers.first_by, map);
    first.be_taught(10, "first.line", truth);
    Robot second(teachers.second, teachers.second_by, map);
    second.be_taught(20, "second.line", truth);
    Robot both("r3", "floor,bearing", map);
    both.look_around();
    both.be_taught(30, "crossing.line", truth);
  }
  int changes = 0;
  for (const auto& [id, edge] : map.window().edges) {
    if (edge.method != "bearing+floor") continue;
    ++changes;
    const Pose2 truly = truth.at(id.a).inverse() * truth.at(id.b);
    EXPECT_LT((truly.inverse() * planar(edge.a_from_b)).translation().norm(), 0.02);
    EXPECT_EQ(map.window().place(id.a)->method, "floor");
    EXPECT_EQ(map.window().place(id.b)->method, "bearing");
  }
  EXPECT_GE(changes, 10);

  Robot stranger("r4", "floor,bearing", map);
  stranger.look_around();
  ASSERT_TRUE(stranger.navigator().estimate());
  const PlaceId from = stranger.navigator().estimate()->place;
  EXPECT_EQ(from.experience, ExperienceId{10});
  const PlaceId goal = std::prev(truth.lower_bound({ExperienceId{21}, 0}))->first;
  const std::vector<std::string> drives = stranger.navigator().drives();
  const Route route = map.route(from, goal, std::set<std::string>(drives.begin(), drives.end()));
  stranger.navigator().follow(route);
  Navigated now;
  std::vector<std::string> by;
  double slowest_m_s = 10.0;
  double begun_s = 0.0;
  Pose2 last = stranger.pose();
  for (int i = 0; i < 3000 && now.following != Following::arrived && now.following != Following::failed; ++i) {
    now = stranger.step();
    const std::string method(stranger.navigator().method());
    if (by.empty() || by.back() != method) by.push_back(method);
    // Between the first and the last metre, over half a second.
    begun_s += stranger.elapsed_s();
    if (begun_s < 0.5) continue;
    const Pose2 here = stranger.pose();
    const bool is_between = here.x > 2.7 && here.y < 7.0;
    if (is_between) slowest_m_s = std::min(slowest_m_s, (last.inverse() * here).translation().norm() / begun_s);
    last = here;
    begun_s = 0.0;
  }
  EXPECT_EQ(by, (std::vector<std::string>{teachers.first_by, teachers.second_by}));
  EXPECT_GT(slowest_m_s, 0.15) << "a bend may slow it where the ways meet; it does not stop for the change";
  EXPECT_EQ(now.following, Following::arrived) << now.reason;
  const Pose2 goal_from_robot = truth.at(goal).inverse() * stranger.pose();
  EXPECT_LT(goal_from_robot.translation().norm(), 0.15);
}

INSTANTIATE_TEST_SUITE_P(, TwoCameras,
                         testing::Values(Teachers{"r1", "floor", "r2", "bearing"},
                                         Teachers{"r4", "bearing", "r3", "floor"}),
                         [](const auto& each) { return each.param.first_by + "First"; });

}  // namespace
}  // namespace weft::agents::test
