#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fastdds/dds/log/Log.hpp>

#include "idl/bus/bus.hpp"
#include "tests/contract/bus/contract.hpp"
#include "tests/support/own_domain.hpp"

namespace weft::contract {
namespace {

TEST(Diagnostics, OfFastDdsGoToStderr) {
  const test::OwnDomain domain;
  bus::BusConfig config;
  config.role = msg::Role::server;
  config.self = kServerId;
  config.domain = domain.number();
  const auto opened = bus::open(bus::Vendor::fastdds, config);
  ASSERT_TRUE(opened) << opened.error().message;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EPROSIMA_LOG_ERROR(WEFT_TEST, "a datagram could not be sent");
  eprosima::fastdds::dds::Log::Flush();
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "") << "stdout carries answers";
  EXPECT_THAT(testing::internal::GetCapturedStderr(), testing::HasSubstr("a datagram could not be sent"));
}

}  // namespace
}  // namespace weft::contract
