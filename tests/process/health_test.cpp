#include "process/health.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/utf8.hpp"

namespace weft::process::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::Not;

constexpr SteadyTime kBeat{Duration(1000s)};

Health works() {
  return {.program = "weft-server", .process = 12, .beat = kBeat, .is_starting = false, .trouble = {}};
}

TEST(Health, IsReadAsItWasWritten) {
  for (const bool is_starting : {false, true}) {
    for (const char* const trouble : {"", "deaf: its link is not open", "für  zwei"}) {
      Health health = works();
      health.is_starting = is_starting;
      health.trouble = trouble;
      const Result<Health> read = parse_health(health_text(health));
      ASSERT_TRUE(read) << read.error().message;
      EXPECT_EQ(read->program, "weft-server");
      EXPECT_EQ(read->process, 12);
      EXPECT_EQ(read->beat, kBeat);
      EXPECT_EQ(read->is_starting, is_starting);
      EXPECT_EQ(read->trouble, trouble);
    }
  }
}

TEST(Health, RecordsAreOfOneSizeAndOnOneLine) {
  Health health = works();
  health.trouble = "disk full\nä";
  for (int i = 0; i < 9; ++i) health.trouble += health.trouble;
  const std::string text = health_text(health);
  EXPECT_EQ(text.size(), kHealthBytes);
  EXPECT_EQ(text.find('\n'), kHealthBytes - 1);
  const Result<Health> read = parse_health(text);
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->trouble.starts_with("disk full; ä"));
  EXPECT_TRUE(is_utf8(read->trouble));
  EXPECT_EQ(health_text(works()).size(), kHealthBytes);
}

TEST(Health, WhatIsNoRecordIsRefusedAndShown) {
  const std::string good = health_text(works());
  std::string other = good;
  other.replace(good.find("running"), 7, "dancing");
  std::string cut = good;
  cut.pop_back();
  std::string numberless = good;
  numberless.replace(good.find(" 12 "), 4, " xy ");
  for (const std::string& text : {std::string(), std::string("garbage"), cut, other, numberless,
                                  std::string(kHealthBytes, '\0'), std::string(kHealthBytes, '\xFF')}) {
    const Result<Health> read = parse_health(text);
    ASSERT_FALSE(read) << text;
    EXPECT_EQ(read.error().code, ErrorCode::corrupt);
    EXPECT_TRUE(is_utf8(read.error().message));
  }
  EXPECT_THAT(parse_health("garbage").error().message, HasSubstr("\"garbage\""));
}

TEST(Health, ALaterVersionIsNamed) {
  std::string text = health_text(works());
  text.replace(text.find(" 1 "), 3, " 2 ");
  const Result<Health> read = parse_health(text);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::newer);
  EXPECT_THAT(read.error().message, HasSubstr("version 2"));
}

TEST(Health, AMainLoopThatTurnsIsHealthyUntilTheBound) {
  EXPECT_TRUE(judge(works(), kBeat).healthy);
  EXPECT_TRUE(judge(works(), kBeat + kHungAfter - 1ms).healthy);
  const Verdict hung = judge(works(), kBeat + kHungAfter);
  EXPECT_FALSE(hung.healthy);
  EXPECT_THAT(hung.why, HasSubstr("hung for 10.0 s"));
  EXPECT_THAT(hung.why, HasSubstr("weft-server, process 12"));
}

TEST(Health, TroubleIsSaidAndAHungLoopFirst) {
  Health health = works();
  health.trouble = "deaf: its link is not open";
  EXPECT_FALSE(judge(health, kBeat).healthy);
  EXPECT_THAT(judge(health, kBeat).why, HasSubstr("deaf"));
  const Verdict hung = judge(health, kBeat + 25s);
  EXPECT_THAT(hung.why, HasSubstr("hung for 25.0 s"));
  EXPECT_THAT(hung.why, HasSubstr("before that: deaf"));
}

TEST(Health, WhatStartsIsNotHealthyYetAndNotHung) {
  Health health = works();
  health.is_starting = true;
  health.trouble = "it opens its store";
  const Verdict verdict = judge(health, kBeat + 60s);
  EXPECT_FALSE(verdict.healthy);
  EXPECT_THAT(verdict.why, HasSubstr("starting for 60.0 s: it opens its store"));
  EXPECT_THAT(verdict.why, Not(HasSubstr("hung")));
}

TEST(Health, ABeatOfAnotherMachinesClockIsNamed) {
  EXPECT_TRUE(judge(works(), kBeat - 500ms).healthy) << "written while the probe looked";
  const Verdict verdict = judge(works(), kBeat - 100s);
  EXPECT_FALSE(verdict.healthy);
  EXPECT_THAT(verdict.why, HasSubstr("100.0 s ahead"));
}

}  // namespace
}  // namespace weft::process::test
