#include "clients/cli/run_colour.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "clients/cli/picture.hpp"

namespace weft::cli::test {
namespace {

struct OkLab {
  double l, a, b;
};

/// Converts a colour to OKLab: Björn Ottosson, "A perceptual color space for image processing", 2020.
OkLab ok_lab(const Colour& colour) {
  const auto linear = [](double share) {
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  };
  const double r = linear(colour.r);
  const double g = linear(colour.g);
  const double b = linear(colour.b);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

double apart(const Colour& one, const Colour& other) {
  const OkLab p = ok_lab(one);
  const OkLab q = ok_lab(other);
  return std::hypot(p.l - q.l, p.a - q.a, p.b - q.b);
}

TEST(RunColour, AnyTwoCanBeToldApart) {
  for (std::size_t i = 0; i < kRunColours.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_GT(apart(kRunColours[i], kRunColours[j]), 0.115) << i << " and " << j;
    for (const Colour& other : {kWhite, kInk, kStitch, kHeld}) EXPECT_GT(apart(kRunColours[i], other), 0.1) << i;
  }
}

TEST(RunColour, IsFixedForEver) {
  EXPECT_EQ(run_colour({0xA1}), run_colour({0xA1}));
  EXPECT_EQ(run_colour({0}), kRunColours[0]);
  EXPECT_EQ(run_colour({0xA1}), kRunColours[1]);
  EXPECT_EQ(run_colour({0xB2}), kRunColours[2]);
}

TEST(RunColour, AllAreUsedAboutAsOften) {
  std::map<const Colour*, int> times;
  for (std::uint64_t id = 1; id <= 2000; ++id) ++times[&run_colour({id})];
  EXPECT_EQ(times.size(), kRunColours.size());
  for (const auto& [colour, count] : times) EXPECT_NEAR(count, 100, 40);
}

}  // namespace
}  // namespace weft::cli::test
