#include "clients/evaluate/stereo/study.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/clients/evaluate/parsed.hpp"
#include "tests/clients/evaluate/stereo/rendered_recording.hpp"

namespace weft::evaluate::stereo {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class StereoStudy : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    rendered_ = fs::path(testing::TempDir()) / ("stereo-rendered" + std::to_string(::getpid()));
    test::write_euroc(rendered_);
  }
  static void TearDownTestSuite() { fs::remove_all(rendered_); }
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("stereo" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    fs::copy(rendered_, folder_ / "drive", fs::copy_options::recursive);
  }
  void TearDown() override { fs::remove_all(folder_); }

  Result<Ended> study(const StereoOptions& options, int stop_after = 1 << 30) {
    out_.str("");
    int asked = 0;
    const Surroundings around{out_, progress_, [] { return 0.0; }, [&] { return ++asked > stop_after; }};
    return study_stereo(options, around, [] { return 0.0; });
  }
  StereoOptions options() const { return {folder_ / "drive", {}, {1, 2}, false, true, folder_ / "out"}; }
  Error error_of(const StereoOptions& options) {
    const Result<Ended> ended = study(options);
    return ended ? Error{ErrorCode::internal, "no error"} : ended.error();
  }

  static fs::path rendered_;
  fs::path folder_;
  std::ostringstream out_;
  std::ostringstream progress_;
};
fs::path StereoStudy::rendered_;

TEST_F(StereoStudy, FollowsARenderedDriveAtEachRate) {
  const Result<Ended> ended = study(options());
  ASSERT_TRUE(ended) << ended.error().message;
  const nlohmann::json said = nlohmann::json::parse(out_.str());
  EXPECT_EQ(*ended, said["met"].get<bool>() ? Ended::complete : Ended::missed);
  ASSERT_EQ(said["rates"].size(), 2U);
  const nlohmann::json& first = said["rates"][0];
  EXPECT_EQ(first["pairs"], test::kPairs);
  EXPECT_NEAR(first["way_m"].get<double>(), 0.32, 0.01);
  EXPECT_NEAR(first["hz"].get<double>(), 10.0, 0.1);
  EXPECT_NEAR(said["rates"][1]["hz"].get<double>(), 5.0, 0.1);
  EXPECT_EQ(first["ours"]["seen"], test::kPairs - 1) << "the first pair has nothing before it";
  EXPECT_LT(first["ours"]["ate_m"].get<double>(), 0.01) << "of 0.32 m";
  EXPECT_LT(first["klt_pnp"]["ate_m"].get<double>(), 0.05);
  EXPECT_GT(said["dense"]["ours_dense"].get<double>(), 0.5);
  EXPECT_GT(said["dense"]["within_1px_of_sgbm"].get<double>(), 0.9);
  EXPECT_TRUE(fs::exists(folder_ / "out/stereo.csv"));
  EXPECT_TRUE(fs::exists(folder_ / "out/series/stereo-2.json"));
}

TEST_F(StereoStudy, GoesOnWhereItWasStopped) {
  const Result<Ended> stopped = study(options(), test::kPairs + 2);
  ASSERT_TRUE(stopped) << stopped.error().message;
  EXPECT_EQ(*stopped, Ended::stopped);
  progress_.str("");
  ASSERT_TRUE(study(options()));
  EXPECT_THAT(progress_.str(), HasSubstr("3 rows to measure, 1 of them are there already"));
  const std::string said = out_.str();
  fs::remove_all(folder_ / "out");
  ASSERT_TRUE(study(options()));
  EXPECT_EQ(out_.str(), said) << "as measured at once";
}

TEST_F(StereoStudy, FollowsTheSameDriveAsKittiLaysItOut) {
  test::write_kitti(folder_ / "kitti", folder_ / "drive");
  StereoOptions kitti = options();
  kitti.folder = folder_ / "kitti";
  kitti.every = {};
  const Result<Ended> ended = study(kitti);
  ASSERT_TRUE(ended) << ended.error().message;
  const nlohmann::json said = nlohmann::json::parse(out_.str());
  ASSERT_EQ(said["rates"].size(), 1U);
  EXPECT_LT(said["rates"][0]["ours"]["ate_m"].get<double>(), 0.01);
  EXPECT_THAT(progress_.str(), HasSubstr("ten images a second"));
  test::write_text(folder_ / "kitti/poses.txt", test::kitti_poses(4));
  EXPECT_THAT(error_of(kitti).message, HasSubstr("poses.txt: has 4 poses and none for image 000004"));
  test::write_text(folder_ / "kitti/poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0\n");
  EXPECT_THAT(error_of(kitti).message, HasSubstr("poses.txt:2: 3 numbers"));
}

