#include "storage/formats/trajectory.hpp"

#include <gtest/gtest.h>

namespace weft::formats {
namespace {

TEST(Tum, ReadsPosesAndLeavesCommentsOut) {
  const auto read = read_tum("# t x y z\n\n1.5 1 2 3 0 0 1 0\n2.5 4 5 6 0 0 0 1\n", "t.tum");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  ASSERT_EQ(read->value.samples.size(), 2U);
  EXPECT_EQ(read->value.samples[0].time_s, 1.5);
  EXPECT_EQ(read->value.samples[0].frame_from_body.rotation.z(), 1.0);
  EXPECT_EQ(read->value.samples[1].frame_from_body.translation, Eigen::Vector3d(4, 5, 6));
}

TEST(Tum, ASecondPoseOfOneTimeIsLeftOutAndListed) {
  const auto read = read_tum("1 1 2 3 0 0 0 1\n1 9 9 9 0 0 0 1\n", "t.tum");
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->value.samples.size(), 1U);
  EXPECT_EQ(read->not_understood, (std::vector<NotUnderstood>{{"a second pose of one time", 2, 1}}));
}

TEST(Tum, WhatIsWrongIsSaidWithItsLine) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {"1 2 3\n", "t.tum:1: 3 numbers; a pose has 8: t x y z qx qy qz qw"},
      {"# x\n1 1 2 3 0 0 0 one\n", "t.tum:2: 'one' is no finite number"},
      {"1 1 2 inf 0 0 0 1\n", "t.tum:1: 'inf' is no finite number"},
      {"1403636579763555584.000000 1 2 3 0 0 0 1\n",
       "t.tum:1: time 1403636579763555584.000000 is not within +-1e10 s; these seem to be nanoseconds; divide them "
       "by "
       "1e9"},
      {"1403636579763555 1 2 3 0 0 0 1\n",
       "t.tum:1: time 1403636579763555 is not within +-1e10 s; these seem to be microseconds; divide them by 1e6"},
      {"# ms\n1403636579763 1 2 3 0 0 0 1\n",
       "t.tum:2: time 1403636579763 is not within +-1e10 s; these seem to be milliseconds, or nanoseconds since a "
       "start; turn them into seconds"},
      {"2 1 2 3 0 0 0 1\n1 1 2 3 0 0 0 1\n", "t.tum:2: time 1 is before the last one, 2"},
      {"1 1 2 3 0 0 0 1.01\n", "t.tum:1: the quaternion is not unit within 1e-3"}};
  for (const auto& [text, message] : table) {
    const auto read = read_tum(text, "t.tum");
    ASSERT_FALSE(read.has_value()) << message;
    EXPECT_EQ(read.error().message, message);
  }
}

TEST(EurocCsv, HasNanosecondsAndWFirst) {
  const auto read = read_euroc_csv("#time, ...\n1500000000, 1, 2, 3, 0, 1, 0, 0\n", "d.csv");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  EXPECT_EQ(read->value.samples[0].time_s, 1.5);
  EXPECT_EQ(read->value.samples[0].frame_from_body.rotation.x(), 1.0);
  EXPECT_TRUE(read->not_understood.empty());
  EXPECT_EQ(read_euroc_csv("1.5,1,2,3,1,0,0,0\n", "d.csv").error().message,
            "d.csv:1: '1.5' is no time in whole nanoseconds");
}

}  // namespace
}  // namespace weft::formats
