#include "agents/bodies/sim/sim_body.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "sites.hpp"

namespace weft::agents::sim {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

const Bytes& pixels_of(const Sample& sample) {
  return *std::get<Image>(sample.views.front().data).pixels;
}

double mean_of(const Bytes& pixels) {
  double sum = 0.0;
  for (const std::uint8_t p : pixels) {
    sum += p;
  }
  return sum / static_cast<double>(pixels.size());
}

/// Returns a site with a small camera: what a test says about time and numbers does not need many pixels.
Site quick_site() {
  Site site = empty_site();
  site.camera.width = 128;
  site.camera.height = 64;
  site.camera.focal_px = 80.0;
  site.camera.cx_px = 63.5;
  site.camera.cy_px = 31.5;
  return site;
}

std::vector<Sample> run(Body& body, int steps, const Twist& command) {
  std::vector<Sample> samples;
  for (int i = 0; i < steps; ++i) {
    auto sample = body.step(command);
    EXPECT_TRUE(sample) << sample.error().message;
    samples.push_back(*sample);
  }
  return samples;
}

TEST(SimBody, TwoCamerasSeeInTurnEachAtItsOwnRate) {
  SimBodyConfig config = config_of(quick_site());
  config.site.robots.front().looks = {Gaze::down, Gaze::ahead};
  config.site.camera.fps = 30.0;
  config.site.forward_camera.fps = 10.0;
  config.site.forward_camera.width = 64;
  config.site.forward_camera.height = 64;
  config.site.disturbances.dropped_frames = 0.0;
  auto body = body_of(config);
  const Rig rig = body->rig();
  ASSERT_EQ(rig.sensors.size(), 2U);
  EXPECT_EQ(rig.sensors[0].gaze(), Gaze::down);
  EXPECT_EQ(rig.sensors[1].gaze(), Gaze::ahead);
  std::map<std::string, int> images;
  double driven_s = 0.0;
  for (const Sample& sample : run(*body, 40, {0.3, 0.0})) {
    ASSERT_FALSE(sample.views.empty());
    ++images[sample.views.front().sensor];
    EXPECT_GT(sample.motion.elapsed, Duration::zero());
    driven_s += seconds(sample.motion.elapsed);
  }
  EXPECT_EQ(images.at(rig.sensors[0].id), 30);
  EXPECT_EQ(images.at(rig.sensors[1].id), 10);
  EXPECT_NEAR(driven_s, 1.0, 0.05);
}

TEST(SimBody, RepeatsBitForBit) {
  const SimBodyConfig config = config_of(empty_site());
  std::vector<std::vector<Sample>> runs;
  for (int i = 0; i < 2; ++i) {
    auto body = body_of(config);
    ASSERT_TRUE(body->drive_by_hand({{4.0, 6.0}, {4.6, 6.0}}));
    runs.push_back(run(*body, 14, {}));
    auto more = run(*body, 5, {0.4, 0.3});
    runs.back().insert(runs.back().end(), more.begin(), more.end());
  }
  for (std::size_t i = 0; i < runs[0].size(); ++i) {
    const Sample& a = runs[0][i];
    const Sample& b = runs[1][i];
    EXPECT_EQ(a.time, b.time);
    EXPECT_EQ(a.motion.command, b.motion.command);
    EXPECT_EQ(a.motion.wheels->distance_m, b.motion.wheels->distance_m);
    ASSERT_EQ(a.views.size(), b.views.size());
    if (!a.views.empty()) {
      EXPECT_EQ(pixels_of(a), pixels_of(b)) << "frame " << a.frame;
    }
  }
}

TEST(SimBody, AnotherSeedIsAnotherRun) {
  auto a = body_of(config_of(quick_site(), "r1", 1));
  auto b = body_of(config_of(quick_site(), "r1", 2));
  const auto from_a = run(*a, 3, {0.4, 0.0});
  const auto from_b = run(*b, 3, {0.4, 0.0});
  EXPECT_NE(pixels_of(from_a[2]), pixels_of(from_b[2]));
  EXPECT_NE(from_a[2].motion.wheels->distance_m, from_b[2].motion.wheels->distance_m);
}

TEST(SimBody, GivesTheNominalCalibration) {
  const auto told = body_of(config_of(quick_site(), "r1", 7))->rig();
  ASSERT_EQ(told.sensors.size(), 1U);
  EXPECT_EQ(told.camera().fx, 80.0);
  EXPECT_EQ(told.camera().id, "r1/floor/day0");
}

TEST(SimBody, AnotherDayIsAnotherLightAndCalibration) {
  Site site = quick_site();
  const auto seen = [&](std::uint64_t day) {
    auto body = body_of(config_of(site, "r1", 1, day));
    EXPECT_EQ(body->rig().camera().id, "r1/floor/day" + std::to_string(day));
    return run(*body, 1, {})[0];
  };
  EXPECT_NE(pixels_of(seen(0)), pixels_of(seen(1)));
  const double noise = site.disturbances.noise_grey;
  site.disturbances = no_disturbances();
  EXPECT_EQ(pixels_of(seen(0)), pixels_of(seen(1)));
  site.disturbances.noise_grey = noise;
  EXPECT_NE(pixels_of(seen(0)), pixels_of(seen(1)));
  site.disturbances = no_disturbances();
  site.disturbances.light_change = 0.15;
  EXPECT_NE(pixels_of(seen(0)), pixels_of(seen(1)));
  site.disturbances = no_disturbances();
  site.disturbances.mount_error_m = 0.003;
  EXPECT_NE(pixels_of(seen(0)), pixels_of(seen(1)));
}

TEST(SimBody, TheLightChangesBetweenTeachAndRepeat) {
  Site site = quick_site();
  site.disturbances = no_disturbances();
  site.disturbances.light_change = 0.15;
  site.hand.wander_m = 0.0;
  auto body = body_of(config_of(site));
  ASSERT_TRUE(body->drive_by_hand({{4.0, 6.0}, {4.3, 6.0}}));
  Sample last = run(*body, 1, {})[0];
  for (int i = 0; i < 300 && !last.hand_done; ++i) {
    last = run(*body, 1, {})[0];
  }
  ASSERT_TRUE(last.hand_done);
  const Sample after = run(*body, 1, {})[0];
  EXPECT_FALSE(after.hand);
  EXPECT_TRUE(after.hand_done);
  EXPECT_NE(mean_of(pixels_of(last)), mean_of(pixels_of(after)));
}

TEST(SimBody, AChangeBeginsOnItsDay) {
  SimBodyConfig config = config_of(quick_site());
  config.site.disturbances = no_disturbances();
  const double before = mean_of(pixels_of(run(*body_of(config), 2, {0.3, 0.0}).back()));
  config.site.change.light = 0.5;
  config.site.change.from_day = 1;
  EXPECT_NEAR(mean_of(pixels_of(run(*body_of(config), 2, {0.3, 0.0}).back())), before, 1e-9);
  config.day = 1;
  EXPECT_NEAR(mean_of(pixels_of(run(*body_of(config), 2, {0.3, 0.0}).back())), before / 2, 0.03 * before);
}

TEST(SimBody, FramesComeSlowlyAtRestAndFastInMotion) {
  Site site = quick_site();
  site.disturbances.time_jitter_s = 0.0;
  auto body = body_of(config_of(site));
  EXPECT_NEAR(seconds(run(*body, 1, {})[0].motion.elapsed), 0.5, 1e-6);
  for (const Sample& sample : run(*body, 10, {0.3, 0.0})) {
    EXPECT_NEAR(seconds(sample.motion.elapsed), 1.0 / 30, 1e-6);
  }
  // Rolling out is motion too.
  EXPECT_NEAR(seconds(run(*body, 1, {})[0].motion.elapsed), 1.0 / 30, 1e-6);
  run(*body, 60, {});
  EXPECT_NEAR(seconds(run(*body, 1, {})[0].motion.elapsed), 0.5, 1e-6);
}

TEST(SimBody, NumbersItsFramesAndDropsTheStatedShare) {
  Site site = quick_site();
  site.disturbances.dropped_frames = 0.05;
  auto body = body_of(config_of(site));
  int dropped = 0;
  std::uint64_t expected = 1;
  for (const Sample& sample : run(*body, 2000, {0.01, 0.2})) {
    EXPECT_EQ(sample.frame, expected++);
    dropped += sample.views.empty();
  }
  EXPECT_NEAR(dropped, 100, 30);
}

TEST(SimBody, StampsJitterAndNeverRunBackwards) {
  auto body = body_of(config_of(quick_site()));
  SensorTime before{};
  double squares = 0.0;
  const auto samples = run(*body, 400, {0.01, 0.2});
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_GT(samples[i].time, before);
    EXPECT_EQ(samples[i].motion.elapsed, samples[i].time - before);
    const double off = seconds(samples[i].time.time_since_epoch()) - static_cast<double>(i + 1) / 30.0;
    squares += off * off;
    before = samples[i].time;
  }
  EXPECT_NEAR(std::sqrt(squares / 400), 0.001, 0.0002);
}

