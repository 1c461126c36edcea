#include "agents/bodies/sim/site.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "agents/bodies/sim/base.hpp"

namespace weft::agents::sim {
namespace {

using testing::HasSubstr;

constexpr const char* kSmall = R"(
name = "small"
[floor]
x_min = 0
y_min = 0
x_max = 5
y_max = 4
[[robot]]
name = "r1"
x = 1
y = 2
heading_deg = 90
)";

std::string text_of(const std::string& path) {
  const std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<Eigen::Vector2d> line_of(const std::string& name) {
  std::vector<Eigen::Vector2d> line;
  std::istringstream rows(text_of(std::string(WEFT_SITES) + "/demo/" + name));
  for (std::string row; std::getline(rows, row);) {
    std::istringstream numbers(row.substr(0, row.find('#')));
    Eigen::Vector2d p;
    if (numbers >> p.x() >> p.y()) {
      line.push_back(p);
    }
  }
  return line;
}

double length_of(const std::vector<Eigen::Vector2d>& line) {
  double sum = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    sum += (line[i] - line[i - 1]).norm();
  }
  return sum;
}

/// Returns points every 5 cm along the line, each with its heading.
std::vector<Pose2> walk(const std::vector<Eigen::Vector2d>& line) {
  std::vector<Pose2> poses;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector2d way = line[i] - line[i - 1];
    for (double s = 0.0; s < way.norm(); s += 0.05) {
      const Eigen::Vector2d p = line[i - 1] + way.normalized() * s;
      poses.push_back({p.x(), p.y(), std::atan2(way.y(), way.x())});
    }
  }
  return poses;
}

double distance_between(const Pose2& a, const Pose2& b) {
  return (a.translation() - b.translation()).norm();
}

Site demo() {
  const std::string path = std::string(WEFT_SITES) + "/demo.toml";
  auto site = parse_site(text_of(path), path);
  EXPECT_TRUE(site) << site.error().message;
  return site ? *site : Site{};
}

TEST(Site, DefaultsAreTheLeastThatADemonstrationStands) {
  const auto site = parse_site(kSmall, "small.toml");
  ASSERT_TRUE(site) << site.error().message;
  EXPECT_EQ(site->robots[0].name, "r1");
  EXPECT_NEAR(site->robots[0].site_from_robot.heading, M_PI / 2, 1e-12);
  const Disturbances& d = site->disturbances;
  EXPECT_NEAR(d.focal_error, 0.003, 1e-12);
  EXPECT_NEAR(d.mount_error_m, 0.003, 1e-12);
  EXPECT_NEAR(d.mount_error_rad, 0.3 * M_PI / 180, 1e-12);
  EXPECT_NEAR(d.vibration_rad, 0.05 * M_PI / 180, 1e-12);
  EXPECT_NEAR(d.vibration_m, 0.001, 1e-12);
  EXPECT_NEAR(d.exposure_s, 0.005, 1e-12);
  EXPECT_NEAR(d.noise_grey, 2.0, 1e-12);
  EXPECT_NEAR(d.vignetting, 0.2, 1e-12);
  EXPECT_NEAR(d.exposure_drift, 0.2, 1e-12);
  EXPECT_NEAR(d.dropped_frames, 0.005, 1e-12);
  EXPECT_NEAR(d.time_jitter_s, 0.001, 1e-12);
  EXPECT_NEAR(d.wheel_scale_error, 0.03, 1e-12);
  EXPECT_NEAR(d.wheel_asymmetry, 0.02, 1e-12);
}

TEST(Site, EachDisturbanceCanBeSet) {
  const auto site =
      parse_site(std::string(kSmall) + "[disturbances]\nnoise_grey = 0\nfocal_error_percent = 1\n", "f");
  ASSERT_TRUE(site);
  EXPECT_EQ(site->disturbances.noise_grey, 0.0);
  EXPECT_NEAR(site->disturbances.focal_error, 0.01, 1e-12);
}

TEST(Site, IsNoHarderThanItSays) {
  const auto easy = parse_site(kSmall, "f");
  ASSERT_TRUE(easy);
  EXPECT_EQ(easy->disturbances.unevenness_m, 0.0);
  EXPECT_EQ(easy->disturbances.rolling_shutter_s, 0.0);
  EXPECT_EQ(easy->disturbances.time_offset_s, 0.0);
  const auto hard = parse_site(
      std::string(kSmall) + "[disturbances]\nunevenness_mm = 2\nrolling_shutter_ms = 20\ntime_offset_ms = -10\n",
      "f");
  ASSERT_TRUE(hard) << hard.error().message;
  EXPECT_NEAR(hard->disturbances.unevenness_m, 0.002, 1e-12);
  EXPECT_NEAR(hard->disturbances.rolling_shutter_s, 0.02, 1e-12);
  EXPECT_NEAR(hard->disturbances.time_offset_s, -0.01, 1e-12);
}

