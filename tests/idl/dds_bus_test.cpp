#include "idl/bus/dds_bus.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace weft::bus {
namespace {
using namespace std::chrono_literals;

/// Stands in for a vendor's participant, which can be reached or not.
class StandIn final : public Participant {
 public:
  explicit StandIn(bool is_bound) : is_bound_(is_bound) {}
  Result<void> write(const Topic&, const PeerId&, ByteView) override { return {}; }
  void forget(const PeerId&) override {}
  void forget_readerless(SteadyTime) override {}
  bool is_bound() const override { return is_bound_; }
  std::size_t peers() const override { return 0; }

 private:
  bool is_bound_;
};

BusConfig robot_on_loopback() {
  BusConfig config;
  config.role = msg::Role::agent;
  config.listen = "127.0.0.1";
  config.servers = {"127.0.0.1"};
  return config;
}

TEST(DdsBus, OpensAnewWhenItsInterfaceFailedWhileItOpened) {
  std::atomic<int> joined = 0;
  DdsBus bus(robot_on_loopback(), topics(), "stand-in",
             [&](const Addresses&, Inbox&) -> Result<std::unique_ptr<Participant>> {
               return std::make_unique<StandIn>(joined++ > 0);
             });
  ASSERT_TRUE(bus.start());
  EXPECT_FALSE(bus.is_open()) << "nobody can reach it";
  const auto limit = std::chrono::steady_clock::now() + 60s;
  while (!bus.is_open() && std::chrono::steady_clock::now() < limit) std::this_thread::sleep_for(5ms);
  EXPECT_TRUE(bus.is_open());
  EXPECT_EQ(joined, 2);
  EXPECT_THAT(bus.drain_notices(), testing::Contains(testing::HasSubstr("lost its carrier")));
}

TEST(DdsBus, OpensAnewWhenItIsAskedTo) {
  std::atomic<int> joined = 0;
  DdsBus bus(robot_on_loopback(), topics(), "stand-in",
             [&](const Addresses&, Inbox&) -> Result<std::unique_ptr<Participant>> {
               ++joined;
               return std::make_unique<StandIn>(true);
             });
  ASSERT_TRUE(bus.start());
  EXPECT_EQ(joined, 1);
  bus.open_anew();
  const auto limit = std::chrono::steady_clock::now() + 60s;
  while (!(joined == 2 && bus.is_open()) && std::chrono::steady_clock::now() < limit)
    std::this_thread::sleep_for(5ms);
  EXPECT_EQ(joined, 2);
  EXPECT_TRUE(bus.is_open());
  EXPECT_THAT(bus.drain_notices(), testing::Contains(testing::HasSubstr("is not answered: opens its link anew")));
}

}  // namespace
}  // namespace weft::bus