double difference_of(const Bytes& a, const Bytes& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
  return sum / static_cast<double>(a.size());
}

/// Returns samples of a robot that rolls on at an even speed, an image every 10 ms.
std::vector<Sample> rolling_with_stamps_off_by(double offset_s) {
  Site site = empty_site();
  site.disturbances = no_disturbances();
  site.disturbances.time_offset_s = offset_s;
  site.camera.fps = 100.0;
  const auto body = make_sim_body(config_of(site));
  EXPECT_TRUE(body);
  (*body)->put({4.0, 6.0, 0.0}, {0.5, 0.2});
  return run(**body, 6, {0.5, 0.2});
}

TEST(SimBody, WithAnOffsetImagesAreTakenThatMuchBeforeTheirStamps) {
  const auto right = rolling_with_stamps_off_by(0.0);
  const auto late = rolling_with_stamps_off_by(0.01);
  const auto early = rolling_with_stamps_off_by(-0.02);
  const double apart = difference_of(pixels_of(right[2]), pixels_of(right[3]));
  EXPECT_GT(apart, 1.0);
  for (std::size_t i = 1; i + 2 < right.size(); ++i) {
    EXPECT_LT(difference_of(pixels_of(late[i]), pixels_of(right[i - 1])), 0.02 * apart);
    EXPECT_LT(difference_of(pixels_of(early[i]), pixels_of(right[i + 2])), 0.02 * apart);
    // The wheels and all else keep their clock.
    EXPECT_EQ(late[i].time, right[i].time);
    EXPECT_EQ(early[i].views.front().time, right[i].views.front().time);
    EXPECT_EQ(late[i].motion.elapsed, right[i].motion.elapsed);
    EXPECT_EQ(late[i].motion.wheels->distance_m, right[i].motion.wheels->distance_m);
  }
}

