#include "core/text.hpp"

#include <gtest/gtest.h>

#include "core/config/config.hpp"

namespace weft {
namespace {

const std::string kOrderMark = "\xEF\xBB\xBF";

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
