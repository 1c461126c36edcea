// The sites of deploy/sites/topometric.
#include <algorithm>
#include <tuple>

#include "agents/bodies/sim/hall/interior.hpp"
#include "tests/agents/bodies/sim/scenes.hpp"

namespace weft::agents::sim {
namespace {

const std::string kTopometric = std::string(WEFT_SITES) + "/topometric/";

std::vector<Eigen::Vector2d> topometric_line(const std::string& name) {
  return line_in(kTopometric, name + ".line");
}

const Box& nearest_box(const Site& site, const Eigen::Vector2d& p) {
  return *std::min_element(site.boxes.begin(), site.boxes.end(), [&](const Box& a, const Box& b) {
    return distance_to(a, p.x(), p.y()) < distance_to(b, p.x(), p.y());
  });
}

double heading_of_line(const std::vector<Eigen::Vector2d>& line) {
  return std::atan2(line[1].y() - line[0].y(), line[1].x() - line[0].x());
}

TEST(TopometricScenes, HaveLinesThatCanBeDrivenFromWhereRobotsStand) {
  const std::vector<std::tuple<std::string, std::string, std::string, double>> lines = {
      {"level11", "level11", "r1", 53.5},  {"hall", "hall", "r1", 34.0},      {"aisles", "aisles-r1", "r1", 40.0},
      {"aisles", "aisles-r2", "r2", 40.0}, {"fleet", "fleet-r1", "r1", 10.9}, {"fleet", "fleet-r2", "r2", 17.0},
      {"fleet", "fleet-r3", "r3", 5.5},    {"fleet", "fleet-r5", "r5", 5.5}};
  for (const auto& [site_name, line_name, robot, length_m] : lines) {
    const Site site = scene_in(kTopometric, site_name + ".toml");
    const std::vector<Eigen::Vector2d> line = topometric_line(line_name);
    expect_drivable(site, line, length_m, 0.85);
    const auto start = std::find_if(site.robots.begin(), site.robots.end(),
                                    [&name = robot](const RobotStart& one) { return one.name == name; });
    ASSERT_NE(start, site.robots.end()) << line_name;
    EXPECT_LT((start->site_from_robot.translation() - line.front()).norm(), 0.05) << line_name;
    EXPECT_LT(std::abs(wrap_angle(start->site_from_robot.heading - heading_of_line(line))), 0.1) << line_name;
  }
}

TEST(TopometricScenes, RobotsOfTheStudyHaveAPairAndNoEncoders) {
  for (const char* const name : {"level11.toml", "hall.toml", "aisles.toml"}) {
    const Site site = scene_in(kTopometric, name);
    EXPECT_FALSE(site.base.has_encoders) << name;
    for (const RobotStart& robot : site.robots) EXPECT_TRUE(robot.has_stereo && robot.looks.empty()) << name;
  }
}

TEST(TopometricScenes, Level11IsACorridorWithoutGaps) {
  const Site site = scene_in(kTopometric, "level11.toml");
  int wider = 0;
  for (double x = 2.0; x < 22.4; x += 0.1) {
    for (const double y : {0.9, 4.9}) {
      const double room = distance_to(nearest_box(site, {x, y}), x, y);
      EXPECT_GT(room, 0.9 - 1e-6) << x << ", " << y;
      EXPECT_LT(room, 1.1) << x << ", " << y;
      double across = 0.0;
      for (const double side : {-1.0, 1.0}) {
        double free_m = 0.0;
        while (free_m < 4.0 && distance_to(nearest_box(site, {x, y + side * free_m}), x, y + side * free_m) > 1e-6)
          free_m += 0.05;
        EXPECT_LT(free_m, 3.6) << x << ", " << y << ": a way out";
        across += free_m;
      }
      wider += across > 1.95 ? 1 : 0;
    }
  }
  EXPECT_GT(wider, 100) << "door niches and the lobby, along each 0.1 m of both corridors";
}

TEST(TopometricScenes, Level11IsPlainAtItsEndsAndOverFiveMetresOfEachCorridor) {
  const Site site = scene_in(kTopometric, "level11.toml");
  const auto plain_m = [&](double y, double from, double to) {
    double sum = 0.0;
    for (double x = from; x < to; x += 0.1) {
      const Box& below = nearest_box(site, {x, y - 0.9});
      const Box& above = nearest_box(site, {x, y + 0.9});
      sum += !below.has_signs && !above.has_signs ? 0.1 : 0.0;
      EXPECT_TRUE(below.contrast == 0.02 || below.contrast == 0.2) << below.name;
    }
    return sum;
  };
  EXPECT_NEAR(plain_m(0.9, 4.0, 20.0), 5.0, 0.2);
  EXPECT_NEAR(plain_m(4.9, 3.5, 20.0), 5.0, 0.2);
  for (const Eigen::Vector2d& p : topometric_line("level11")) {
    if (p.x() > 2.0 && p.x() < 22.4) continue;
    EXPECT_FALSE(nearest_box(site, p).has_signs) << p.transpose();
  }
}

TEST(TopometricScenes, InTheHallTheStraightWayIsFreeAndShort) {
  const Site site = scene_in(kTopometric, "hall.toml");
  const std::vector<Eigen::Vector2d> line = topometric_line("hall");
  EXPECT_LT((line.back() - line.front()).norm(), 0.4 * 34.0);
  for (const Eigen::Vector2d& p : points_along({line.front(), line.back()}))
    EXPECT_GT(distance_to(nearest_box(site, p), p.x(), p.y()), 0.8);
}

/// Returns loads and pallets in an aisle's racks, their middles moved to where the first aisle's are.
std::vector<Quad> stock_of_aisle(std::vector<Quad> quads, int aisle) {
  constexpr float half_m = 2.04F;
  const Eigen::Vector3f apart(0.0F, 4.1F * static_cast<float>(aisle), 0.0F);
  std::erase_if(quads, [&](const Quad& quad) {
    const bool is_stock = quad.stuff == Stuff::load || quad.stuff == Stuff::pallet;
    return !is_stock || std::abs((quad.at(0.5F, 0.5F) - apart).y() - 2.05F) > half_m;
  });
  for (Quad& quad : quads) quad.corner -= apart;
  return quads;
}

TEST(TopometricScenes, TheAislesAreAlike) {
  const std::vector<Quad> quads = interior_of(scene_in(kTopometric, "aisles.toml"));
  const std::vector<Quad> first = stock_of_aisle(quads, 0);
  EXPECT_GT(first.size(), 200U);
  for (int aisle = 1; aisle < 4; ++aisle) {
    const std::vector<Quad> other = stock_of_aisle(quads, aisle);
    ASSERT_EQ(other.size(), first.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
      EXPECT_NEAR((other[i].corner - first[i].corner).norm(), 0.0F, 1e-4F);
      EXPECT_EQ(other[i].pattern, first[i].pattern);
      EXPECT_EQ(other[i].grey, first[i].grey);
    }
  }
}

TEST(TopometricScenes, TheFleetSeesTheFloorOrAheadOrBoth) {
  const Site site = scene_in(kTopometric, "fleet.toml");
  ASSERT_EQ(site.robots.size(), 5U);
  for (const RobotStart& robot : site.robots) {
    const bool looks_down = robot.name == "r3" || robot.name == "r4" || robot.name == "r5";
    EXPECT_EQ(robot.has_stereo, robot.name != "r5");
    EXPECT_EQ(robot.looks, looks_down ? std::vector<Gaze>{Gaze::down} : std::vector<Gaze>{}) << robot.name;
  }
  ASSERT_EQ(site.obstacles.size(), 1U);
  const Obstacle& crate = site.obstacles.front();
  EXPECT_EQ(crate.from_day, 1U);
  const std::vector<Eigen::Vector2d> aisle = points_along(topometric_line("fleet-r1"));
  EXPECT_TRUE(std::any_of(aisle.begin(), aisle.end(), [&](const Eigen::Vector2d& p) {
    return (p - crate.site_from_obstacle.translation()).norm() < 0.2;
  })) << "in the way to the dock";
  const Eigen::Vector2d end = topometric_line("fleet-r1").back();
  EXPECT_LT((site.stations.front().site_from_station.translation() - end).norm(), 0.05) << "the dock";
}

}  // namespace
}  // namespace weft::agents::sim