TEST(SimBody, AnOffsetChangesNothingAtRest) {
  Site site = quick_site();
  site.disturbances = no_disturbances();
  const Bytes right = pixels_of(run(*body_of(config_of(site)), 2, {})[1]);
  site.disturbances.time_offset_s = 0.1;
  EXPECT_EQ(right, pixels_of(run(*body_of(config_of(site)), 2, {})[1]));
}

TEST(SimBody, ExposureDriftsByTheStatedShare) {
  Site site = quick_site();
  site.disturbances = no_disturbances();
  site.disturbances.exposure_drift = 0.2;
  auto body = body_of(config_of(site));
  double least = 1e9;
  double most = 0.0;
  for (const Sample& sample : run(*body, 600, {})) {
    least = std::min(least, mean_of(pixels_of(sample)));
    most = std::max(most, mean_of(pixels_of(sample)));
  }
  EXPECT_NEAR(most / least, 1.1 / 0.9, 0.06);
}

TEST(SimBody, PutDownElsewhereItRollsOnFromThere) {
  Site site = quick_site();
  site.disturbances.slip = 0.0;
  auto body = make_sim_body(config_of(site));
  ASSERT_TRUE(body);
  ASSERT_TRUE((*body)->drive_by_hand({{4.0, 6.0}, {8.0, 6.0}}));
  run(**body, 10, {});
  (*body)->put({7.0, 3.0, 1.0}, {0.6, 0.0});
  const Sample next = run(**body, 1, {0.6, 0.0})[0];
  EXPECT_FALSE(next.hand);
  EXPECT_NEAR(seconds(next.motion.elapsed), 1.0 / 30, 0.005) << "it is in motion";
  EXPECT_NEAR(next.motion.wheels->distance_m, 0.6 / 30, 0.002);
  const Pose2 off = Pose2{7.0, 3.0, 1.0}.inverse() * (*body)->site_from_robot();
  EXPECT_NEAR(off.x, 0.6 / 30, 1e-6);
  EXPECT_NEAR(off.y, 0.0, 1e-6);
  (*body)->put({2.0, 2.0, 0.0}, {});
  EXPECT_NEAR(seconds(run(**body, 1, {})[0].motion.elapsed), 0.5, 0.005) << "it stands";
}

