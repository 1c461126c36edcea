#include <gtest/gtest.h>

#include "tests/clients/evaluate/parsed.hpp"

namespace weft::evaluate {
namespace {

TEST(CeilingInvocation, FlagsAndDefaults) {
  const auto plain = std::get<CeilingOptions>(parsed({"ceiling"}));
  EXPECT_EQ(plain.seeds.last, 5U);
  EXPECT_EQ(plain.extent.metres, 20.0);
  EXPECT_EQ(plain.extent.put_downs, 200U);
  EXPECT_FALSE(plain.extent.is_quick);
  EXPECT_EQ(plain.scenes, "deploy/sites/ceiling");
  EXPECT_EQ(plain.out, "out/ceiling");
  const auto given = std::get<CeilingOptions>(
      parsed({"ceiling", "--seeds", "2..3", "--put-downs", "7", "--metres", "10", "--recording", "r", "--out", "o"}));
  EXPECT_EQ(given.seeds.first, 2U);
  EXPECT_EQ(given.extent.put_downs, 7U);
  EXPECT_EQ(given.extent.metres, 10.0);
  EXPECT_EQ(given.recording, "r");
  EXPECT_EQ(given.out, "o");
}

TEST(CeilingInvocation, OneTrialAlone) {
  EXPECT_EQ(std::get<CeilingOptions>(parsed({"ceiling"})).trial, "");
  EXPECT_EQ(std::get<CeilingOptions>(parsed({"ceiling", "--trial", "other"})).trial, "other");
  EXPECT_EQ(std::get<NotRun>(parsed({"ceiling", "--trial", "others"})).exit_code, 2);
  EXPECT_EQ(std::get<NotRun>(parsed({"ceiling", "--trial", "other", "--quick"})).exit_code, 2);
}

TEST(CeilingInvocation, OneSeedAndLittleIfQuick) {
  const auto quick = std::get<CeilingOptions>(parsed({"ceiling", "--quick"}));
  EXPECT_EQ(quick.seeds.last, 1U);
  EXPECT_EQ(quick.extent.metres, 8.0);
  EXPECT_EQ(quick.extent.put_downs, 40U);
  EXPECT_TRUE(quick.extent.is_quick);
}

TEST(CeilingInvocation, ARecordingIsAskedFor) {
  const auto frames = std::get<CeilingFramesOptions>(parsed({"ceiling-frames", "dir", "--json"}));
  EXPECT_EQ(frames.folder, "dir");
  EXPECT_TRUE(frames.json);
  EXPECT_EQ(std::get<NotRun>(parsed({"ceiling-frames"})).exit_code, 2);
  EXPECT_EQ(std::get<NotRun>(parsed({"ceiling", "--put-downs", "0"})).exit_code, 2);
}

}  // namespace
}  // namespace weft::evaluate
