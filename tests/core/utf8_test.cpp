#include "core/utf8.hpp"

#include <gtest/gtest.h>

namespace weft {
namespace {

TEST(Utf8, EveryLengthIsReadToItsLastCharacter) {
  std::string_view text = "a\xC3\xBC\xE5\x87\xBA\xF0\x9F\x9A\x9A";
  EXPECT_EQ(take_code_point(text), U'a');
  EXPECT_EQ(take_code_point(text), U'\u00FC');
  EXPECT_EQ(take_code_point(text), U'\u51FA');
  EXPECT_EQ(take_code_point(text), U'\U0001F69A');
  EXPECT_EQ(take_code_point(text), std::nullopt);
}

TEST(Utf8, WhatStandsForNothingIsRefused) {
  for (const std::string_view text : {"\xFC", "\x80", "\xC0\x80", "\xC3", "\xE0\x80\x80", "\xED\xA0\x80",
                                      "\xF4\x90\x80\x80", "\xF5", "\xE5\x87x"}) {
    EXPECT_FALSE(is_utf8(text)) << text;
    std::string_view rest = text;
    EXPECT_EQ(take_code_point(rest), std::nullopt);
    EXPECT_EQ(rest, text);
  }
  EXPECT_TRUE(is_utf8(""));
  EXPECT_TRUE(is_utf8("\xEF\xBF\xBD"));
}

TEST(Utf8, EachStrayByteIsReplaced) {
  EXPECT_EQ(as_utf8("J\xFCrgen"), "J\xEF\xBF\xBDrgen");
  EXPECT_EQ(as_utf8("\xE5\x87"), "\xEF\xBF\xBD\xEF\xBF\xBD");
  EXPECT_EQ(as_utf8("s\xC3\xBCs"), "s\xC3\xBCs");
}

TEST(Utf8, NoCharacterIsCutInTwo) {
  EXPECT_EQ(as_utf8("aaa\xC3\xBC", 4), "aaa");
  EXPECT_EQ(as_utf8("aaa\xC3\xBC", 5), "aaa\xC3\xBC");
  EXPECT_EQ(as_utf8("aa\xFC", 4), "aa");
}

}  // namespace
}  // namespace weft