TEST(SimBody, ReportsTheHandsCommandAsItsOwn) {
  auto body = body_of(config_of(quick_site()));
  ASSERT_TRUE(body->drive_by_hand({{4.0, 6.0}, {8.0, 6.0}}));
  const auto samples = run(*body, 60, {0.0, 1.0});
  EXPECT_TRUE(samples.back().hand);
  EXPECT_GT(samples.back().motion.command.linear_m_s, 0.3);
  EXPECT_LT(std::abs(samples.back().motion.command.angular_rad_s), 0.5);
  body->stop_hand();
  const auto after = run(*body, 1, {0.0, 1.0});
  EXPECT_FALSE(after[0].hand);
  EXPECT_FALSE(after[0].hand_done);
  EXPECT_EQ(after[0].motion.command, (Twist{0.0, 1.0}));
}

TEST(SimBody, SaysItsChargeWhereItHasABatteryAndStandsOnceThatIsEmpty) {
  SimBodyConfig config = config_of(quick_site());
  EXPECT_FALSE(run(*body_of(config), 1, {0.3, 0.0}).back().charge);
  config.site.battery = BatterySetup{.share = 0.002, .drains_per_m = 0.01};
  auto body = body_of(config);
  const std::vector<Sample> driven = run(*body, 60, {0.3, 0.0});
  EXPECT_LT(driven.back().charge.value().share, driven.front().charge.value().share);
  const std::vector<Sample> empty = run(*body, 200, {0.3, 0.0});
  EXPECT_EQ(empty.back().charge.value().share, 0.0);
  EXPECT_EQ(empty.back().motion.command, Twist{});
}

TEST(SimBody, WritesTruthForEveryFrame) {
  const fs::path path = fs::temp_directory_path() / "weft-sim-truth-test.jsonl";
  fs::remove(path);
  Site site = quick_site();
  site.disturbances.dropped_frames = 0.2;
  SimBodyConfig config = config_of(site);
  config.truth_path = path.string();
  auto body = body_of(config);
  run(*body, 30, {0.5, 0.0});
  // Whole lines are there while the body still runs.
  std::ifstream file(path);
  std::uint64_t frame = 0;
  double x = 0.0;
  for (std::string line; std::getline(file, line);) {
    const auto row = nlohmann::json::parse(line);
    EXPECT_EQ(row["robot"], "r1");
    EXPECT_EQ(row["frame"], ++frame);
    EXPECT_NEAR(row["t"].get<double>(), static_cast<double>(frame) / 30, 1e-5);
    EXPECT_NEAR(row["y"].get<double>(), 6.0, 0.05);
    x = row["x"];
    EXPECT_EQ(row.size(), 6U);
  }
  EXPECT_EQ(frame, 30U);
  EXPECT_GT(x, 4.1);
  EXPECT_LT(x, 4.5);
  fs::remove(path);
}

TEST(SimBody, ATruthFileThatCannotBeWrittenIsAnError) {
  SimBodyConfig config = config_of(quick_site());
  config.truth_path = "/nowhere/truth.jsonl";
  const auto body = make_sim_body(config);
  ASSERT_FALSE(body);
  EXPECT_EQ(body.error().code, ErrorCode::unavailable);
  EXPECT_THAT(body.error().message, HasSubstr("/nowhere/truth.jsonl"));
}

TEST(SimBody, AnUnknownRobotIsRefusedWithThoseThereAre) {
  const auto body = make_sim_body(config_of(quick_site(), "r9"));
  ASSERT_FALSE(body);
  EXPECT_EQ(body.error().code, ErrorCode::not_found);
  EXPECT_THAT(body.error().message, HasSubstr("r1, r2"));
}

TEST(SimBody, ALineItCannotDriveIsRefusedAndNothingMoves) {
  auto body = body_of(config_of(quick_site()));
  const auto led = body->drive_by_hand({{4.0, 6.0}});
  ASSERT_FALSE(led);
  EXPECT_EQ(led.error().code, ErrorCode::invalid);
  EXPECT_FALSE(run(*body, 1, {})[0].hand);
}

}  // namespace
}  // namespace weft::agents::sim
