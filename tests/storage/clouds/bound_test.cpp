// What is kept of a cloud, and what is refused.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <map>

#include "storage/clouds/cloud.hpp"
#include "tests/storage/clouds/sample_clouds.hpp"

namespace weft::clouds {
namespace {

using testing::HasSubstr;

/// Returns the bound on a coordinate's error that docs/formats/cloud.md states, in metres: quantum / 2 + |x| 2^-24.
double bound(double x, std::uint32_t quantum_um) {
  return quantum_um * 0.5e-6 * (1.0 + 1e-9) + std::abs(x) * 0x1p-24;
}

bool is_within(const Eigen::Vector3f& a, const Eigen::Vector3f& b, std::uint32_t quantum_um) {
  for (int axis = 0; axis < 3; ++axis) {
    const double x = static_cast<double>(a[axis]);
    if (std::abs(x - static_cast<double>(b[axis])) > bound(x, quantum_um)) return false;
  }
  return true;
}

/// Gives each point a value that occurs once, so that points can be told apart whatever their order.
Cloud numbered(Cloud cloud) {
  for (std::size_t at = 0; at < cloud.points.size(); ++at) cloud.values.push_back(static_cast<std::uint16_t>(at));
  return cloud;
}

TEST(CloudBound, EveryPointIsKeptWithinHalfAQuantumAndItsValueExactly) {
  for (const std::uint32_t quantum_um : {25U, 100U, kFineQuantum_um, 2000U, 50'000U, kLargestQuantum_um}) {
    const Cloud cloud = numbered(sample::room(quantum_um, 20'000, 0));
    const auto canonical = canonical_bytes(cloud, quantum_um);
    ASSERT_TRUE(canonical) << canonical.error().message;
    const auto decoded = decode_cloud(*canonical);
    ASSERT_TRUE(decoded) << decoded.error().message;
    EXPECT_EQ(decoded->quantum_um, quantum_um);
    std::map<std::uint16_t, Eigen::Vector3f> kept;
    for (std::size_t at = 0; at < decoded->cloud.points.size(); ++at) {
      kept[decoded->cloud.values[at]] = decoded->cloud.points[at];
    }
    ASSERT_EQ(kept.size(), cloud.points.size());
    std::size_t beyond = 0;
    for (std::size_t at = 0; at < cloud.points.size(); ++at) {
      beyond += is_within(cloud.points[at], kept[cloud.values[at]], quantum_um) ? 0U : 1U;
    }
    EXPECT_EQ(beyond, 0U) << "quantum " << quantum_um;
  }
}

TEST(CloudBound, TheFineQuantumIsWithinAMillimetreInDistance) {
  Random random(5);
  for (int at = 0; at < 20'000; ++at) {
    const Eigen::Vector3f point =
        Eigen::Vector3d(random.uniform(-256.0, 256.0), random.uniform(-256.0, 256.0), random.uniform(-256.0, 256.0))
            .cast<float>();
    const auto decoded = decode_cloud(canonical_bytes(sample::of_points({point}), kFineQuantum_um).value());
    ASSERT_LE((decoded->cloud.points[0].cast<double>() - point.cast<double>()).norm(), 1e-3);
  }
}

TEST(CloudBound, TheFarthestCoordinatesAreKeptAndTheNextRefused) {
  const float last = 8388.6064F;
  for (const float x : {last, -last}) {
    const auto decoded = decode_cloud(canonical_bytes(sample::of_points({{x, 0, 0}}), 1000).value());
    EXPECT_TRUE(is_within(decoded->cloud.points[0], {x, 0, 0}, 1000));
  }
  const auto refused = canonical_bytes(sample::of_points({{0, 0, 0}, {0, -8388.7F, 0}}), 1000);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::invalid);
  EXPECT_THAT(refused.error().message, HasSubstr("point 1: y is -8388.7"));
  EXPECT_THAT(refused.error().message, HasSubstr("at most 8388.607"));
}

TEST(CloudBound, ACloudWiderThanItsCodesIsRefused) {
  const float widest = 0.001F * ((1 << 21) - 1);
  EXPECT_TRUE(canonical_bytes(sample::of_points({{0, 0, -1}, {0, 0, widest - 1}}), 1000));
  const auto refused = canonical_bytes(sample::of_points({{0, 0, -1}, {0, 0, widest - 0.999F}}), 1000);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::invalid);
  EXPECT_THAT(refused.error().message, HasSubstr("spans 2097.1"));
  EXPECT_THAT(refused.error().message, HasSubstr("in z"));
}

TEST(CloudBound, WhatIsNotFiniteIsRefusedByIndex) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()}) {
    const auto refused = canonical_bytes(sample::of_points({{1, 2, 3}, {1, 2, 3}, {4, 5, bad}}), kFineQuantum_um);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::invalid);
    EXPECT_THAT(refused.error().message, HasSubstr("point 2: z is "));
    EXPECT_THAT(refused.error().message, HasSubstr("finite"));
  }
}

TEST(CloudBound, QuantaAndCountsOutOfRangeAreRefused) {
  const Cloud cloud = sample::room(1, 10, 5);
  EXPECT_THAT(canonical_bytes(cloud, 0).error().message, HasSubstr("quantum is 0 um"));
  EXPECT_THAT(canonical_bytes(cloud, kLargestQuantum_um + 1).error().message, HasSubstr("quantum is 1000001 um"));
  Cloud short_of_values = cloud;
  short_of_values.values.pop_back();
  EXPECT_THAT(canonical_bytes(short_of_values, 1000).error().message, HasSubstr("9 values for 10 points"));
  const Cloud too_large = sample::of_points(std::vector<Eigen::Vector3f>(8'388'604, Eigen::Vector3f::Zero()));
  const auto refused = canonical_bytes(too_large, 1000);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::exhausted);
  EXPECT_THAT(refused.error().message, HasSubstr("at most 8388603"));
  Cloud laden = cloud;
  laden.attached = Bytes((64U << 20U) - 33 - 10 * 9);
  EXPECT_TRUE(canonical_bytes(laden, 1000));
  laden.attached.push_back(0);
  EXPECT_THAT(canonical_bytes(laden, 1000).error().message, HasSubstr("10 points, a content holds at most 9 beside"));
  laden.attached.resize(64U << 20U);
  EXPECT_THAT(canonical_bytes(laden, 1000).error().message, HasSubstr("67108864 bytes are attached"));
}

}  // namespace
}  // namespace weft::clouds
