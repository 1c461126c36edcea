// On photographs of real floors, where ../shared/data (or WEFT_DATA) is present.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>

#include "agents/methods/floor/floor.hpp"
#include "tests/support/floor_drive.hpp"

namespace weft::agents {
namespace {

struct Photograph {
  const char* file;
  double metres_per_pixel;  ///< as floors.toml says
};
void PrintTo(const Photograph& p, std::ostream* out) {
  *out << p.file;
}

std::filesystem::path data_folder() {
  const char* given = std::getenv("WEFT_DATA");
  return given != nullptr ? std::filesystem::path(given)
                          : std::filesystem::path(WEFT_SOURCE_DIR).parent_path() / "shared" / "data";
}

class OnPhotographs : public testing::TestWithParam<Photograph> {
 protected:
  void SetUp() override {
    const std::filesystem::path file = data_folder() / "floors" / GetParam().file;
    if (!std::filesystem::exists(file))
      GTEST_SKIP() << "NOT TESTED: " << file << " is absent; set WEFT_DATA to the folder that holds floors/";
    const cv::Mat grey = cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
    ASSERT_FALSE(grey.empty()) << file;
    floor_ =
        std::make_unique<test::FlatFloor>(test::FlatFloor::quilted(grey, GetParam().metres_per_pixel, 5, 7.0, 5.0));
    auto made = Floor::make({}, test::miscalibrated(test::paper_camera(), 6));
    ASSERT_TRUE(made);
    method_ = std::make_unique<Floor>(*made);
  }
  std::unique_ptr<test::FlatFloor> floor_;
  std::unique_ptr<Floor> method_;
  test::FloorCamera eye_{test::paper_camera()};
};

TEST_P(OnPhotographs, Odometry) {
  test::Drive how;
  how.duration_s = 2.0;
  const test::Driven run = test::drive(*method_, eye_, *floor_, how);
  RecordProperty("distance_error_percent", std::to_string(100.0 * run.distance_error()));
  EXPECT_LE(run.blind, 2);
  EXPECT_LT(std::abs(run.distance_error()), 0.025);  // calibration of 1 sigma included
  EXPECT_LT(run.heading_error_deg_per_m(), 0.25);
}

TEST_P(OnPhotographs, RelatesInOtherLightAndRefusesOtherFloor) {
  Random random(51);
  const Pose2 at{2.2, 2.4, 0.3};
  const auto a = test::look(*method_, eye_, *floor_, at, {}, {});
  ASSERT_TRUE(a) << a.error().reason;
  test::Shot other;
  other.gain = 0.5;
  int related = 0;
  for (const Pose2& a_from_b :
       {Pose2{0.1, 0.05, 0.05}, Pose2{0.25, 0.0, -0.1}, Pose2{-0.2, 0.1, 0.2}, Pose2{0.4, 0.1, 0.2}}) {
    other.seed++;
    const auto b = test::look(*method_, eye_, *floor_, at * a_from_b, {}, other);
    ASSERT_TRUE(b) << b.error().reason;
    const Pose2 guess =
        a_from_b * Pose2{random.uniform(-0.06, 0.06), random.uniform(-0.06, 0.06), random.uniform(-0.1, 0.1)};
    const auto found = method_->relate(*a, *b, Metric2{guess, Eigen::Matrix3d::Zero()});
    if (!found) continue;
    ++related;
    const Pose2 off = a_from_b.inverse() * planar(found->a_from_b);
    EXPECT_LT(off.translation().norm(), 0.03);
    EXPECT_LT(std::abs(off.heading) * 180.0 / M_PI, 1.0);
  }
  EXPECT_GE(related, 3);
  const auto elsewhere = test::look(*method_, eye_, *floor_, {4.6, 2.4, 0.3}, {}, other);
  ASSERT_TRUE(elsewhere);
  EXPECT_FALSE(method_->relate(*a, *elsewhere, std::nullopt));
  EXPECT_FALSE(method_->relate(*a, *elsewhere, Metric2{}));
}

INSTANTIATE_TEST_SUITE_P(Floors, OnPhotographs,
                         testing::Values(Photograph{"concrete.png", 0.0009}, Photograph{"tarmac.png", 0.0005},
                                         Photograph{"asphalt.jpg", 0.0006}, Photograph{"carpet.png", 0.001}),
                         [](const auto& floor) {
                           const std::string file = floor.param.file;
                           return file.substr(0, file.find('.'));
                         });

}  // namespace
}  // namespace weft::agents
