#include "core/text.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include "core/config/config.hpp"

namespace weft {
namespace {

const std::string kOrderMark = "\xEF\xBB\xBF";

TEST(Text, WritesTimesInUtcWithTheirZone) {
  using namespace std::chrono_literals;
  EXPECT_EQ(iso_time(WallTime{}), "1970-01-01T00:00:00.000Z");
  EXPECT_EQ(iso_time(WallTime{Duration(1'772'357'405s + 250'999us)}), "2026-03-01T09:30:05.250Z");
  EXPECT_EQ(iso_time(WallTime{Duration(-1ms)}), "1969-12-31T23:59:59.999Z");
}

TEST(Text, LosesItsByteOrderMarkOnce) {
  EXPECT_EQ(without_byte_order_mark(kOrderMark + "a"), "a");
  EXPECT_EQ(without_byte_order_mark("a" + kOrderMark), "a" + kOrderMark);
  EXPECT_EQ(without_byte_order_mark(kOrderMark), "");
  EXPECT_EQ(without_byte_order_mark("\xEF\xBB"), "\xEF\xBB");
}

TEST(Text, AConfigurationMayBeginWithAByteOrderMark) {
  const std::string text = kOrderMark + "name = \"r1\"\n";
  const config::Table table = config::parse(text, "a.toml");
  EXPECT_EQ(table.text("name", "", 64), "r1");
  EXPECT_TRUE(table.result());
}

}  // namespace
}  // namespace weft