TEST(Site, IsNoHarderThanItCanBe) {
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"unevenness_mm = 10.1", "10"},   {"unevenness_mm = -1", "0"},     {"rolling_shutter_ms = 61", "60"},
      {"rolling_shutter_ms = -1", "0"}, {"time_offset_ms = 101", "100"}, {"time_offset_ms = -101", "-100"},
  };
  for (const auto& [line, bound] : wrong) {
    const auto site = parse_site(std::string(kSmall) + "[disturbances]\n" + line + "\n", "small.toml");
    ASSERT_FALSE(site) << line;
    EXPECT_THAT(site.error().message, HasSubstr("small.toml:14"));
    EXPECT_THAT(site.error().message, HasSubstr("disturbances." + line.substr(0, line.find(' '))));
    EXPECT_THAT(site.error().message, HasSubstr(bound));
  }
}

TEST(Site, AnUnknownKeyIsNamedWithItsLine) {
  const auto site = parse_site(std::string(kSmall) + "[disturbances]\nnoise_gray = 0\n", "small.toml");
  ASSERT_FALSE(site);
  EXPECT_EQ(site.error().code, ErrorCode::invalid);
  EXPECT_THAT(site.error().message, HasSubstr("small.toml:14"));
  EXPECT_THAT(site.error().message, HasSubstr("noise_gray"));
}

TEST(Site, AValueOutOfBoundsIsNamedWithItsBound) {
  const auto site = parse_site(std::string(kSmall) + "[camera]\nfocal_px = 5\n", "small.toml");
  ASSERT_FALSE(site);
  EXPECT_THAT(site.error().message, HasSubstr("small.toml:14"));
  EXPECT_THAT(site.error().message, HasSubstr("focal_px"));
  EXPECT_THAT(site.error().message, HasSubstr("50"));
}

TEST(Site, EveryMistakeIsReportedAtOnce) {
  const auto site =
      parse_site("[floor]\nx_min = 0\ny_min = 0\nx_max = -1\ny_max = 4\nmaterial = \"snow\"\n", "f.toml");
  ASSERT_FALSE(site);
  EXPECT_THAT(site.error().message, HasSubstr("x_max"));
  EXPECT_THAT(site.error().message, HasSubstr("material"));
  EXPECT_THAT(site.error().message, HasSubstr("robot"));
}

TEST(Site, NothingHasChangedUnlessItIsSaid) {
  const auto site = parse_site(kSmall, "small.toml");
  ASSERT_TRUE(site);
  Change change = site->change;
  EXPECT_NEAR(change.lens_depth, Change{}.lens_depth, 1e-12);
  change.lens_depth = Change{}.lens_depth;
  EXPECT_TRUE(change == Change{});
}

TEST(Site, WhatHasChangedIsSaidByNameAndByKey) {
  const auto site = parse_site(std::string(kSmall) + R"(
[[lamp]]
x = 1
y = 1
[change]
from_day = 1
light = "glare"
wear = "dirt"
glare_grey = 90
light_percent = 50
[[change.shadow]]
x = 2
y = 3
heading_deg = 90
travel_m = 3
[[change.wet]]
x = 1
y = 2
[[change.line]]
from = [0, 1]
to = [4, 1]
warmth = 0
)",
                               "f.toml");
  ASSERT_TRUE(site) << site.error().message;
  const Change& change = site->change;
  EXPECT_EQ(change.from_day, 1U);
  EXPECT_EQ(change.glare_grey, 90.0);
  EXPECT_EQ(change.light, 0.5);
  EXPECT_GT(change.dirt_per_m2, 0.0);
  ASSERT_EQ(change.shadows.size(), 1U);
  EXPECT_NEAR(change.shadows[0].site_from_shadow.heading, M_PI / 2, 1e-12);
  EXPECT_EQ(change.wet.size(), 1U);
  ASSERT_EQ(change.lines.size(), 1U);
  EXPECT_EQ(change.lines[0].x1, 4.0);
}

TEST(Site, AChangeOutOfBoundsIsNamed) {
  const auto site = parse_site(std::string(kSmall) +
                                   "[change]\nlight = \"glare\"\nlight_warmth = 2\nsinks_mm = "
                                   "101\n[[change.line]]\nfrom = [0, 0]\nto = [0, 0]\n",
                               "f.toml");
  ASSERT_FALSE(site);
  EXPECT_THAT(site.error().message, HasSubstr("light_warmth"));
  EXPECT_THAT(site.error().message, HasSubstr("sinks_mm"));
  EXPECT_THAT(site.error().message, HasSubstr("no [[lamp]]"));
  EXPECT_THAT(site.error().message, HasSubstr("0.1 m from `from`"));
}

