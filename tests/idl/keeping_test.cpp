#include "idl/bus/keeping.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace weft::bus {
namespace {
using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::IsEmpty;
using Step = Keeping::Step;

const LocalLink kUp{"wlan0", "10.0.0.17", true};
const LocalLink kNoCarrier{"wlan0", "10.0.0.17", false};
const std::vector<ServerAddress> kServers{{"10.0.0.5", 7410}};

/// Arranges a robot's bus on an interface's name, and the world that it sees.
struct Kept : testing::Test {
  Keeping keeping{"wlan0"};
  Sight sight{.now = SteadyTime{100s}, .received = 0, .link = kUp, .servers = kServers, .unseen = {}};

  Keeping::Decision after(Duration passed) {
    sight.now += passed;
    return keeping.next(sight);
  }
  std::string join() { return keeping.joined(sight.now, {sight.link.ipv4, {}, *sight.servers}); }
  Keeping::Decision hear() {
    ++sight.received;
    return keeping.next(sight);
  }
};

TEST_F(Kept, WaitsForACarrierAndSaysSoOnceAndThenAtIntervals) {
  sight.link = kNoCarrier;
  EXPECT_THAT(after(0s).notice,
              HasSubstr("waits for its link: interface wlan0 (10.0.0.17) is down or has no carrier"));
  EXPECT_THAT(after(1s).notice, IsEmpty());
  EXPECT_THAT(after(30s).notice, HasSubstr("waits for its link"));
  sight.link = kUp;
  EXPECT_EQ(after(1s).step, Step::join);
  EXPECT_EQ(join(), "its link is open on 10.0.0.17");
}

TEST_F(Kept, WaitsForAnAddressAndForTheServersName) {
  sight.link = {"wlan0", "", false};
  sight.servers.reset();
  EXPECT_THAT(after(0s).notice, HasSubstr("interface wlan0 has no IPv4 address"));
  sight.link = kUp;
  const auto asking = after(1s);
  EXPECT_EQ(asking.step, Step::stay);
  EXPECT_TRUE(asking.asks_resolver);
  EXPECT_THAT(asking.notice, IsEmpty()) << "an address needs no resolver, and is known at the next look";
  const auto waiting = after(500ms);
  EXPECT_FALSE(waiting.asks_resolver);
  EXPECT_THAT(waiting.notice, HasSubstr("its name is not known yet"));
  EXPECT_TRUE(after(2s).asks_resolver);
  sight.servers = kServers;
  EXPECT_EQ(after(500ms).step, Step::join);
}

TEST_F(Kept, TriesAgainWhatFailedAndSaysWhy) {
  ASSERT_EQ(after(0s).step, Step::join);
  keeping.failed(sight.now, "UDP port 7410 is in use");
  EXPECT_THAT(after(500ms).notice, HasSubstr("UDP port 7410 is in use"));
  EXPECT_EQ(after(500ms).step, Step::join);
}

TEST_F(Kept, FollowsItsInterfacesAddress) {
  join();
  sight.link.ipv4 = "10.0.0.99";
  EXPECT_EQ(after(500ms).step, Step::stay) << "given back within a second it has not changed";
  const auto moved = after(1s);
  EXPECT_EQ(moved.step, Step::leave);
  EXPECT_THAT(moved.notice, HasSubstr("its address 10.0.0.17 is gone, wlan0 has 10.0.0.99"));
  EXPECT_EQ(after(0s).step, Step::join);
}

TEST_F(Kept, OpensAnewForWhoeverIsNotAnsweredAlthoughItHears) {
  join();
  after(2s);
  hear();
  sight.is_unanswered = true;
  const auto asked = after(500ms);
  EXPECT_EQ(asked.step, Step::leave);
  EXPECT_THAT(asked.notice, HasSubstr("is not answered: opens its link anew"));
  sight.is_unanswered = false;
  EXPECT_EQ(after(0s).step, Step::join);
  join();
  EXPECT_EQ(after(500ms).step, Step::stay) << "once for each time that it is asked";
}

TEST_F(Kept, OpensNothingAnewForWhoeverIsNotAnsweredWithoutACarrier) {
  join();
  sight.link = kNoCarrier;
  sight.is_unanswered = true;
  EXPECT_EQ(after(500ms).step, Step::stay) << "it comes back by itself";
}

TEST_F(Kept, AnAddressGivenBackAtOnceIsTheSame) {
  join();
  sight.link = {"wlan0", "", false};
  EXPECT_EQ(after(500ms).step, Step::stay);
  sight.link = kUp;
  EXPECT_EQ(after(500ms).step, Step::stay);
  sight.link = {"wlan0", "", false};
  EXPECT_EQ(after(500ms).step, Step::stay);
}

TEST_F(Kept, ALostCarrierComesBackByItself) {
  join();
  sight.link = kNoCarrier;
  for (int i = 0; i < 100; ++i) EXPECT_EQ(after(1s).step, Step::stay);
}

TEST_F(Kept, SilenceAsksWhetherTheServerHasMoved) {
  join();
  EXPECT_FALSE(after(2s).asks_resolver);
  EXPECT_TRUE(after(1s).asks_resolver);
  EXPECT_FALSE(after(1s).asks_resolver);
  sight.servers = {{"10.0.0.6", 7410}};
  const auto moved = after(500ms);
  EXPECT_EQ(moved.step, Step::leave);
  EXPECT_THAT(moved.notice, HasSubstr("its server is at 10.0.0.6 now, no longer at 10.0.0.5"));
}

TEST_F(Kept, WhoIsHeardHasNotMoved) {
  join();
  sight.servers = {{"10.0.0.6", 7410}};
  for (int i = 0; i < 20; ++i) {
    sight.now += 1s;
    EXPECT_EQ(hear().step, Step::stay);
  }
}

TEST_F(Kept, LongSilenceJoinsAnewMoreAndMoreSeldom) {
  join();
  std::vector<int> left_at;
  for (int second = 1; second <= 200; ++second) {
    if (after(1s).step != Step::leave) continue;
    left_at.push_back(second);
    ASSERT_EQ(after(0s).step, Step::join);
    EXPECT_THAT(join(), IsEmpty()) << "that nobody is there is said by who misses them";
  }
  EXPECT_THAT(left_at, testing::ElementsAre(8, 24, 56, 116, 176));
  hear();
  EXPECT_EQ(after(7s).step, Step::stay);
  EXPECT_EQ(after(1s).step, Step::leave) << "what was heard makes it as watchful as before";
}

TEST_F(Kept, AServerMayHearNothing) {
  sight.servers = std::vector<ServerAddress>{};
  join();
  for (int i = 0; i < 100; ++i) {
    const auto decision = after(1s);
    EXPECT_EQ(decision.step, Step::stay);
    EXPECT_FALSE(decision.asks_resolver);
  }
}

TEST_F(Kept, JoinsAnewAfterItStoodStillSinceOthersHaveForgottenIt) {
  join();
  sight.unseen = 2s;
  EXPECT_EQ(after(2s).step, Step::stay);
  sight.unseen = 9s;
  const auto woken = after(9s);
  EXPECT_EQ(woken.step, Step::leave);
  EXPECT_THAT(woken.notice, HasSubstr("stood still for 9 s"));
  sight.unseen = {};
  EXPECT_EQ(after(0s).step, Step::join);
}

TEST_F(Kept, AServerThatStoodStillJoinsAnewToo) {
  sight.servers.emplace();
  join();
  sight.unseen = 9s;
  EXPECT_EQ(after(9s).step, Step::leave);
}

}  // namespace
}  // namespace weft::bus
