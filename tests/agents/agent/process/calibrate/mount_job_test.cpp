#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "agents/agent/process/calibrate/jobs.hpp"
#include "agents/perception/camera_error.hpp"
#include "tests/agents/agent/process/calibrate/invoked.hpp"
#include "tests/agents/agent/process/folder.hpp"
#include "tests/agents/agent/process/programs.hpp"

namespace weft::agents::test {
namespace {

using testing::HasSubstr;

/// Describes an empty hall.
constexpr const char* kEmptyHall = R"([floor]
x_min = 0.0
y_min = 0.0
x_max = 10.0
y_max = 6.0
[[robot]]
name = "r1"
x = 2.0
y = 3.0
)";
/// Describes another one with a ceiling at 4 m, and a camera that looks up and leans more than it says.
constexpr const char* kBelowPanels = R"([floor]
x_min = 0.0
y_min = 0.0
x_max = 12.0
y_max = 8.0
[hall]
ceiling_m = 4.0
ceiling_grey = 140.0
ceiling = "panels"
beams_every_m = 4.0
sprinklers_every_m = 2.4
[[robot]]
name = "r1"
x = 3.0
y = 4.0
looks = ["up"]
[robot.ceiling_camera]
tilt_error_forward_deg = 1.5
tilt_error_left_deg = -1.0
)";
/// Describes cameras that are otherwise exactly as the site says, and wheels that are right.
constexpr const char* kExact = R"([disturbances]
focal_error_percent = 0.0
principal_point_error_px = 0.0
distortion_error_px = 0.0
mount_error_mm = 0.0
mount_error_deg = 0.0
wheel_scale_percent = 0.0
wheel_asymmetry_percent = 0.0
)";

MountJob drive_job_in(const Folder& folder) {
  MountJob job;
  job.site = folder.write("site.toml", std::string(kEmptyHall) + kExact);
  job.robot = "r1";
  job.along = folder.write("drive.line", "2.0 3.0\n2.8 3.2\n3.6 3.0\n4.4 2.8\n5.2 3.0\n");
  job.out = folder.file("mount.yaml");
  job.json = true;
  return job;
}

/// Returns a calibration file of the site's camera that has it 0.5 degrees and 8 mm off.
std::string camera_off_by_half_a_degree() {
  CameraModel camera;  // as [camera] has it by default
  camera.distortion = {-0.08, 0.01, 0.0004, -0.0003, 0.0};
  camera.robot_from_camera = downward_mount(0.25, 0.0, 0.6, 0.735, 0.0, 0.0);
  CameraError error;
  error.turn_rad = Eigen::Vector3d(0.0050, -0.0050, 0.0050);
  error.shift_m = Eigen::Vector3d(0.0045, 0.0045, -0.0045);
  return camera_file_text(calibration_from(with_error(camera, error)), {});
}

nlohmann::json done(const MountJob& job) {
  std::ostringstream out;
  std::ostringstream err;
  double now = 0.0;
  const Result<void> ran = calibrate_mount(kSimulator, job, {out, err, [&] { return now += 0.1; }});
  EXPECT_TRUE(ran) << ran.error().message;
  EXPECT_THAT(err.str(), HasSubstr("time 3 of 3 through the drive"));
  return nlohmann::json::parse(out.str(), nullptr, false);
}

TEST(CalibrateMount, TheWheelsShowTheHeightAndTheFileIsTaken) {
  const Folder folder;
  MountJob job = drive_job_in(folder);
  job.wheels_sigma = 0.005;
  job.calibration = folder.write("given.yaml", camera_off_by_half_a_degree());
  const nlohmann::json found = done(job);
  EXPECT_EQ(found["height_from"], "wheels");
  EXPECT_LT(found["scale_sigma_share"], 0.01);
  EXPECT_TRUE(found["yaw_seen"]);
  const double turned = std::hypot(found["pitch_change_rad"].get<double>(), found["roll_change_rad"].get<double>(),
                                   found["yaw_change_rad"].get<double>());
  EXPECT_NEAR(turned, 0.0087, 0.0025);  // the half degree that the mount is off
  const auto file = parse_camera_file(folder.read("mount.yaml"), "mount.yaml", "cam0");
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_TRUE(file->camera.body_from_camera);
  EXPECT_TRUE(file->camera.sigma.tilt_rad);

  // Calibrated once more from there, nothing is left to be found.
  job.calibration = job.out;
  job.out = folder.file("again.yaml");
  const nlohmann::json again = done(job);
  EXPECT_LT(std::abs(again["pitch_change_rad"].get<double>()), 0.0005);
  EXPECT_LT(std::abs(again["height_change_share"].get<double>()), 0.001);
}

TEST(CalibrateMount, WithoutDistanceAndWheelsTheHeightIsSaidToBeUnknown) {
  const Folder folder;
  MountJob job = drive_job_in(folder);
  job.json = false;
  std::ostringstream out;
  std::ostringstream err;
  ASSERT_TRUE(calibrate_mount(kSimulator, job, {out, err, [] { return 0.0; }}));
  EXPECT_THAT(out.str(), HasSubstr("height    0.6000 m  as given: not observable"));
  EXPECT_THAT(folder.read("mount.yaml"), testing::Not(HasSubstr("scale_share")));
}