TEST(Site, ARobotInARackIsRefused) {
  const auto site =
      parse_site(std::string(kSmall) + "[[rack]]\nname = \"A\"\nx = 1\ny = 2\nlength_m = 2\n", "small.toml");
  ASSERT_FALSE(site);
  EXPECT_THAT(site.error().message, HasSubstr("would stand in A"));
}

TEST(Site, TextThatIsNoTomlIsRefused) {
  EXPECT_FALSE(parse_site("[floor", "f.toml"));
}

TEST(DemoSite, IsLargeEnough) {
  const Site site = demo();
  EXPECT_GE(site.floor.x_max - site.floor.x_min, 20.0);
  EXPECT_GE(site.floor.y_max - site.floor.y_min, 12.0);
  EXPECT_EQ(site.robots.size(), 3U);
}

TEST(DemoSite, LinesAreLongClearAndDriveable) {
  const Site site = demo();
  for (const char* name : {"r1.line", "r2.line"}) {
    const auto line = line_of(name);
    EXPECT_GE(length_of(line), 30.0) << name;
    const auto poses = walk(line);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      for (const Box& box : site.boxes) {
        EXPECT_GE(distance_to(box, poses[i].x, poses[i].y), 0.8) << name << " and " << box.name;
      }
      // Over 0.35 m of a bend of 0.7 m radius the heading turns by 0.5 rad.
      if (i + 7 < poses.size()) {
        EXPECT_LT(std::abs(wrap_angle(poses[i + 7].heading - poses[i].heading)), 0.6) << name;
      }
    }
  }
}

TEST(DemoSite, LinesCloseOverMoreThanAMetre) {
  for (const char* name : {"r1.line", "r2.line"}) {
    const auto poses = walk(line_of(name));
    int again = 0;
    for (std::size_t late = poses.size() / 2; late < poses.size(); ++late) {
      for (std::size_t early = 0; early < poses.size() / 4; ++early) {
        if (distance_between(poses[late], poses[early]) < 0.06 &&
            std::abs(wrap_angle(poses[late].heading - poses[early].heading)) < 0.1) {
          ++again;
          break;
        }
      }
    }
    EXPECT_GT(again * 0.05, 1.0) << name;
  }
}

TEST(DemoSite, LinesOverlapInOneDirection) {
  const auto r1 = walk(line_of("r1.line"));
  const auto r2 = walk(line_of("r2.line"));
  std::vector<Pose2> shared;
  for (const Pose2& a : r1) {
    for (const Pose2& b : r2) {
      if (distance_between(a, b) <= 0.15 && std::abs(wrap_angle(a.heading - b.heading)) < 0.05) {
        shared.push_back(a);
        break;
      }
    }
  }
  double least = 1e9;
  double most = -1e9;
  for (const Pose2& pose : shared) {
    least = std::min(least, pose.x);
    most = std::max(most, pose.x);
  }
  EXPECT_GE(most - least, 6.0);
}

TEST(DemoSite, LinesCross) {
  int crossings = 0;
  const auto r2 = walk(line_of("r2.line"));
  for (const Pose2& a : walk(line_of("r1.line"))) {
    crossings += std::any_of(r2.begin(), r2.end(), [&](const Pose2& b) {
      const double turned = std::abs(wrap_angle(a.heading - b.heading));
      return distance_between(a, b) < 0.05 && std::abs(turned - M_PI / 2) < 0.2;
    });
  }
  EXPECT_GT(crossings, 1);
}

TEST(DemoSite, RobotsStartWhereTheStoryNeedsThem) {
  const Site site = demo();
  const auto r1 = walk(line_of("r1.line"));
  const Pose2 r1_start = site.robots[0].site_from_robot;
  EXPECT_LT(distance_between(r1_start, r1.front()), 0.05);
  EXPECT_LE(distance_between(site.robots[1].site_from_robot, r1_start), 0.2);
  double nearest = 1e9;
  double turned = 0.0;
  const Pose2 r3 = site.robots[2].site_from_robot;
  for (const Pose2& pose : r1) {
    if (distance_between(pose, r3) < nearest) {
      nearest = distance_between(pose, r3);
      turned = std::abs(wrap_angle(pose.heading - r3.heading));
    }
  }
  EXPECT_LE(nearest, 0.3);
  EXPECT_GT(nearest, 0.1);
  EXPECT_LE(turned, 20.0 * M_PI / 180);
  EXPECT_GT(turned, 5.0 * M_PI / 180);
}

