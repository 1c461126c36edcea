#include "storage/formats/lines.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "storage/formats/not_understood.hpp"

namespace weft::formats {
namespace {

TEST(Lines, BothEndingsAndALastLineWithoutOne) {
  Lines lines("a\r\n\nb");
  EXPECT_EQ(lines.next(), "a");
  EXPECT_EQ(lines.next(), "");
  EXPECT_EQ(lines.next(), "b");
  EXPECT_EQ(lines.number(), 3U);
  EXPECT_FALSE(lines.next().has_value());
  EXPECT_EQ(lines.number(), 3U);
}

TEST(Lines, WordsAndCells) {
  EXPECT_EQ(words_of("  a\t bc "), (std::vector<std::string_view>{"a", "bc"}));
  EXPECT_TRUE(words_of(" \t").empty());
  EXPECT_EQ(cells_of("1, 2 ,,3", ','), (std::vector<std::string_view>{"1", "2", "", "3"}));
}

TEST(Lines, NumbersAreTakenWholeOrNotAtAll) {
  EXPECT_EQ(parse_double("-1.5e3"), -1500.0);
  EXPECT_EQ(parse_double("+2"), 2.0);
  EXPECT_TRUE(std::isnan(*parse_double("nan")));
  for (const char* const word : {"", "1.0x", "1,5", "0x10", "1e999", "- 1"}) {
    EXPECT_FALSE(parse_double(word).has_value()) << word;
  }
  EXPECT_FALSE(parse_finite("nan").has_value());
  EXPECT_FALSE(parse_finite("-inf").has_value());
  EXPECT_EQ(parse_unsigned("18446744073709551615"), std::numeric_limits<std::uint64_t>::max());
  for (const char* const word : {"-1", "18446744073709551616", "1.0", ""}) {
    EXPECT_FALSE(parse_unsigned(word).has_value()) << word;
  }
}

TEST(Lines, WrittenNumbersReadBackAsTheSameBits) {
  for (const double value : {0.1, -0.0, 1.0 / 3.0, 5e-324, 1.7976931348623157e308, 1403636584.66356}) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(*parse_double(text_of(value))), std::bit_cast<std::uint64_t>(value));
  }
}

TEST(Leftovers, AreNamedOnceWithTheirFirstLine) {
  Leftovers leftovers;
  leftovers.note("VERTEX_XY", 4);
  leftovers.note("EDGE_SE2_XY", 9);
  leftovers.note("VERTEX_XY", 12);
  const std::vector<NotUnderstood> parts = leftovers.take();
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(to_string(parts[0], "a.g2o"), "a.g2o:4: VERTEX_XY, 2 times");
  EXPECT_EQ(to_string(parts[1], "a.g2o"), "a.g2o:9: EDGE_SE2_XY, once");
}

}  // namespace
}  // namespace weft::formats
