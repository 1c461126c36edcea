// On photographs of real floors, where ../shared/data (or WEFT_DATA) is present.
#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <opencv2/core.hpp>
#include <string>

#include "agents/methods/floor/floor.hpp"
#include "core/config/config.hpp"
#include "images/read.hpp"
#include "tests/storage/temporary_directory.hpp"
#include "tests/support/floor_drive.hpp"

namespace weft::agents {
namespace {

/// Names a picture of a folder that says how large its pictures are (floors.toml).
struct Photograph {
  const char* folder;  ///< "textures": as tests/floor-textures makes one of them
  const char* name;
};
void PrintTo(const Photograph& p, std::ostream* out) {
  *out << p.folder << '/' << p.name;
}

std::filesystem::path data_folder() {
  const char* given = std::getenv("WEFT_DATA");
  return given != nullptr ? std::filesystem::path(given)
                          : std::filesystem::path(WEFT_SOURCE_DIR).parent_path() / "shared" / "data";
}

class OnPhotographs : public testing::TestWithParam<Photograph> {
 protected:
  void SetUp() override {
    std::filesystem::path folder = data_folder() / GetParam().folder;
    if (!std::filesystem::exists(folder))
      GTEST_SKIP() << "NOT TESTED: " << folder << " is absent; set WEFT_DATA to the folder that holds "
                   << GetParam().folder << '/';
    if (std::string_view(GetParam().folder) == "textures") {
      folder = made_.path() / "floors";
      const std::string make = std::string(WEFT_SOURCE_DIR) + "/tests/floor-textures " + folder.string();
      ASSERT_EQ(std::system(make.c_str()), 0) << make;
    }
    std::ifstream list(folder / "floors.toml");
    const std::string text{std::istreambuf_iterator<char>(list), {}};
    const config::Table all = config::parse(text, (folder / "floors.toml").string());
    const config::Table floor = all.table(GetParam().name);
    const std::string file = (folder / floor.text("file", "")).string();
    const double mm_per_pixel = floor.number("mm_per_pixel", 0.0, 0.0, 100.0);
    ASSERT_GT(mm_per_pixel, 0.0) << folder << " says nothing of " << GetParam().name;
    auto picture = images::read(file, images::Shades::grey);
    ASSERT_TRUE(picture) << picture.error().message;
    const cv::Mat grey(picture->height, picture->width, CV_8U, picture->samples.data());
    floor_ = std::make_unique<test::FlatFloor>(test::FlatFloor::quilted(grey, 1e-3 * mm_per_pixel, 5, 7.0, 5.0));
    auto made = Floor::make({}, test::miscalibrated(test::paper_camera(), 6));
    ASSERT_TRUE(made);
    method_ = std::make_unique<Floor>(*made);
  }
  storage::TemporaryDirectory made_;
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

std::string name_of(const testing::TestParamInfo<Photograph>& floor) {
  std::string name = floor.param.name;
  std::erase_if(name, [](char letter) { return std::isalnum(static_cast<unsigned char>(letter)) == 0; });
  return name;
}

INSTANTIATE_TEST_SUITE_P(Floors, OnPhotographs,
                         testing::Values(Photograph{"floors", "concrete"}, Photograph{"floors", "tarmac"},
                                         Photograph{"floors", "asphalt"}, Photograph{"floors", "carpet"}),
                         name_of);

INSTANTIATE_TEST_SUITE_P(Textures, OnPhotographs,
                         testing::Values(Photograph{"textures", "warehouse_floor"}, Photograph{"textures", "asphalt"},
                                         Photograph{"textures", "Wood_OSB"}, Photograph{"textures", "tarmac"},
                                         Photograph{"textures", "Carpet_Berber_Pattern_Gray_"},
                                         Photograph{"textures", "Stone_Brushed_Khaki_"},
                                         Photograph{"textures", "Wood_Bamboo_Medium_"},
                                         Photograph{"textures", "__Wood_Bamboo_Medium_1"},
                                         Photograph{"textures", "Wood_Cherry_Original_"},
                                         Photograph{"textures", "aws_robomaker_warehouse_GroundB_01"}),
                         name_of);

}  // namespace
}  // namespace weft::agents
