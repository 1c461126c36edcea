#include "agents/methods/topometric/content.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <limits>

#include "core/random.hpp"
#include "storage/clouds/cloud.hpp"

namespace weft::agents {
namespace {

using testing::HasSubstr;

/// Returns a place of three frames.
TopometricContent some_place(std::size_t points = 500, std::size_t features = 12) {
  Random random(1);
  TopometricContent content;
  content.rig = {320, 240, 208.0, 159.5, 119.5, 0.12, {}};
  content.rig.robot_from_camera.translation = {0.15, 0.06, 0.45};
  content.floor.level_from_odometry.rotation = Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitY());
  content.floor.level_from_odometry.translation.z() = 0.004;
  content.floor.points = 321;
  content.clear_m = 4.5F;
  for (int i = 0; i < 3; ++i) {
    content.cloud.place_from_frames.push_back(lift(Pose2{-0.12 * i, 0.0, 0.02 * i}));
    content.cloud.cameras.emplace_back(0.15F - 0.12F * static_cast<float>(i), 0.06F, 0.45F);
    content.cloud.clear_bearings.push_back(0x8000'0000'0000'0001U << static_cast<unsigned>(i));
  }
  const auto draw = [&](double low, double high) { return static_cast<float>(random.uniform(low, high)); };
  for (std::size_t i = 0; i < points; ++i) {
    content.cloud.points.emplace_back(draw(0.5, 5.0), draw(-3.0, 3.0), draw(0.0, 2.2));
    content.cloud.frames.push_back(static_cast<std::uint16_t>(random.below(3)));
  }
  for (std::size_t i = 0; i < features; ++i)
    content.features.push_back({{draw(0.5, 9.0), draw(-3.0, 3.0), draw(0.0, 2.2)},
                                draw(0.01, 0.5),
                                {random.next(), random.next(), random.next(), random.next()}});
  return content;
}

/// Returns the canonical bytes with what is attached replaced.
Bytes with_attached(const Bytes& bytes, const std::function<void(Bytes&)>& change) {
  auto lattice = clouds::decode_cloud(bytes);
  change(lattice->cloud.attached);
  return *clouds::canonical_bytes(lattice->cloud, lattice->quantum_um);
}

std::string why_refused(const Bytes& bytes) {
  const auto content = decode_topometric_content(bytes);
  return content ? "" : content.error().message;
}

TEST(TopometricContent, IsACloudThatComesBack) {
  const TopometricContent content = some_place();
  const Bytes bytes = encode_topometric_content(content);
  EXPECT_TRUE(clouds::is_cloud(bytes));
  const auto again = decode_topometric_content(bytes);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(encode_topometric_content(*again), bytes) << "canonical";
  ASSERT_EQ(again->cloud.points.size(), content.cloud.points.size());
  EXPECT_EQ(again->cloud.cameras, content.cloud.cameras);
  EXPECT_EQ(again->cloud.clear_bearings, content.cloud.clear_bearings);
  EXPECT_EQ(again->clear_m, 4.5F);
  EXPECT_EQ(again->floor.points, 321U);
  EXPECT_EQ(again->rig.width, 320);
  EXPECT_EQ(again->rig.baseline_m, 0.12);
  ASSERT_EQ(again->features.size(), content.features.size());
  for (std::size_t i = 0; i < content.features.size(); ++i) {
    EXPECT_EQ(again->features[i].descriptor, content.features[i].descriptor);
    EXPECT_LT((again->features[i].in_place - content.features[i].in_place).norm(), 0.001F);
  }
}

TEST(TopometricContent, PointsKeepTheirFramesWhateverTheirOrder) {
  const TopometricContent content = some_place();
  TopometricContent turned = content;
  std::reverse(turned.cloud.points.begin(), turned.cloud.points.end());
  std::reverse(turned.cloud.frames.begin(), turned.cloud.frames.end());
  EXPECT_EQ(encode_topometric_content(turned), encode_topometric_content(content));
  const auto again = decode_topometric_content(encode_topometric_content(content));
  ASSERT_TRUE(again);
  for (std::size_t i = 0; i < content.cloud.points.size(); ++i) {
    float nearest = 1.0F;
    std::uint16_t frame = 99;
    for (std::size_t j = 0; j < again->cloud.points.size(); ++j) {
      const float away = (again->cloud.points[j] - content.cloud.points[i]).norm();
      if (away >= nearest) continue;
      nearest = away;
      frame = again->cloud.frames[j];
    }
    ASSERT_LT(nearest, 0.0045F) << i;
    ASSERT_EQ(frame, content.cloud.frames[i]) << i;
  }
}

TEST(TopometricContent, EveryTruncationIsRefused) {
  const Bytes bytes = encode_topometric_content(some_place(40, 3));
  for (std::size_t size = 0; size < bytes.size(); ++size)
    ASSERT_FALSE(decode_topometric_content(ByteView(bytes).first(size))) << size;
  const Bytes shorter = with_attached(bytes, [](Bytes&) {});
  ASSERT_EQ(shorter, bytes);
  const std::size_t attached = clouds::decode_cloud(bytes)->cloud.attached.size();
  for (std::size_t size = 0; size < attached; ++size)
    ASSERT_FALSE(decode_topometric_content(with_attached(bytes, [&](Bytes& all) { all.resize(size); }))) << size;
}

TEST(TopometricContent, NoChangedByteDoesHarm) {
  const Bytes bytes = encode_topometric_content(some_place(20, 2));
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (const unsigned mask : {0x01U, 0x80U, 0xffU}) {
      Bytes changed = bytes;
      changed[at] = static_cast<std::uint8_t>(changed[at] ^ mask);
      const auto content = decode_topometric_content(changed);  // refused, or another place
      if (content) {
        EXPECT_EQ(content->cloud.points.size(), content->cloud.frames.size());
      }
    }
  }
}

TEST(TopometricContent, WhatIsWrongIsNamed) {
  const Bytes bytes = encode_topometric_content(some_place());
  const std::size_t at = bytes.size() - clouds::decode_cloud(bytes)->cloud.attached.size();
  EXPECT_THAT(why_refused(with_attached(bytes, [](Bytes& all) { all[0] = 'X'; })),
              HasSubstr("magic at offset " + std::to_string(at)));
  EXPECT_THAT(why_refused(with_attached(bytes, [](Bytes& all) { all.push_back(0); })), HasSubstr("more bytes"));
  EXPECT_THAT(why_refused(with_attached(bytes, [](Bytes& all) { all[164] = 33; })), HasSubstr("frames.count"));
  EXPECT_THAT(why_refused(with_attached(bytes, [](Bytes& all) { all[163] = 0x7f; })), HasSubstr("clear_m"));
  const Bytes newer = with_attached(bytes, [](Bytes& all) { all[4] = 2; });
  EXPECT_EQ(decode_topometric_content(newer).error().code, ErrorCode::newer);
  TopometricContent foreign = some_place();
  foreign.cloud.frames[7] = 3;
  EXPECT_THAT(why_refused(encode_topometric_content(foreign)), HasSubstr("of frame 3, and 3 frames"));
  foreign = some_place();
  foreign.cloud.points[7].x() = 150.0F;
  EXPECT_THAT(why_refused(encode_topometric_content(foreign)), HasSubstr("beyond 100 m"));
  const clouds::Cloud fine{{{1.0F, 2.0F, 0.5F}}, {0}, {}};
  EXPECT_THAT(why_refused(*clouds::canonical_bytes(fine, 1100)), HasSubstr("1100 um, must be 5000"));
}

TEST(TopometricContent, WhatIsNoCloudOfFinitePointsIsEncodedAsNothing) {
  TopometricContent content = some_place();
  content.cloud.points.front().x() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(encode_topometric_content(content).empty());
}

}  // namespace
}  // namespace weft::agents
