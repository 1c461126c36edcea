#include <gmock/gmock.h>

#include "storage/clouds/cloud.hpp"
#include "storage/clouds/morton.hpp"
#include "tests/storage/clouds/sample_clouds.hpp"

namespace weft::clouds {
namespace {

TEST(CanonicalCloud, BytesAreThoseOfTheDocument) {
  const Cloud cloud{{{0.003F, 0.0F, 0.0F}, {0.001F, -0.002F, 0.001F}}, {7, 300}, {9, 8, 7}};
  const Bytes expected{'W',  'E', 'F', 'T', 'C',  'L',  'D',  2,                 // magic, format
                       0xe8, 3,   0,   0,                                        // 1000 um
                       1,    0,   0,   0,   0xfe, 0xff, 0xff, 0xff, 0, 0, 0, 0,  // origin 1, -2, 0
                       2,    2,   0,   0,   0,                                   // value bytes, count
                       3,    0,   0,   0,                                        // attached
                       4,    0,   0,   0,   0,    0,    0,    0,                 // cell 0, 0, 1
                       24,   0,   0,   0,   0,    0,    0,    0,                 // cell 2, 2, 0
                       0x2c, 1,   7,   0,   9,    8,    7};
  EXPECT_EQ(canonical_bytes(cloud, 1000).value(), expected);
}

TEST(CanonicalCloud, TheOrderOfThePointsDoesNotMatter) {
  for (const std::uint64_t values_below : {0U, 4U, 60'000U}) {
    Cloud cloud = sample::room(3, 5000, values_below);
    cloud.points.insert(cloud.points.end(), cloud.points.begin(),
                        cloud.points.begin() + 1000);  // twice, other values
    if (values_below > 0)
      cloud.values.insert(cloud.values.end(), cloud.values.rbegin(), cloud.values.rbegin() + 1000);
    const Bytes bytes = canonical_bytes(cloud, kFineQuantum_um).value();
    EXPECT_EQ(canonical_bytes(sample::shuffled(cloud, 9), kFineQuantum_um).value(), bytes);
    EXPECT_EQ(decode_cloud(bytes)->cloud.points.size(), 6000U);
  }
}

TEST(CanonicalCloud, WhatWasReadHasTheSameBytesAgain) {
  for (const std::uint32_t quantum_um : {25U, kFineQuantum_um, 30'000U}) {
    const Bytes bytes = canonical_bytes(sample::room(4, 5000, 256), quantum_um).value();
    EXPECT_EQ(canonical_bytes(decode_cloud(bytes)->cloud, quantum_um).value(), bytes);
  }
  // Where a float is coarsest beside the quantum.
  Cloud far;
  for (int at = 0; at < 2000; ++at)
    far.points.emplace_back(8388.0F - 0.37F * static_cast<float>(at), -8000.3F, 8388.6F);
  const Bytes bytes = canonical_bytes(far, 1000).value();
  EXPECT_EQ(canonical_bytes(decode_cloud(bytes)->cloud, 1000).value(), bytes);
}

TEST(CanonicalCloud, WhatIsAttachedComesBackAndIsHashedWithThePoints) {
  for (const std::size_t points : {0U, 1U, 900U}) {
    for (const std::uint64_t values_below : {0U, 8U, 60'000U}) {
      const Cloud plain = sample::room(5, points, values_below);
      const Cloud cloud = sample::with_attachment(plain, 6, 1001);
      const Bytes bytes = canonical_bytes(cloud, 5000).value();
      EXPECT_EQ(bytes.size(), canonical_bytes(plain, 5000)->size() + 1001);
      EXPECT_TRUE(is_cloud(bytes));
      EXPECT_EQ(decode_cloud(bytes)->cloud.attached, cloud.attached);
      EXPECT_EQ(canonical_bytes(decode_cloud(bytes)->cloud, 5000).value(), bytes);
    }
  }
}

TEST(CanonicalCloud, ACloudWithoutPointsIsOne) {
  const Bytes bytes = canonical_bytes({}, kFineQuantum_um).value();
  EXPECT_EQ(bytes.size(), 33U);
  EXPECT_EQ(decode_cloud(bytes)->cloud, Cloud{});
  EXPECT_TRUE(is_cloud(bytes));
  EXPECT_FALSE(is_cloud({}));
}

TEST(Morton, CellsComeBackFromTheirCodes) {
  EXPECT_EQ(code_from_cell({1, 0, 0}), 1U);
  EXPECT_EQ(code_from_cell({0, 1, 0}), 2U);
  EXPECT_EQ(code_from_cell({0, 0, 1}), 4U);
  EXPECT_EQ(code_from_cell({0x1fffff, 0x1fffff, 0x1fffff}), (1ULL << 63U) - 1);
  Random random(2);
  for (int round = 0; round < 1000; ++round) {
    const std::array<std::uint32_t, 3> cell{static_cast<std::uint32_t>(random.below(1U << 21U)),
                                            static_cast<std::uint32_t>(random.below(1U << 21U)),
                                            static_cast<std::uint32_t>(random.below(1U << 21U))};
    ASSERT_EQ(cell_from_code(code_from_cell(cell)), cell);
  }
}

}  // namespace
}  // namespace weft::clouds
