#include "agents/perception/lamps.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace weft::agents {
namespace {

TEST(LampsInAView, CountOnTheirRimOnly) {
  auto pixels = std::make_shared<Bytes>(200 * 150, 80);
  for (std::size_t row = 50; row < 100; ++row)
    for (std::size_t column = 60; column < 140; ++column) (*pixels)[row * 200 + column] = 255;
  const Lamps lamps({200, 150, pixels}, {});
  EXPECT_TRUE(lamps.counts({60.0, 50.0})) << "a corner of the rim";
  EXPECT_FALSE(lamps.counts({100.0, 75.0})) << "within";
  EXPECT_FALSE(lamps.counts({54.0, 75.0})) << "bloom";
  EXPECT_TRUE(lamps.counts({30.0, 20.0})) << "beside";
  EXPECT_FALSE(lamps.counts({-3.0, 20.0})) << "outside";
}

TEST(LampsInAView, TheirBloomIsNoGreyOfTheCeiling) {
  auto pixels = std::make_shared<Bytes>(200 * 150, 80);
  for (std::size_t row = 45; row < 105; ++row)
    for (std::size_t column = 55; column < 145; ++column) (*pixels)[row * 200 + column] = 200;
  for (std::size_t row = 50; row < 100; ++row)
    for (std::size_t column = 60; column < 140; ++column) (*pixels)[row * 200 + column] = 255;
  EXPECT_NEAR(grey_beside_lamps({200, 150, pixels}, {}), 80.0, 1e-9);
  const auto white = std::make_shared<Bytes>(200 * 150, 255);
  EXPECT_EQ(grey_beside_lamps({200, 150, white}, {}), 255.0);
}

}  // namespace
}  // namespace weft::agents
