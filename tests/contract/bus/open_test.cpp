#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "idl/bus/addresses.hpp"
#include "idl/bus/bus.hpp"
#include "tests/contract/bus/fleet.hpp"
#include "tests/support/own_domain.hpp"

namespace weft::contract {
namespace {

using bus::BusConfig;
using bus::Vendor;
using testing::HasSubstr;

unsigned own_domain() {
  static const test::OwnDomain domain;
  return domain.number();
}

BusConfig server() {
  BusConfig config;
  config.role = msg::Role::server;
  config.self = kServerId;
  config.domain = own_domain();
  return config;
}

BusConfig agent() {
  BusConfig config = server();
  config.role = msg::Role::agent;
  config.self = peer_id(2);
  config.servers = {"127.0.0.1"};
  return config;
}

struct Opening : testing::TestWithParam<Vendor> {
  std::string refusal(const BusConfig& config, ErrorCode code) {
    const auto opened = bus::open(GetParam(), config);
    if (opened) return "opened";
    EXPECT_EQ(opened.error().code, code);
    return opened.error().message;
  }
};

TEST_P(Opening, AServersPortInUseIsNamed) {
  const auto other = GetParam() == Vendor::fastdds ? Vendor::cyclonedds : Vendor::fastdds;
  const auto first = bus::open(other, server());
  ASSERT_TRUE(first) << first.error().message;
  const std::string port = std::to_string(bus::ports_of(own_domain(), 0).discovery);
  EXPECT_THAT(refusal(server(), ErrorCode::unavailable), HasSubstr("UDP port " + port + " on 127.0.0.1 is in use"));
}

TEST_P(Opening, TwoServersOfOneMachineTakeTwoIndices) {
  const auto other = GetParam() == Vendor::fastdds ? Vendor::cyclonedds : Vendor::fastdds;
  const auto first = bus::open(other, server());
  ASSERT_TRUE(first) << first.error().message;
  BusConfig second = server();
  second.server_index = 1;
  const auto opened = bus::open(GetParam(), second);
  EXPECT_TRUE(opened) << opened.error().message;
}

TEST_P(Opening, PeersDoNotTakeTheServersPort) {
  const auto peer = bus::open(GetParam(), agent());
  ASSERT_TRUE(peer) << peer.error().message;
  const auto other = GetParam() == Vendor::fastdds ? Vendor::cyclonedds : Vendor::fastdds;
  const auto opened = bus::open(other, server());
  EXPECT_TRUE(opened) << opened.error().message;
}

TEST_P(Opening, AddressesThatAreNoneAreNamed) {
  BusConfig config = server();
  config.listen = "203.0.113.7";
  EXPECT_THAT(refusal(config, ErrorCode::unavailable), HasSubstr("cannot listen on 203.0.113.7"));
  config = agent();
  config.servers = {"no-such-host.invalid"};
  EXPECT_THAT(refusal(config, ErrorCode::unavailable), HasSubstr("host 'no-such-host.invalid' has no known IPv4"));
  config.servers = {"127.0.0.1:x"};
  EXPECT_THAT(refusal(config, ErrorCode::invalid), HasSubstr("'127.0.0.1:x' is not HOST or HOST:INDEX"));
  config.servers = {};
  EXPECT_THAT(refusal(config, ErrorCode::invalid), HasSubstr("no server is given"));
  config = server();
  config.domain = 201;
  EXPECT_THAT(refusal(config, ErrorCode::invalid), HasSubstr("domain 201 is above 200"));
}

TEST_P(Opening, WaitEndsWithWakeAndWithTime) {
  const auto opened = bus::open(GetParam(), agent());
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_FALSE((*opened)->wait(std::chrono::milliseconds(1)));
  const std::jthread other([&] { (*opened)->wake(); });
  EXPECT_TRUE((*opened)->wait(std::chrono::minutes(1)));
  EXPECT_FALSE((*opened)->take());
}

TEST(ParseVendor, KnowsTwo) {
  EXPECT_EQ(bus::parse_vendor("fastdds").value(), Vendor::fastdds);
  EXPECT_EQ(bus::parse_vendor("cyclonedds").value(), Vendor::cyclonedds);
  const auto other = bus::parse_vendor("opendds");
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().message, "'opendds' is no DDS vendor: fastdds or cyclonedds");
}

INSTANTIATE_TEST_SUITE_P(Each, Opening, testing::Values(Vendor::fastdds, Vendor::cyclonedds),
                         [](const auto& of) { return of.param == Vendor::fastdds ? "fastdds" : "cyclonedds"; });

}  // namespace
}  // namespace weft::contract
