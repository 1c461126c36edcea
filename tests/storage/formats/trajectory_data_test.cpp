#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "storage/formats/trajectory.hpp"
#include "tests/storage/formats/data_files.hpp"

namespace weft::formats::test {
namespace {

/// Lists all trajectories in TUM's format that are there, and how many poses of each repeat the time before.
const std::map<std::string, std::size_t> kTum = {
    {"euroc-gt/V1_01_easy.txt.gz", 0U},
    {"euroc-gt/V2_01_easy.txt.gz", 0U},
    {"euroc-mh01-600/groundtruth_tum.txt", 0U},
    {"evo-reference/V102.txt", 4U},
    {"evo-reference/fr2_desk_ORB.txt", 0U},
    {"evo-reference/fr2_desk_ORB_kf_mono.txt", 0U},
    {"evo-reference/fr2_desk_groundtruth.txt", 1U},
    {"rpg-traj-eval/laptop/vio_mono/laptop_vio_mono_V2_01/stamped_traj_estimate.txt", 0U},
    {"rpg-traj-eval/laptop/vio_stereo/laptop_vio_stereo_V2_01/stamped_traj_estimate.txt", 0U}};

std::size_t rows_of(const std::string& text) {
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  return lines + (text.ends_with('\n') ? 0 : 1) - lines_with(text, "#");
}

TEST(TrajectoryFiles, EveryTumFileIsReadAndWrittenTheSame) {
  const auto data = data_folder();
  if (!data) GTEST_SKIP() << no_data("trajectories");
  for (const auto& [name, repeated] : kTum) {
    if (!std::filesystem::exists(*data / name)) GTEST_SKIP() << no_data(name);
    const std::string text = read_text(*data / name);
    const auto first = read_tum(text, name);
    ASSERT_TRUE(first.has_value()) << first.error().message;
    EXPECT_EQ(first->value.samples.size(), rows_of(text) - repeated) << name;
    EXPECT_EQ(first->not_understood.size(), repeated > 0 ? 1U : 0U) << name;
    for (const NotUnderstood& part : first->not_understood) EXPECT_EQ(part.count, repeated) << name;
    const auto second = read_tum(tum_text(first->value), "written");
    ASSERT_TRUE(second.has_value()) << second.error().message;
    ASSERT_EQ(first->value.samples.size(), second->value.samples.size());
    for (std::size_t i = 0; i < first->value.samples.size(); ++i) {
      ASSERT_EQ(first->value.samples[i].time_s, second->value.samples[i].time_s);
      ASSERT_EQ(first->value.samples[i].frame_from_body.translation,
                second->value.samples[i].frame_from_body.translation);
      ASSERT_EQ(first->value.samples[i].frame_from_body.rotation.coeffs(),
                second->value.samples[i].frame_from_body.rotation.coeffs());
    }
  }
}

TEST(TrajectoryFiles, EurocsTruthSaysTheSameInBothFormats) {
  const auto data = data_folder();
  const std::string name = "evo-reference/V102_groundtruth.csv";
  if (!data || !std::filesystem::exists(*data / name)) GTEST_SKIP() << no_data(name);
  const std::string text = read_text(*data / name);
  const auto read = read_euroc_csv(text, name);
  ASSERT_TRUE(read.has_value()) << read.error().message;
  EXPECT_EQ(read->value.samples.size(), 16702U);  // rows of the file without its heading
  ASSERT_EQ(read->not_understood.size(), 1U);
  EXPECT_EQ(read->not_understood[0].line, 2U);
  EXPECT_EQ(read->not_understood[0].count, 16702U);
  const Pose3& first = read->value.samples.front().frame_from_body;
  EXPECT_NEAR(read->value.samples.front().time_s, 1403715524.907143168, 1e-6);
  EXPECT_EQ(first.translation.x(), 0.515356);
  EXPECT_NEAR(first.rotation.w(), 0.161996, 1e-6);
  EXPECT_NEAR(first.rotation.x(), 0.789985, 1e-6);
}

TEST(TrajectoryFiles, AListOfImagesIsNoTrajectory) {
  const auto data = data_folder();
  const std::string name = "euroc-mh01-600/cam0_data.csv";
  if (!data || !std::filesystem::exists(*data / name)) GTEST_SKIP() << no_data(name);
  const auto read = read_euroc_csv(read_text(*data / name), name);
  ASSERT_FALSE(read.has_value());
  EXPECT_EQ(read.error().message,
            "euroc-mh01-600/cam0_data.csv:2: 2 cells; a pose has 8: nanoseconds, x, y, z, qw, qx, qy, qz");
}

}  // namespace
}  // namespace weft::formats::test
