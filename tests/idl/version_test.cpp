#include "core/protocol/version.hpp"

#include <gtest/gtest.h>

namespace weft::msg {
namespace {

Hello speaking(std::uint16_t min, std::uint16_t max) {
  Hello hello;
  hello.name = "r1";
  hello.software = "weft 0.1.0";
  hello.protocol_min = min;
  hello.protocol_max = max;
  return hello;
}

TEST(Negotiate, TakesTheHighestThatBothSpeak) {
  EXPECT_EQ(negotiate({1, 1}, speaking(1, 1)).value(), 1);
  EXPECT_EQ(negotiate({1, 2}, speaking(0, 1)).value(), 1);
  EXPECT_EQ(negotiate({1, 2}, speaking(2, 5)).value(), 2);
  EXPECT_EQ(negotiate({0, 1}, speaking(0, 0)).value(), 0);
}

TEST(Negotiate, RefusesOlderAndNewerAndSaysWhatToUpdate) {
  const Result<std::uint16_t> older = negotiate({1, 1}, speaking(0, 0));
  ASSERT_FALSE(older);
  EXPECT_EQ(older.error().code, ErrorCode::stale);
  EXPECT_EQ(older.error().message, "'r1' (weft 0.1.0) speaks protocol 0, this side 1: update 'r1'");
  const Result<std::uint16_t> newer = negotiate({1, 2}, speaking(3, 4));
  ASSERT_FALSE(newer);
  EXPECT_EQ(newer.error().code, ErrorCode::newer);
  EXPECT_EQ(newer.error().message, "'r1' (weft 0.1.0) speaks protocol 3 to 4, this side 1 to 2: update this side");
}

}  // namespace
}  // namespace weft::msg