TEST_F(StereoStudy, ADamagedPairIsBlindAndTold) {
  const std::string broken = std::to_string(test::kBeganNs + 4 * test::kApartNs) + ".png";
  test::write_text(folder_ / "drive/mav0/cam1/data" / broken, "\x89PNG");
  StereoOptions damaged = options();
  damaged.every = {1};
  const Result<Ended> ended = study(damaged);
  ASSERT_TRUE(ended) << ended.error().message;
  const nlohmann::json said = nlohmann::json::parse(out_.str());
  EXPECT_EQ(said["rates"][0]["ours"]["seen"], test::kPairs - 2);
  EXPECT_LT(said["rates"][0]["ours"]["end_m"].get<double>(), 0.02) << "the next pair makes up for it";
  EXPECT_THAT(progress_.str(), HasSubstr(broken));
}

TEST_F(StereoStudy, WhatIsNoRecordingIsNamed) {
  StereoOptions bad = options();
  bad.folder = folder_ / "none";
  EXPECT_EQ(error_of(bad).code, ErrorCode::not_found);
  EXPECT_THAT(error_of(bad).message, HasSubstr("none: no such folder"));
  bad.folder = folder_;
  EXPECT_THAT(error_of(bad).message, HasSubstr("EuRoC's have mav0/cam0"));
  bad = options();
  fs::rename(folder_ / "drive/groundtruth_tum.txt", folder_ / "truth.txt");
  EXPECT_EQ(error_of(bad).code, ErrorCode::not_found);
  EXPECT_THAT(error_of(bad).message, HasSubstr("--truth"));
  bad.truth = folder_ / "truth.txt";
  EXPECT_TRUE(study(bad));
  test::write_text(folder_ / "truth.txt", "1 0 0 0 0 0 0 1\n2 0 0 0 0 0 0 1\n");
  bad.out = folder_ / "other";
  EXPECT_THAT(error_of(bad).message, HasSubstr("the truth is known for fewer than 5"));
  fs::remove(folder_ / "drive/mav0/cam1/sensor.yaml");
  EXPECT_THAT(error_of(bad).message, HasSubstr("sensor.yaml"));
}

TEST_F(StereoStudy, AnotherTruthIsAnotherStudy) {
  StereoOptions first = options();
  first.every = {2};
  ASSERT_TRUE(study(first));
  std::ofstream(folder_ / "drive/groundtruth_tum.txt", std::ios::app) << "1400000100 0 0 0 0 0 0 1\n";
  EXPECT_EQ(error_of(first).code, ErrorCode::conflict);
  EXPECT_THAT(error_of(first).message, HasSubstr("truth"));
}

TEST_F(StereoStudy, AnotherCalibrationIsAnotherStudy) {
  StereoOptions first = options();
  first.every = {2};
  ASSERT_TRUE(study(first));
  agents::CameraModel right = *test::small_sensor().right;
  right.distortion[3] += 1e-7;
  test::write_text(folder_ / "drive/mav0/cam1/sensor.yaml", camera_file_text(calibration_from(right), {}));
  EXPECT_EQ(error_of(first).code, ErrorCode::conflict);
  EXPECT_THAT(error_of(first).message, HasSubstr("calibration"));
}

TEST(StereoInvocation, FlagsAndDefaults) {
  const auto plain = std::get<StereoOptions>(parsed({"stereo", "data/euroc-mh01-600/"}));
  EXPECT_TRUE(plain.every.empty());
  EXPECT_FALSE(plain.is_quick);
  EXPECT_EQ(plain.out, "out/stereo/euroc-mh01-600");
  const auto given =
      std::get<StereoOptions>(parsed({"stereo", "a", "--every", "1,3", "--quick", "--json", "--out", "o"}));
  EXPECT_EQ(given.every, (std::vector<std::size_t>{1, 3}));
  EXPECT_TRUE(given.is_quick);
  EXPECT_TRUE(given.is_json);
  EXPECT_EQ(given.out, "o");
  EXPECT_EQ(std::get<NotRun>(parsed({"stereo"})).exit_code, 2);
  EXPECT_EQ(std::get<NotRun>(parsed({"stereo", "a", "--every", "0"})).exit_code, 2);
}

}  // namespace
}  // namespace weft::evaluate::stereo
