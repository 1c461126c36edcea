#include "agents/methods/floor/content.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/flat_floor.hpp"

namespace weft::agents {
namespace {

FloorContent example(std::size_t features) {
  Random random(31);
  FloorContent content;
  content.camera = test::miscalibrated(test::paper_camera(), 4);
  content.attitude = {0.001, -0.002, 0.0005};
  content.attitude_sigma = {0.001, 0.001, 0.002};
  for (std::size_t i = 0; i < features; ++i) {
    PlaneFeature f;
    f.on_plane = {random.uniform(0.2, 1.5), random.uniform(-0.9, 0.9)};
    f.heading_rad = random.uniform(-3.1, 3.1);
    for (std::uint64_t& word : f.descriptor) word = random.next();
    content.features.push_back(f);
  }
  content.patch = {4, 3, 0.018, {1.4, 0.8}, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}};
  return content;
}

TEST(FloorContentBytes, RoundTrip) {
  const FloorContent before = example(50);
  const Bytes bytes = encode_floor_content(before);
  const auto after = decode_floor_content(bytes);
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(encode_floor_content(*after), bytes) << "canonical: the bytes of what was read are the bytes";
  EXPECT_EQ(after->camera.id, before.camera.id);
  EXPECT_EQ(after->camera.fx, before.camera.fx);
  ASSERT_EQ(after->features.size(), 50U);
  for (std::size_t i = 0; i < 50; ++i) {
    EXPECT_LT((after->features[i].on_plane - before.features[i].on_plane).norm(), 1e-4);
    EXPECT_LT(std::abs(wrap_angle(after->features[i].heading_rad - before.features[i].heading_rad)), 0.013);
    EXPECT_EQ(after->features[i].descriptor, before.features[i].descriptor);
  }
  EXPECT_EQ(after->patch.pixels, before.patch.pixels);
}

TEST(FloorContentBytes, AnEquidistantLensComesBack) {
  FloorContent before = example(3);
  before.camera.lens = LensModel::equidistant;
  const auto after = decode_floor_content(encode_floor_content(before));
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(after->camera.lens, LensModel::equidistant);
  EXPECT_EQ(after->camera.width, before.camera.width);
}

TEST(FloorContentBytes, ARationalLensComesBackWithItsDivisor) {
  FloorContent before = example(3);
  before.camera.lens = LensModel::rational;
  before.camera.distortion = {1.31, 0.02, 0.0004, -0.0003, 0.01};
  before.camera.divisor = {1.38, 0.05, 0.02};
  const Bytes bytes = encode_floor_content(before);
  EXPECT_EQ(bytes.size(), encode_floor_content(example(3)).size() + 3 * 8);
  const auto after = decode_floor_content(bytes);
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(after->camera.lens, LensModel::rational);
  EXPECT_EQ(after->camera.width, before.camera.width);
  EXPECT_EQ(after->camera.distortion, before.camera.distortion);
  EXPECT_EQ(after->camera.divisor, before.camera.divisor);
  EXPECT_EQ(encode_floor_content(*after), bytes);
}

TEST(FloorContentBytes, LayoutIsTheDocumented) {
  const Bytes bytes = encode_floor_content(example(2));
  EXPECT_EQ((Bytes(bytes.begin(), bytes.begin() + 8)), (Bytes{'W', 'L', 'F', 'R', 1, 0, 0, 0}));
  const std::size_t id = example(2).camera.id.size();
  // docs/formats/floor-content.md: header, camera, attitude, features, patch.
  EXPECT_EQ(bytes.size(), 8 + (1 + id + 4 + 16 * 8) + 6 * 8 + (2 + 2 * 37) + (4 + 3 * 8 + 12));
}

TEST(FloorContentBytes, EveryTruncationIsCorrupt) {
  const Bytes bytes = encode_floor_content(example(3));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const auto decoded = decode_floor_content(ByteView(bytes).first(size));
    ASSERT_FALSE(decoded) << size;
    EXPECT_EQ(decoded.error().code, ErrorCode::corrupt);
    EXPECT_THAT(decoded.error().message, testing::HasSubstr("offset"));
  }
}

TEST(FloorContentBytes, TrailingBytesAreCorrupt) {
  Bytes bytes = encode_floor_content(example(3));
  bytes.push_back(0);
  EXPECT_EQ(decode_floor_content(bytes).error().code, ErrorCode::corrupt);
}

TEST(FloorContentBytes, ALaterFormatIsNewer) {
  Bytes bytes = encode_floor_content(example(3));
  bytes[4] = 2;
  EXPECT_EQ(decode_floor_content(bytes).error().code, ErrorCode::newer);
}

TEST(FloorContentBytes, DamageNeverGivesImpossibleValues) {
  const Bytes good = encode_floor_content(example(5));
  Random random(32);
  int refused = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    Bytes bytes = good;
    for (int k = 0; k < 3; ++k) bytes[random.below(bytes.size())] = static_cast<std::uint8_t>(random.below(256));
    const auto decoded = decode_floor_content(bytes);
    if (!decoded) {
      ++refused;
      continue;
    }
    EXPECT_TRUE(decoded->attitude.vector().allFinite());
    EXPECT_GT(decoded->attitude_sigma.minCoeff(), 0.0);
    EXPECT_LE(decoded->features.size(), most_floor_features);
    EXPECT_EQ(decoded->patch.pixels.size(), static_cast<std::size_t>(decoded->patch.width * decoded->patch.height));
  }
  EXPECT_GT(refused, 300);
}

}  // namespace
}  // namespace weft::agents
