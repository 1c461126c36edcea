#include "agents/perception/sign.hpp"

#include <gtest/gtest.h>

#include "tests/agents/methods/topometric/sim_drive.hpp"

namespace weft::agents {
namespace {

TEST(TopometricSign, PlacesNearEachOtherHaveNearerSignatures) {
  test::SimDrive drive(test::topometric_site("hall"), {3.0, 1.8, 0.0});
  drive.drive(0.8);
  const TopometricContent here = drive.place();
  drive.drive(0.3);
  const TopometricContent near = drive.place();
  test::SimDrive other(test::topometric_site("level11"), {6.0, 0.9, 0.0});
  other.drive(0.8);
  const auto sign = [&](const TopometricContent& content) {
    return drive.method().sign(content).value_or(Signature{});
  };
  const Signature of_here = sign(here);
  EXPECT_FALSE(of_here.empty());
  EXPECT_LT(distance2(of_here, sign(near)), distance2(of_here, sign(other.place())));
}

TEST(TopometricSign, TheServerSignsBytesAlike) {
  test::SimDrive drive(test::topometric_site("hall"), {3.0, 1.8, 0.0});
  drive.drive(0.8);
  const TopometricContent content = drive.place();
  EXPECT_EQ(Topometric::sign_bytes(drive.method().encode(content)), drive.method().sign(content));
  EXPECT_FALSE(Topometric::sign_bytes({}));
  TopometricContent blank = content;
  blank.features.clear();
  EXPECT_FALSE(drive.method().sign(blank));
}

TEST(Sign, CountsWordsWhateverTheOrder) {
  const std::vector<Descriptor> one = {{1, 2, 3, 4}, {5, 6, 7, 8}};
  const std::vector<Descriptor> other = {{5, 6, 7, 8}, {1, 2, 3, 4}};
  EXPECT_EQ(sign_descriptors(one), sign_descriptors(other));
  EXPECT_FALSE(sign_descriptors({}));
}

}  // namespace
}  // namespace weft::agents
