#include <gmock/gmock.h>

#include <sstream>

#include "agents/agent/process/calibrate/jobs.hpp"
#include "core/camera/camera_file.hpp"
#include "tests/agents/agent/process/calibrate/board_images.hpp"
#include "tests/agents/agent/process/calibrate/invoked.hpp"
#include "tests/agents/agent/process/folder.hpp"

namespace weft::agents::test {
namespace {

using testing::HasSubstr;

const ChessBoard kBoard{6, 5, 0.04};

CameraModel camera() {
  CameraModel camera;
  camera.width = 320;
  camera.height = 240;
  camera.fx = camera.fy = 210.0;
  camera.cx = 158.0;
  camera.cy = 121.0;
  camera.distortion = {-0.1, 0.02, 0.0, 0.0, 0.0};
  return camera;
}

CameraJob board_job_in(const Folder& folder) {
  CameraJob job;
  job.folder = folder.file("");
  job.board = kBoard;
  job.out = folder.file("camera.yaml");
  job.picture = folder.file("residuals.picture.png");
  return job;
}

TEST(CalibrateCamera, WritesACameraThatCanBeReadAndAPicture) {
  const Folder folder;
  take_images(folder, kBoard, camera(), 10, 0.5);
  std::ostringstream out;
  std::ostringstream err;
  double now = 0.0;
  const CameraJob job = board_job_in(folder);
  const Result<void> done = calibrate_camera(job, {out, err, [&] { return now += 1.5; }});
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_THAT(out.str(), HasSubstr("blank.png"));
  EXPECT_THAT(out.str(), HasSubstr("no board was found"));
  EXPECT_THAT(out.str(), HasSubstr("broken.jpg"));
  EXPECT_THAT(out.str(), HasSubstr("one sigma"));
  EXPECT_THAT(err.str(), HasSubstr(" of 12 images, the board in "));
  std::ifstream in(job.out);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const auto read = parse_camera_file(text, job.out, "cam0");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_NEAR(read->camera.fx / 210.0, 1.0, 0.01);
  EXPECT_EQ(read->camera.width, 320);
  EXPECT_GT(width_of(job.picture), 1000);
}

TEST(CalibrateCamera, WhatCannotBeDoneIsSaid) {
  const Folder folder;
  std::ostringstream out;
  std::ostringstream err;
  const JobOutput output{out, err, [] { return 0.0; }};
  CameraJob job = board_job_in(folder);
  job.folder = folder.file("none");
  EXPECT_THAT(calibrate_camera(job, output).error().message, HasSubstr("none"));
  job.folder = folder.file("");
  EXPECT_THAT(calibrate_camera(job, output).error().message, HasSubstr("no .png"));
  take_images(folder, kBoard, camera(), 3, 0.5);
  EXPECT_THAT(calibrate_camera(job, output).error().message, HasSubstr("at least 6"));
  EXPECT_THAT(err.str(), HasSubstr("blank.png: no board was found"));
}

TEST(CalibrateCommandLine, IsUnderstood) {
  const auto chess = parsed({"camera", "DIR", "--chessboard", "9x6", "--square-mm", "25", "--model", "equidistant"});
  const auto* job = std::get_if<CameraJob>(&chess);
  ASSERT_NE(job, nullptr) << std::get<Leave>(chess).text;
  EXPECT_EQ(std::get<ChessBoard>(job->board).rows, 6);
  EXPECT_EQ(job->lens, LensModel::equidistant);
  EXPECT_EQ(job->picture, "camera.png");
  const auto tags = parsed({"camera", "DIR", "--apriltags", "6x5", "--tag-mm", "88", "--gap-mm", "26.4"});
  ASSERT_NE(std::get_if<CameraJob>(&tags), nullptr) << std::get<Leave>(tags).text;
  EXPECT_NEAR(std::get<TagBoard>(std::get<CameraJob>(tags).board).gap_m, 0.0264, 1e-12);
}

TEST(CalibrateCommandLine, MistakesAreOneLineWithTwoAsTheCode) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{}, "subcommand"},
      {{"camera"}, "DIR"},
      {{"camera", "DIR"}, "which board"},
      {{"camera", "DIR", "--chessboard", "9x6"}, "--square-mm"},
      {{"camera", "DIR", "--chessboard", "9", "--square-mm", "25"}, "COLUMNSxROWS"},
      {{"camera", "DIR", "--chessboard", "9x9", "--square-mm", "25"}, "as many columns"},
      {{"camera", "DIR", "--chessboard", "9x6", "--square-mm", "25", "--model", "omni"}, "omni"},
      {{"camera", "DIR", "--chessboard", "9x6", "--square-mm", "25", "--picture", "a.gif"}, ".png"},
  };
  for (const auto& [words, part] : wrong) {
    const auto result = parsed(words);
    const auto* const leave = std::get_if<Leave>(&result);
    ASSERT_NE(leave, nullptr) << part;
    EXPECT_EQ(leave->exit_code, 2);
    EXPECT_THAT(leave->text, HasSubstr(part));
    EXPECT_EQ(leave->text.find('\n'), leave->text.size() - 1) << leave->text;
  }
  EXPECT_EQ(std::get<Leave>(parsed({"camera", "--help"})).exit_code, 0);
}

}  // namespace
}  // namespace weft::agents::test
