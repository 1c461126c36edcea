#include <gtest/gtest.h>

#include "agents/agent/process/equip.hpp"
#include "agents/agent/process/identity.hpp"
#include "agents/agent/process/run.hpp"
#include "agents/navigation/method_switch.hpp"
#include "core/camera/camera_file.hpp"
#include "tests/agents/agent/process/folder.hpp"
#include "tests/agents/agent/process/method_that_looks.hpp"
#include "tests/agents/agent/process/programs.hpp"

namespace weft::agents::test {
namespace {

Options options_in(const Folder& folder) {
  Options options;
  options.name = "r1";
  options.state = folder.file("state");
  options.methods = {"floor"};
  options.body = "sim";
  options.site = WEFT_SITE;
  options.servers = {"127.0.0.1"};
  options.listen = "127.0.0.1";
  options.bytes_per_second = 1U << 20U;
  return options;
}

/// Expects that an agent cannot start with these options, and that the error names the word that is wrong.
void expect_refused(const Options& options, const std::string& word) {
  const Result<void> ran = run(kSimulator, options);
  ASSERT_FALSE(ran.has_value()) << word;
  EXPECT_NE(ran.error().message.find(word), std::string::npos) << ran.error().message;
}

TEST(AgentStart, IdentityIsDrawnOnceAndKept) {
  const Folder folder;
  RobotId first;
  {
    const auto state = StateDirectory::open(folder.file("state"));
    ASSERT_TRUE(state.has_value());
    first = state->identity().value();
    EXPECT_TRUE(first);
  }
  const auto again = StateDirectory::open(folder.file("state"));
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(again->identity().value(), first);
}

TEST(AgentStart, DamagedIdentityIsNamed) {
  const Folder folder;
  std::filesystem::create_directories(folder.file("state"));
  folder.write("state/identity", "hello\n");
  expect_refused(options_in(folder), "state/identity");
}

TEST(AgentStart, TwoAgentsInOneStateDirectoryAreRefused) {
  const Folder folder;
  const auto state = StateDirectory::open(folder.file("state"));
  ASSERT_TRUE(state.has_value());
  expect_refused(options_in(folder), "another agent");
}

TEST(AgentStart, ACameraFileReplacesWhatTheBodySays) {
  const Folder folder;
  Options options = options_in(folder);
  std::string warnings;
  const auto warn = [&](const std::string& text) { warnings += text; };
  const auto body = make_body(kSimulator, options, warn);
  ASSERT_TRUE(body.has_value());
  const CameraModel told = (*body)->rig().camera();
  CameraCalibration other = calibration_from(told);
  other.fx = 455.0;
  other.body_from_camera.reset();
  options.calibration = folder.write("cam.yaml", camera_file_text(other, {}) + "timeshift_cam_imu: 0\n");
  const auto equipped = equip(options, **body, warn);
  ASSERT_TRUE(equipped.has_value()) << equipped.error().message;
  const CameraModel& camera = equipped->front().rig.camera();
  EXPECT_EQ(camera.fx, 455.0);
  EXPECT_EQ(camera.robot_from_camera.translation, told.robot_from_camera.translation);  // the file has no mount
  EXPECT_NE(warnings.find("timeshift_cam_imu is not understood"), std::string::npos) << warnings;
}

TEST(AgentStart, EachMethodHasACameraOfItsOwn) {
  const std::string ahead = method_that_looks(Gaze::ahead);
  if (ahead.empty()) GTEST_SKIP() << "no method looks ahead";
  const Folder folder;
  Options options = options_in(folder);
  const auto warn = [](const std::string& text) { ADD_FAILURE() << text; };
  options.site = std::string(WEFT_SITES) + "/two-cameras/hall.toml";
  options.name = "r3";
  options.methods = {"floor", ahead};
  const auto body = make_body(kSimulator, options, warn);
  ASSERT_TRUE(body) << body.error().message;
  const auto both = equip(options, **body, warn);
  ASSERT_TRUE(both) << both.error().message;
  ASSERT_EQ(both->size(), 2U);
  EXPECT_EQ((*both)[0].rig.camera().id, (*body)->rig().sensors[0].camera.id) << "the one that looks down";
  EXPECT_EQ((*both)[1].rig.camera().id, (*body)->rig().sensors[1].camera.id);
  const auto navigator = make_navigator(options, *both, (*body)->rig());
  ASSERT_TRUE(navigator);
  EXPECT_EQ((*navigator)->drives(), (std::vector<std::string>{"floor", ahead, change_between("floor", ahead)}));

  options.methods = {ahead};
  EXPECT_EQ(equip(options, **body, warn)->front().rig.camera().id, (*body)->rig().sensors[1].camera.id);

  options.methods = {"floor", ahead};
  options.name = "r1";
  expect_refused(options,
                 "method " + ahead +
                     " needs a camera that looks ahead; the body has: floor (camera, down, used by another method)");
}

TEST(AgentStart, WrongCameraFilesAreNamed) {
  const Folder folder;
  Options options = options_in(folder);
  options.calibration = folder.file("none.yaml");
  expect_refused(options, "none.yaml: no such camera file");
  options.calibration = folder.write("bad.yaml", "intrinsics: [1]\n");
  expect_refused(options, "bad.yaml:1: ");
  CameraCalibration small;
  small.width = 320;
  small.height = 240;
  small.fx = small.fy = 200.0;
  options.calibration = folder.write("small.yaml", camera_file_text(small, {}));
  expect_refused(options, "320 x 240 pixels, the body's has 752 x 480");
}

TEST(AgentStart, MissingAndWrongSitesAreNamed) {
  const Folder folder;
  Options options = options_in(folder);
  options.site = folder.file("none.toml");
  expect_refused(options, "none.toml");
  options.site = folder.write("wrong.toml", "name = 3\n");
  expect_refused(options, "wrong.toml");
  options = options_in(folder);
  options.name = "r77";
  expect_refused(options, "r77");
}

TEST(AgentStart, MissingFoldersAreNamed) {
  const Folder folder;
  Options options = options_in(folder);
  options.records = folder.file("nowhere");
  expect_refused(options, "nowhere");
  options = options_in(folder);
  options.floors = folder.file("no_floors");
  expect_refused(options, "no_floors");
  options = options_in(folder);
  options.truth = folder.file("no/truth.jsonl");
  expect_refused(options, "truth.jsonl");
}

TEST(AgentStart, MissingRecordingAndDamagedCalibrationAreNamed) {
  const Folder folder;
  Options options = options_in(folder);
  options.body = "replay";
  options.camera = "cam0";
  options.recording = folder.file("none");
  expect_refused(options, "none");
  std::filesystem::create_directories(folder.file("rec/mav0/cam0/data"));
  folder.write("rec/mav0/cam0/data.csv", "#timestamp [ns],filename\n1,1.png\n");
  folder.write("rec/mav0/cam0/sensor.yaml", "intrinsics: [abc]\n");
  options.recording = folder.file("rec");
  expect_refused(options, "sensor.yaml");
}

TEST(AgentStart, ACalibrationOfSeveralCamerasIsReadForEachByItsName) {
  const std::string method_ahead = method_that_looks(Gaze::ahead);
  if (method_ahead.empty()) GTEST_SKIP() << "no method looks ahead";
  const Folder folder;
  Options options = options_in(folder);
  options.body = "replay";
  options.camera = "cam1,cam0";
  options.methods = {"floor", method_ahead};
  options.recording = folder.file("rec");
  const std::string sensor =
      "camera_model: pinhole\nresolution: [32, 24]\nintrinsics: [30, 30, 15.5, 11.5]\ndistortion_model: none\n";
  const std::string down =
      "T_BS:\n  cols: 4\n  rows: 4\n  data: [0, -1, 0, 0.3, -1, 0, 0, 0, 0, 0, -1, 0.6, 0, 0, 0, 1]\n";
  const std::string ahead =
      "T_BS:\n  cols: 4\n  rows: 4\n  data: [0, 0, 1, 0.3, -1, 0, 0, 0, 0, -1, 0, 0.5, 0, 0, 0, 1]\n";
  for (const std::string name : {"cam0", "cam1"}) {
    std::filesystem::create_directories(folder.file("rec/mav0/" + name + "/data"));
    folder.write("rec/mav0/" + name + "/data.csv", "1,1.png\n");
    folder.write("rec/mav0/" + name + "/sensor.yaml", sensor + (name == "cam0" ? down : ahead));
  }
  const std::string chain =
      "  camera_model: pinhole\n  resolution: [32, 24]\n  distortion_model: none\n  intrinsics: ";
  folder.write("chain.yaml", "cam0:\n" + chain + "[40, 40, 15.5, 11.5]\ncam1:\n" + chain + "[50, 50, 15.5, 11.5]\n");
  options.calibration = folder.file("chain.yaml");
  const auto warn = [](const std::string&) {};
  const auto body = make_body(kSimulator, options, warn);
  ASSERT_TRUE(body) << body.error().message;
  const auto equipped = equip(options, **body, warn);
  ASSERT_TRUE(equipped) << equipped.error().message;
  EXPECT_EQ(equipped->front().rig.sensors.front().id, "cam0");
  EXPECT_EQ(equipped->front().rig.camera().fx, 40.0);
  EXPECT_EQ(equipped->back().rig.sensors.front().id, "cam1");
  EXPECT_EQ(equipped->back().rig.camera().fx, 50.0);
}

TEST(AgentStart, ABodyThatTheProgramHasNotIsRefused) {
  const Folder folder;
  const auto body = make_body(kRobotsAgent, options_in(folder), [](const std::string&) {});
  ASSERT_FALSE(body);
  EXPECT_EQ(body.error().code, ErrorCode::refused);
  EXPECT_EQ(body.error().message, "there is no body sim in this program; start weft-agent-sim, with the same words");
}

TEST(AgentStart, SettingsOfTheMethodAreChecked) {
  const Folder folder;
  Options options = options_in(folder);
  std::get<Configured<Floor>>(options.settings).config.corners = 3;
  expect_refused(options, "corners");
}

}  // namespace
}  // namespace weft::agents::test
