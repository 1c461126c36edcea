#include "agents/agent/server_silence.hpp"

#include <gtest/gtest.h>

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

constexpr SteadyTime kBegun{100s};

TEST(ServerSilence, LastsFromTheStartUntilSomethingComes) {
  ServerSilence silence(kBegun);
  EXPECT_EQ(silence.unheard(kBegun + 7s), 7s);
  EXPECT_EQ(silence.longest(kBegun + 7s), 7s);
  silence.hear(kBegun + 8s);
  EXPECT_EQ(silence.unheard(kBegun + 9s), 1s);
}

TEST(ServerSilence, RemembersTheLongestGapForAMinute) {
  ServerSilence silence(kBegun);
  silence.hear(kBegun + 1s);
  silence.hear(kBegun + 16s);
  silence.hear(kBegun + 20s);
  EXPECT_EQ(silence.longest(kBegun + 21s), 15s);
  silence.hear(kBegun + 40s);
  EXPECT_EQ(silence.longest(kBegun + 41s), 20s) << "a longer one takes its place";
  for (Duration at = 41s; at < 110s; at += 1s) silence.hear(kBegun + at);
  EXPECT_LE(silence.longest(kBegun + 110s), 2s);
}

TEST(ServerSilence, CountsWhatLastsNow) {
  ServerSilence silence(kBegun);
  silence.hear(kBegun + 10s);
  silence.hear(kBegun + 11s);
  EXPECT_EQ(silence.longest(kBegun + 31s), 20s);
}

TEST(ServerSilence, LeavesOutWhatThisProcessWasAway) {
  ServerSilence silence(kBegun);
  silence.hear(kBegun + 1s);
  silence.was_away(30s, kBegun + 32s);
  EXPECT_EQ(silence.unheard(kBegun + 32s), 1s);
  silence.was_away(30s, kBegun + 33s);
  EXPECT_EQ(silence.unheard(kBegun + 33s), 0s) << "never heard in the future";
}

}  // namespace
}  // namespace weft::agents::test
