#include "core/polyline.hpp"

#include <gmock/gmock.h>

namespace weft {
namespace {

using testing::HasSubstr;

TEST(PolylinePoints, StandInLinesWithBlanksOrCommas) {
  const auto points = parse_polyline_points("# a line\r\n1 2\r\n\n3.5,-4  # corner\n", "f");
  ASSERT_TRUE(points) << points.error().message;
  ASSERT_EQ(points->size(), 2U);
  EXPECT_EQ((*points)[0].y, 2.0);
  EXPECT_EQ((*points)[1].x, 3.5);
  EXPECT_EQ((*points)[1].y, -4.0);
}

TEST(PolylinePoints, MayFollowAByteOrderMark) {
  const auto points = parse_polyline_points(
      "\xEF\xBB\xBF"
      "0 0\n1 0\n",
      "f");
  ASSERT_TRUE(points) << points.error().message;
  EXPECT_EQ(points->size(), 2U);
}

TEST(PolylinePoints, MistakesAreNamedByLine) {
  const auto refused = [](const std::string& text) {
    const auto points = parse_polyline_points(text, "f");
    return points ? std::string() : points.error().message;
  };
  for (const char* const row : {"1", "1 x", "1 2 3", "nan 1", "1 inf"}) {
    EXPECT_THAT(refused("0 0\n" + std::string(row) + "\n"), HasSubstr("f:2: '" + std::string(row) + "' is no point"));
  }
  EXPECT_THAT(refused("1403636579763555584 0\n"), HasSubstr("f:1: '1403636579763555584 0' lies beyond +-100000 m"));
}

}  // namespace
}  // namespace weft