TEST(DemoSite, RestingRobotsStandInNobodysWay) {
  const auto r1 = walk(line_of("r1.line"));
  const auto r2 = walk(line_of("r2.line"));
  for (const Pose2& pose : r2) {
    EXPECT_GT(distance_between(pose, r1.back()), 1.0);
  }
  for (const Pose2& pose : r1) {
    EXPECT_GT(distance_between(pose, r2.back()), 1.0);
  }
  const Site site = demo();
  for (const Station& station : site.stations) {
    if (station.name == "packing-3") {
      EXPECT_GT(distance_between(station.site_from_station, r2.back()), 2.0);
    }
  }
}

TEST(Site, WhatTheForwardCameraSees) {
  const auto site = parse_site(std::string(kSmall) + R"(
looks = ["ahead"]
[forward_camera]
width_px = 640
height_px = 480
focal_px = 772
headlight = 3
exposes_itself = false
[hall]
ceiling_m = 9
[[person]]
way = [0.5, 0.5, 4.0, 0.5]
[[forklift]]
way = [0.5, 3.0, 4.0, 3.0, 4.0, 1.0]
speed_m_s = 2
begins_m = 1.5
[change]
stock_percent = 30
stock_times = 4
lamps_failed_percent = 50
ambient_percent = 3
)",
                               "small.toml");
  ASSERT_TRUE(site) << site.error().message;
  EXPECT_EQ(site->robots.front().looks, std::vector<Gaze>{Gaze::ahead});
  EXPECT_EQ(site->forward_camera.width, 640);
  EXPECT_EQ(site->forward_camera.headlight, 3.0);
  EXPECT_FALSE(site->forward_camera.exposes_itself);
  EXPECT_EQ(site->hall.ceiling_m, 9.0);
  ASSERT_EQ(site->movers.size(), 2U);
  EXPECT_EQ(site->movers[1].kind, Mover::Kind::forklift);
  EXPECT_EQ(site->movers[1].way.size(), 3U);
  EXPECT_EQ(site->change.stock, 0.3);
  EXPECT_EQ(site->change.stock_times, 4);
  EXPECT_EQ(site->change.lamps_failed, 0.5);
  EXPECT_EQ(site->change.ambient, 0.03);
}

TEST(Site, ABatteryIsOnlyThereWhereTheFileHasOne) {
  EXPECT_FALSE(parse_site(kSmall, "small.toml")->battery);
  const std::string charged = std::string(kSmall) + R"(
[[station]]
name = "dock"
x = 3
y = 1
[battery]
start_percent = 30
drains_percent_per_km = 10
charges_percent_per_h = 36
chargers = ["dock"]
)";
  const Result<Site> site = parse_site(charged, "charged.toml");
  ASSERT_TRUE(site) << site.error().message;
  ASSERT_TRUE(site->battery);
  EXPECT_NEAR(site->battery->share, 0.3, 1e-12);
  EXPECT_NEAR(site->battery->drains_per_m, 1e-4, 1e-12);
  EXPECT_NEAR(site->battery->charges_per_s, 1e-4, 1e-12);
  EXPECT_EQ(site->battery->chargers, (std::vector<SitePoint>{{3.0, 1.0}}));
  const Result<Site> wrong = parse_site(std::string(kSmall) + "[battery]\nchargers = [\"dok\"]\n", "wrong.toml");
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error().message, HasSubstr("there is no station \"dok\""));
}

TEST(Site, AWayThatIsNoneIsRefused) {
  const auto refused = [](const std::string& more) {
    const auto site = parse_site(std::string(kSmall) + more, "small.toml");
    return site ? std::string("nothing is wrong") : site.error().message;
  };
  EXPECT_THAT(refused("[[person]]\nway = [0.5, 0.5, 4.0]\n"), HasSubstr("way"));
  EXPECT_THAT(refused("[[person]]\nway = [0.5, 0.5, 4.0, 1, 2]\n"), HasSubstr("an x and a y"));
  EXPECT_THAT(refused("[[person]]\nway = [1, 1, 1, 1]\n"), HasSubstr("less than 0.1 m apart"));
  EXPECT_THAT(refused("[forward_camera]\nwidth_px = 322\n"), HasSubstr("multiple of 4"));
  EXPECT_THAT(refused("looks = [\"rear\"]\n"), HasSubstr("looks \"down\", \"ahead\" or \"up\", not \"rear\""));
}

}  // namespace
}  // namespace weft::agents::sim