TEST(CalibrateMount, AShortDriveIsRefusedWithTheBound) {
  const Folder folder;
  MountJob job = drive_job_in(folder);
  job.along = folder.write("short.line", "2.0 3.0\n2.5 3.0\n");
  std::ostringstream out;
  std::ostringstream err;
  const Result<void> ran = calibrate_mount(kSimulator, job, {out, err, [] { return 0.0; }});
  ASSERT_FALSE(ran);
  EXPECT_THAT(ran.error().message, HasSubstr("at least 2.000 m"));
  job.along = folder.file("none.line");
  EXPECT_THAT(calibrate_mount(kSimulator, job, {out, err, [] { return 0.0; }}).error().message,
              HasSubstr("none.line"));
}

TEST(CalibrateMount, ByTheCeilingTheWheelsShowHowHighItIs) {
  const Folder folder;
  MountJob job = drive_job_in(folder);
  job.site = folder.write("hall.toml", std::string(kBelowPanels) + kExact);
  job.along = folder.write("long.line", "3.0 4.0\n3.8 4.2\n4.6 4.0\n5.4 3.8\n6.2 4.0\n7.0 4.2\n7.8 4.0\n");
  job.method = kByCeiling;
  job.ceiling_m = 4.4;
  job.wheels_sigma = 0.01;
  const nlohmann::json found = done(job);
  EXPECT_NEAR(found["pitch_change_rad"].get<double>(), 0.0262, 0.0025);
  EXPECT_NEAR(found["roll_change_rad"].get<double>(), 0.0175, 0.0025);
  EXPECT_EQ(found["height_from"], "wheels");
  EXPECT_NEAR(found["ceiling_m"].get<double>(), 4.0, 0.06);
  EXPECT_NEAR(found["ceiling_sigma_m"].get<double>(), 0.037, 0.005);
  EXPECT_EQ(found["height_m"], 0.35) << "the camera's own stays";
  const auto file = parse_camera_file(folder.read("mount.yaml"), "mount.yaml", "cam0");
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_TRUE(file->camera.sigma.tilt_rad);
  EXPECT_FALSE(file->camera.sigma.scale_share) << "it is the ceiling's, not the camera's";
}

TEST(CalibrateMountCommandLine, IsUnderstood) {
  const auto result = parsed({"mount", "REC", "--distance-m", "6.02", "--height-m", "0.6", "--pitch-deg", "42"});
  const auto* job = std::get_if<MountJob>(&result);
  ASSERT_NE(job, nullptr) << std::get<Leave>(result).text;
  EXPECT_EQ(job->recording, "REC");
  EXPECT_EQ(job->distance_m, 6.02);
  EXPECT_NEAR(job->guess->pitch_rad, 0.733, 1e-3);
  EXPECT_FALSE(job->wheels_sigma);
  EXPECT_EQ(job->method, "floor");
  const auto below = parsed({"mount", "REC", "--method", "ceiling", "--ceiling-m", "6.4", "--height-m", "0.5",
                             "--pitch-deg", "-90", "--yaw-deg", "180"});
  const auto* up = std::get_if<MountJob>(&below);
  ASSERT_NE(up, nullptr) << std::get<Leave>(below).text;
  EXPECT_EQ(up->ceiling_m, 6.4);
  EXPECT_NEAR(up->guess->yaw_rad, 3.1416, 1e-3);
  for (const auto& [words, part] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"mount"}, "which drive"},
           {{"mount", "--site", "S"}, "--along"},
           {{"mount", "REC", "--height-m", "0.6"}, "go together"},
           {{"mount", "REC", "--yaw-deg", "90"}, "--height-m"},
           {{"mount", "REC", "--height-m", "0.6", "--pitch-deg", "-90"}, "10 to 90"},
           {{"mount", "REC", "--method", "ceiling"}, "--ceiling-m"},
           {{"mount", "REC", "--ceiling-m", "6.4"}, "--method ceiling"},
           {{"mount", "REC", "--method", "bearing"}, "bearing"},
           {{"mount", "REC", "--method", "ceiling", "--ceiling-m", "6.4", "--height-m", "0.5", "--pitch-deg", "42"},
            "-90"},
           {{"mount", "REC", "--distance-m", "-1"}, "distance-m"},
           {{"mount", "REC", "--site", "S", "--name", "r", "--along", "L"}, "excludes"}}) {
    const auto wrong = parsed(words);
    const auto* const leave = std::get_if<Leave>(&wrong);
    ASSERT_NE(leave, nullptr) << part;
    EXPECT_EQ(leave->exit_code, 2);
    EXPECT_THAT(leave->text, HasSubstr(part));
  }
}

}  // namespace
}  // namespace weft::agents::test
