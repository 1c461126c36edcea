#include "agents/bodies/sim/solids.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "agents/bodies/sim/base.hpp"
#include "agents/bodies/sim/hall/movers.hpp"
#include "tests/agents/bodies/sim/sites.hpp"

namespace weft::agents::sim {
namespace {

/// Returns a hall in which nothing is off, with r1 at (4, 6) that looks ahead.
Site open_site() {
  Site site = empty_site();
  site.disturbances = no_disturbances();
  site.robots.front().looks = {Gaze::ahead};
  site.forward_camera.width = site.forward_camera.height = 64;
  site.forward_camera.focal_px = 60.0;
  site.forward_camera.exposes_itself = false;
  site.forward_camera.fps = 10.0;
  return site;
}

Base base_among(const Site& site) {
  return Base(site.base, site.disturbances, Solids(site), {}, site.robots.front().site_from_robot, Random(1));
}

Obstacle crate_at(double x, double y) {
  Obstacle crate;
  crate.name = "crate";
  crate.site_from_obstacle = {x, y, 0.0};
  return crate;
}

/// Describes a person who walks 1 m/s along y = 6 towards r1, from 4 m before it.
Mover walks_at_r1() {
  return {Mover::Kind::person, {{8.0, 6.0}, {2.0, 6.0}}, 1.0, 0.0};
}

double person_x(const Site& site, const Base& base, double time_s) {
  return pose_of(site.movers.front(), time_s - base.solids().waited_s().front()).x;
}

TEST(Solids, ARobotStopsAtACrateAndBacksOut) {
  Site site = open_site();
  site.obstacles.push_back(crate_at(6.0, 6.1));
  Base base = base_among(site);
  base.advance({0.5, 0.0}, 1.0);
  EXPECT_FALSE(base.take_touch());
  base.advance({0.5, 0.0}, 9.0);
  EXPECT_NEAR(base.site_from_robot().x, 6.0 - 0.3 - site.base.radius_m, 0.01);
  EXPECT_EQ(base.velocity().linear_m_s, 0.0);
  EXPECT_EQ(base.take_touch(), "crate");
  base.advance({-0.5, 0.0}, 3.0);
  base.take_touch();
  base.advance({-0.5, 0.0}, 1.0);
  EXPECT_FALSE(base.take_touch());
  EXPECT_LT(base.site_from_robot().x, 5.0);
}

TEST(Solids, AWallIsTouchedByItsName) {
  Site site = open_site();
  site.boxes.push_back({Box::Kind::wall, "north wall", {6.0, 6.0, M_PI / 2}, 4.0, 0.2, 3.0});
  Base base = base_among(site);
  base.advance({0.5, 0.0}, 10.0);
  EXPECT_EQ(base.take_touch(), "north wall");
}

TEST(Solids, AnObstacleIsThereInItsTimeOnly) {
  Site site = open_site();
  site.obstacles.push_back(crate_at(6.0, 6.0));
  site.obstacles.front().to_s = 8.0;
  Base base = base_among(site);
  base.advance({0.5, 0.0}, 7.9);
  EXPECT_LT(base.site_from_robot().x, 5.5);
  base.advance({0.5, 0.0}, 5.0);
  EXPECT_GT(base.site_from_robot().x, 7.0);
}

TEST(Solids, WhatComesOverARobotLetsItOut) {
  Site site = open_site();
  site.obstacles.push_back(crate_at(4.2, 6.0));
  site.obstacles.front().from_s = 1.0;
  Base base = base_among(site);
  base.advance({}, 0.9);
  EXPECT_FALSE(base.take_touch());
  base.advance({}, 0.2);
  EXPECT_EQ(base.take_touch(), "crate");
  base.advance({0.5, 0.0}, 2.0);
  EXPECT_NEAR(base.site_from_robot().x, 4.0, 0.01) << "no deeper in";
  base.advance({-0.5, 0.0}, 4.0);
  EXPECT_LT(base.site_from_robot().x, 3.0);
}

TEST(Solids, APersonStopsBeforeARobotAndGoesOnWhenItIsGone) {
  Site site = open_site();
  site.movers.push_back(walks_at_r1());
  Base base = base_among(site);
  base.advance({}, 20.0);
  EXPECT_FALSE(base.take_touch());
  EXPECT_NEAR(person_x(site, base, 20.0), 4.0 + site.base.radius_m + 0.3 + 0.2, 0.01);
  base.put({4.0, 9.0, 0.0}, {});
  base.advance({}, 2.0);
  EXPECT_LT(person_x(site, base, 22.0), 3.0);
}

TEST(Solids, ARudePersonWalksIntoTheRobot) {
  Site site = open_site();
  site.movers.push_back(walks_at_r1());
  site.movers.front().is_rude = true;
  site.movers.front().name = "Ada";
  Base base = base_among(site);
  base.advance({}, 3.4);
  EXPECT_FALSE(base.take_touch());
  base.advance({}, 0.6);
  EXPECT_EQ(base.take_touch(), "Ada");
  EXPECT_EQ(base.solids().waited_s().front(), 0.0);
}

TEST(Solids, ARobotRunsIntoAPersonWhoWaits) {
  Site site = open_site();
  site.movers.push_back(walks_at_r1());
  Base base = base_among(site);
  base.advance({}, 10.0);
  base.advance({0.3, 0.0}, 5.0);
  EXPECT_EQ(base.take_touch(), "mover");
  EXPECT_NEAR(base.site_from_robot().x, 4.3, 0.02);
}

TEST(Solids, WhatIsNotSolidIsNotInTheWay) {
  Site site = open_site();
  site.movers.push_back(walks_at_r1());
  site.movers.front().is_solid = false;
  Base base = base_among(site);
  base.advance({0.5, 0.0}, 4.0);
  EXPECT_FALSE(base.take_touch());
  EXPECT_EQ(base.solids().waited_s().front(), 0.0);
  EXPECT_GT(base.site_from_robot().x, 5.5);
}

TEST(Solids, ARobotPassesUnderRaisedForksAlone) {
  Site site = open_site();
  // It stands beside the way, its forks over it.
  site.movers.push_back({Mover::Kind::forklift, {{7.0, 4.6}, {7.0, 9.0}}, 0.0, 0.0});
  for (const double forks_m : {0.15, 0.49, 0.8}) {
    site.movers.front().forks_m = forks_m;
    Base base = base_among(site);
    base.advance({0.5, 0.0}, 12.0);
    EXPECT_EQ(base.take_touch().has_value(), forks_m < site.base.body_height_m) << forks_m;
    EXPECT_EQ(base.site_from_robot().x > 8.0, forks_m > site.base.body_height_m) << forks_m;
  }
}

TEST(Solids, ATouchIsInTheTruth) {
  const auto path = std::filesystem::temp_directory_path() / "weft-sim-touch-test.jsonl";
  std::filesystem::remove(path);
  Site site = open_site();
  site.obstacles.push_back(crate_at(5.0, 6.0));
  site.obstacles.front().name = "a \"crate\"";
  SimBodyConfig config = config_of(site);
  config.truth_path = path.string();
  auto body = body_of(config);
  ASSERT_TRUE(body);
  for (int i = 0; i < 40; ++i) ASSERT_TRUE(body->step({0.5, 0.0}));
  std::ifstream file(path);
  int touched = 0;
  std::size_t rows = 0;
  for (std::string line; std::getline(file, line); ++rows) {
    const auto row = nlohmann::json::parse(line);
    EXPECT_EQ(row.size(), row.contains("touch") ? 7U : 6U);
    if (!row.contains("touch")) continue;
    EXPECT_EQ(row["touch"], "a \"crate\"");
    ++touched;
  }
  EXPECT_EQ(rows, 40U);
  EXPECT_GT(touched, 10);
  EXPECT_LT(touched, 35);
  std::filesystem::remove(path);
}

/// Returns r1's images while it stands; the body's time of each is half a second later.
std::vector<Bytes> seen_at_rest(const Site& site, std::size_t count, std::uint64_t day = 0) {
  auto body = body_of(config_of(site, "r1", 1, day));
  EXPECT_TRUE(body);
  std::vector<Bytes> seen;
  while (body && seen.size() < count) {
    const auto sample = body->step({});
    EXPECT_TRUE(sample);
    seen.push_back(*std::get<Image>(sample->views.front().data).pixels);
  }
  return seen;
}

TEST(Solids, AnObstacleIsSeenWhileItStands) {
  const std::vector<Bytes> open = seen_at_rest(open_site(), 6);
  EXPECT_EQ(open[0], open[5]) << "nothing changes by itself";
  for (const Obstacle::Kind kind : {Obstacle::Kind::crate, Obstacle::Kind::person, Obstacle::Kind::pallet_jack}) {
    Site site = open_site();
    site.obstacles.push_back(crate_at(6.0, 6.0));
    site.obstacles.front().kind = kind;
    site.obstacles.front().from_s = 0.9;
    site.obstacles.front().to_s = 2.1;
    const std::vector<Bytes> seen = seen_at_rest(site, 6);
    EXPECT_EQ(seen[0], open[0]);
    EXPECT_NE(seen[2], open[0]);
    EXPECT_EQ(seen[5], open[0]);
  }
}

TEST(Solids, AnObstacleIsThereFromItsDayOn) {
  Site site = open_site();
  site.obstacles.push_back(crate_at(6.0, 6.0));
  site.obstacles.front().from_day = 1;
  EXPECT_EQ(seen_at_rest(site, 1).front(), seen_at_rest(open_site(), 1).front());
  EXPECT_NE(seen_at_rest(site, 1, 1).front(), seen_at_rest(open_site(), 1, 1).front());
}

TEST(Solids, WhoWaitsIsSeenWaiting) {
  Site site = open_site();
  site.movers.push_back(walks_at_r1());
  const std::vector<Bytes> seen = seen_at_rest(site, 16);
  EXPECT_NE(seen[2], seen[4]) << "walks up to the robot";
  EXPECT_EQ(seen[10], seen[15]) << "and stands before it";
}

}  // namespace
}  // namespace weft::agents::sim
