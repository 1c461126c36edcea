#include "idl/bus/interfaces.hpp"

#include <gtest/gtest.h>

namespace weft::bus {
namespace {

TEST(Reach, AServerOnAnotherMachineIsNotReachedFromLoopback) {
  const Result<void> refused = check_reach("127.0.0.1", "192.0.2.1");  // of no machine: RFC 5737
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::unavailable);
  EXPECT_NE(refused.error().message.find("--listen"), std::string::npos) << refused.error().message;
}

TEST(Reach, LoopbackAndOtherAddressesAreLeftAlone) {
  EXPECT_TRUE(check_reach("127.0.0.1", "127.0.0.1"));
  EXPECT_TRUE(check_reach("192.0.2.7", "192.0.2.1"));
  EXPECT_TRUE(check_reach("192.0.2.7", "127.0.0.1"));
}

}  // namespace
}  // namespace weft::bus
