#include "agents/bodies/sim/hand.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "agents/bodies/sim/base.hpp"
#include "sites.hpp"

namespace weft::agents::sim {
namespace {

using testing::HasSubstr;

double distance_to_line(const std::vector<SitePoint>& line, const Pose2& robot) {
  double best = 1e9;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector2d a(line[i - 1].x, line[i - 1].y);
    const Eigen::Vector2d b(line[i].x, line[i].y);
    const Eigen::Vector2d p = robot.translation();
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    best = std::min(best, (a + t * (b - a) - p).norm());
  }
  return best;
}

/// Returns a stadium: two straights of 6 m and two half circles of 0.9 m radius.
std::vector<SitePoint> stadium() {
  std::vector<SitePoint> line = {{4.0, 6.0}, {10.0, 6.0}};
  for (int i = 0; i <= 16; ++i) {
    const double a = -M_PI / 2 + M_PI * i / 16;
    line.push_back({10.0 + 0.9 * std::cos(a), 6.9 + 0.9 * std::sin(a)});
  }
  for (int i = 0; i <= 16; ++i) {
    const double a = M_PI / 2 + M_PI * i / 16;
    line.push_back({4.0 + 0.9 * std::cos(a), 6.9 + 0.9 * std::sin(a)});
  }
  line.push_back({5.0, 6.0});
  return line;
}

struct Drive {
  double worst_m = 0.0, duration_s = 0.0, length_m = 0.0;
  double slowest = 1e9, fastest = 0.0;  ///< m/s on the way, away from both ends
  Pose2 end;
};

Drive drive(const std::vector<SitePoint>& line, const Site& site, std::uint64_t seed) {
  auto hand = Hand::along(line, site, site.robots[0].site_from_robot, Random(seed));
  EXPECT_TRUE(hand) << hand.error().message;
  Base base(site.base, site.disturbances, Solids(site), {}, site.robots[0].site_from_robot, Random(seed));
  Drive done;
  while (!(hand->at_end() && base.at_rest()) && done.duration_s < 120.0) {
    const Pose2 before = base.site_from_robot();
    base.advance(hand->command(before, done.duration_s), 1.0 / 30);
    done.duration_s += 1.0 / 30;
    done.length_m += (base.site_from_robot().translation() - before.translation()).norm();
    done.worst_m = std::max(done.worst_m, distance_to_line(line, base.site_from_robot()));
    if (done.length_m > 1.0 && done.length_m < 15.0) {
      done.slowest = std::min(done.slowest, base.velocity().linear_m_s);
      done.fastest = std::max(done.fastest, base.velocity().linear_m_s);
    }
  }
  done.end = base.site_from_robot();
  return done;
}

TEST(Hand, LeadsAlongTheLineClumsily) {
  const Site site = empty_site();
  const auto line = stadium();
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Drive done = drive(line, site, seed);
    EXPECT_LT(done.duration_s, 119.0);
    EXPECT_LT(done.worst_m, 0.15) << seed;
    EXPECT_GT(done.worst_m, 0.01) << "nobody leads this well";
    EXPECT_NEAR(std::hypot(done.end.x - 5.0, done.end.y - 6.0), 0.0, 0.15);
    EXPECT_GT(done.fastest - done.slowest, 0.05);
    EXPECT_GT(done.slowest, 0.3);
    EXPECT_LT(done.fastest, 0.75);
  }
}

TEST(Hand, TurnsTheRobotToTheLineFirst) {
  Site site = empty_site();
  site.robots[0].site_from_robot.heading = 2.8;
  EXPECT_LT(drive({{4.0, 6.0}, {8.0, 6.0}}, site, 1).worst_m, 0.15);
}

TEST(Hand, RefusesALineOfOnePoint) {
  const Site site = empty_site();
  const auto hand = Hand::along({{4.0, 6.0}}, site, site.robots[0].site_from_robot, Random(1));
  ASSERT_FALSE(hand);
  EXPECT_EQ(hand.error().code, ErrorCode::invalid);
  EXPECT_THAT(hand.error().message, HasSubstr("at least 2"));
}

TEST(Hand, RefusesALineThatStartsFarAway) {
  const Site site = empty_site();
  const auto hand = Hand::along({{9.0, 6.0}, {12.0, 6.0}}, site, site.robots[0].site_from_robot, Random(1));
  ASSERT_FALSE(hand);
  EXPECT_THAT(hand.error().message, HasSubstr("5.00 m from where the robot stands"));
}

TEST(Hand, RefusesALineThroughARackAndNamesIt) {
  Site site = empty_site();
  site.boxes.push_back({Box::Kind::rack, "rack 7", {8.0, 6.0, 0.3}, 2.0, 1.0, 3.0});
  const auto hand = Hand::along({{4.0, 6.0}, {12.0, 6.0}}, site, site.robots[0].site_from_robot, Random(1));
  ASSERT_FALSE(hand);
  EXPECT_THAT(hand.error().message, HasSubstr("rack 7"));
}

TEST(Hand, RefusesPointsThatAreNotFinite) {
  const Site site = empty_site();
  const auto hand = Hand::along({{4.0, 6.0}, {NAN, 6.0}}, site, site.robots[0].site_from_robot, Random(1));
  ASSERT_FALSE(hand);
  EXPECT_THAT(hand.error().message, HasSubstr("not finite"));
}

}  // namespace
}  // namespace weft::agents::sim
