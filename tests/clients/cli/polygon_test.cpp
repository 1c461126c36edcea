#include "clients/cli/polygon.hpp"

#include <gtest/gtest.h>

namespace weft::cli::test {
namespace {

std::string polygon_refusal(const std::string& text) {
  const Result<Polygon> read = parse_polygon(text);
  return read ? "" : read.error().message;
}

bool names_as_wrong(const std::string& text, const std::string& what) {
  return text.find(what) != std::string::npos;
}

TEST(Polygon, IsReadFromItsCorners) {
  const Result<Polygon> read = parse_polygon("0,0;4,0;4,3");
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->size(), 3U);
  EXPECT_EQ((*read)[2], Eigen::Vector2d(4.0, 3.0));
}

TEST(Polygon, ThatIsNoneIsRefused) {
  EXPECT_TRUE(names_as_wrong(polygon_refusal("0,0;4,0"), "has 2 corners"));
  EXPECT_TRUE(names_as_wrong(polygon_refusal("0,0;4;4,3"), "has the corner '4', which is no X,Y"));
  EXPECT_TRUE(names_as_wrong(polygon_refusal("0,0;nan,0;4,3"), "has the corner 'nan,0'"));
  EXPECT_TRUE(names_as_wrong(polygon_refusal("0,0;1,1;2,2"), "encloses nothing"));
  EXPECT_TRUE(names_as_wrong(polygon_refusal(""), "is no X,Y"));
}

TEST(Polygon, ContainsWhatLiesWithinItAlsoWhereItIsHollow) {
  const Polygon hook = *parse_polygon("0,0;6,0;6,6;4,6;4,2;0,2");
  EXPECT_TRUE(contains(hook, {1.0, 1.0}));
  EXPECT_TRUE(contains(hook, {5.0, 5.0}));
  EXPECT_FALSE(contains(hook, {2.0, 4.0}));
  EXPECT_FALSE(contains(hook, {-1.0, 1.0}));
}

TEST(Polygon, GivesStretchesOfRuns) {
  Layout layout;
  for (std::uint32_t i = 0; i < 20; ++i) {
    layout.drawing_from_place[{{1}, i}] = {0.5 * i, 0.0, 0.0};
    layout.drawing_from_place[{{2}, i}] = {0.5 * i, 5.0, 0.0};
  }
  const Polygon two = *parse_polygon("0.9,-1;3.1,-1;3.1,1;0.9,1");
  EXPECT_EQ(spans_within(layout, two).value(), (std::vector<Span>{{{{1}, 2}, {{1}, 6}}}));
  layout.drawing_from_place.erase({{1}, 4});
  EXPECT_EQ(spans_within(layout, two).value(), (std::vector<Span>{{{{1}, 2}, {{1}, 6}}})) << "one is gone";
  const Result<std::vector<Span>> none = spans_within(layout, *parse_polygon("50,50;51,50;51,51"));
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::not_found);
}

TEST(Polygon, NarrowerThanPlacesLieApartTakesThePlacesOnEitherSide) {
  Layout layout;
  for (std::uint32_t i = 0; i < 20; ++i) {
    layout.drawing_from_place[{{1}, i}] = {0.5 * i, 0.0, 0.0};
    layout.drawing_from_place[{{2}, i}] = {0.5 * i + 0.25, 1.0, 0.0};
  }
  const Polygon strip = *parse_polygon("1.65,-1;1.85,-1;1.85,2;1.65,2");
  EXPECT_EQ(spans_within(layout, strip).value(), (std::vector<Span>{{{{1}, 3}, {{1}, 4}}, {{{2}, 3}, {{2}, 3}}}));
  const Polygon beside = *parse_polygon("1.65,0.1;1.85,0.1;1.85,2;1.65,2");
  EXPECT_EQ(spans_within(layout, beside).value(), (std::vector<Span>{{{{2}, 3}, {{2}, 3}}}));
  layout.drawing_from_place.erase({{1}, 4});
  EXPECT_EQ(spans_within(layout, strip).value(), (std::vector<Span>{{{{2}, 3}, {{2}, 3}}}))
      << "no edge leads over what has left the map";
}

}  // namespace
}  // namespace weft::cli::test
