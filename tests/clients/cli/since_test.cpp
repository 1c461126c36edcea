#include "clients/cli/since.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace weft::cli::test {
namespace {
using namespace std::chrono_literals;

constexpr WallTime kToday{1'772'357'405s};  // 2026-03-01T09:30:05Z

TEST(Since, IsSoLongAgoOrATime) {
  const auto when = [](const char* text) {
    const auto since = parse_since(text);
    EXPECT_TRUE(since) << text << ": " << since.error().message;
    return since ? since->when(kToday) : WallTime{};
  };
  EXPECT_EQ(when("90s"), kToday - 90s);
  EXPECT_EQ(when("10min"), kToday - 10min);
  EXPECT_EQ(when("2h"), kToday - 2h);
  EXPECT_EQ(when("36500d"), kToday - 24h * 36'500);
  EXPECT_EQ(when("2026-03-01T09:30:05Z"), kToday);
  EXPECT_EQ(when("2026-03-01T09:30:05.250Z"), kToday + 250ms);
}

TEST(Since, RefusesWhatIsNone) {
  for (const char* const text :
       {"", "10", "min", "-5s", "1.5h", "10 min", "36501d", "99999999999999999999s", "2026-03-01",
        "2026-02-30T09:30:05Z", "2026-03-01T25:00:00Z", "2026-03-01T09:30:05", "2026-03-01T09:30:05.Z",
        "2026-03-01T09:30:05+01:00", "2026-03-01T09:30:05.0000000001Z"}) {
    const auto since = parse_since(text);
    ASSERT_FALSE(since) << text;
    EXPECT_NE(since.error().message.find("2h"), std::string::npos) << "says what is one";
  }
}

}  // namespace
}  // namespace weft::cli::test
