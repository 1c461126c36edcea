#include "core/names.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace weft {
namespace {

using testing::HasSubstr;

TEST(Name, HasLettersAndDigitsOfAnyScript) {
  for (const char* const name :
       {"a", "Dock-3", "x_y.z", "Halle-3", "süd", "12-dock", "7", "Бокс-2", "出荷口", "مخزن", "ångström"})
    EXPECT_TRUE(check_name("label", name)) << name;
  EXPECT_TRUE(check_name("label", "su\xCC\x88s")) << "as some keyboards write it: u and two dots";
}

TEST(Name, HasNothingElse) {
  for (const char* const name :
       {"-a", ".", "_x", "a b", "a\n", "a/b", "a\xC2\xA0z", "a\xE2\x80\xAEz", "dock!", "a\x7F", "\xF0\x9F\x9A\x9A"})
    EXPECT_FALSE(check_name("label", name)) << name;
  EXPECT_THAT(check_name("label", "a/b").error().message, HasSubstr(R"(label "a/b" has the character '/')"));
  EXPECT_THAT(check_name("robot", "a\xC2\xA0z").error().message, HasSubstr("U+00A0"));
  EXPECT_THAT(check_name("robot", "-a").error().message, HasSubstr("begins with '-'"));
}

TEST(Name, HasNoMoreBytesThanTravel) {
  EXPECT_TRUE(check_name("label", std::string(64, 'a')));
  const Result<void> longer = check_name("label", std::string(65, 'a'));
  ASSERT_FALSE(longer);
  EXPECT_THAT(longer.error().message, HasSubstr("has 65 bytes"));
  EXPECT_THAT(longer.error().message, HasSubstr("1 to 64 bytes"));
  EXPECT_THAT(check_name("label", "").error().message, HasSubstr("has 0 bytes"));
}

TEST(Name, IsUtf8) {
  const Result<void> latin = check_name("robot", "J\xFCrgen");
  ASSERT_FALSE(latin);
  EXPECT_THAT(latin.error().message, HasSubstr("is not UTF-8"));
  EXPECT_THAT(latin.error().message, HasSubstr("J\xEF\xBF\xBDrgen"));
}

}  // namespace
}  // namespace weft
