#include "tests/simulation/link_keeper.hpp"

#include <gtest/gtest.h>

namespace weft::simulation {
namespace {

using namespace std::chrono_literals;

struct KeptLink : testing::Test {
  /// Looks twice a second, hearing nobody, until the link connects or 20 s are over. Returns how often it was closed.
  int closed_until_connected(const Whereabouts& now_at) {
    int closed = 0;
    for (SteadyTime now = SteadyTime(500ms); now < SteadyTime(20s) && !keeper.connects(now_at); now += 500ms) {
      keeper.look(now_at, now, 0, {});
      closed += bus->is_open() ? 0 : 1;
    }
    return closed;
  }

  bus::InProcessNet net{Random(1)};
  PeerId self{{7}};
  std::unique_ptr<bus::Bus> bus = net.attach(msg::Role::agent, self);
  LinkKeeper keeper{net, self, {"here", "there"}, SteadyTime{}};
};

TEST_F(KeptLink, FindsItsServerWhereThatHasMoved) {
  EXPECT_TRUE(keeper.connects({"here", "there"}));
  EXPECT_FALSE(keeper.connects({"here", "elsewhere"}));
  EXPECT_EQ(closed_until_connected({"here", "elsewhere"}), 1);
  EXPECT_TRUE(keeper.connects({"here", "elsewhere"}));
  EXPECT_TRUE(bus->is_open());
}

TEST_F(KeptLink, IsOpenedAnewAtItsOwnNewAddress) {
  EXPECT_EQ(closed_until_connected({"elsewhere", "there"}), 1);
  EXPECT_TRUE(keeper.connects({"elsewhere", "there"}));
  EXPECT_TRUE(bus->is_open());
}

TEST_F(KeptLink, IsOpenedAnewAfterItsProcessStoodStill) {
  keeper.look({"here", "there"}, SteadyTime(10s), 0, 10s);
  EXPECT_FALSE(bus->is_open());
  keeper.look({"here", "there"}, SteadyTime(10500ms), 0, {});
  EXPECT_TRUE(bus->is_open());
}

}  // namespace
}  // namespace weft::simulation
