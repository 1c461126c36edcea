#include "server/queries/echoes.hpp"

#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"

namespace weft::server::test {
namespace {

struct EchoesTest : testing::Test {
  void echo(std::size_t bytes, std::uint32_t number = 1) {
    site.say(msg::Echo{site.client.header(), {}, 5, number, Bytes(bytes, std::uint8_t{0x55})});
  }
  std::size_t returned() const { return site.heard<msg::Echo>().size(); }
  Site site;
};

TEST_F(EchoesTest, AnEchoComesBackToItsSenderAsItIs) {
  echo(300, 17);
  const msg::Echo back = site.last<msg::Echo>().value();
  EXPECT_EQ(back.to, site.client.id);
  EXPECT_EQ(back.request, 5U);
  EXPECT_EQ(back.number, 17U);
  EXPECT_EQ(back.load, Bytes(300, std::uint8_t{0x55}));
}

TEST_F(EchoesTest, WhatIsBeyondTheBudgetIsCountedAndNotAnswered) {
  constexpr std::size_t kBytes = msg::kEchoBytes;
  const auto fits = static_cast<std::size_t>(Echoes::kBurstBytes / (Echoes::kBytesBeside + kBytes));
  for (std::size_t i = 0; i < fits + 3; ++i) echo(kBytes);
  EXPECT_EQ(returned(), fits);
  EXPECT_EQ(site.counted("echo: beyond the budget of all clients, not answered"), 3U);
  site.pass(1s);
  site.hush();
  for (std::size_t i = 0; i < fits + 3; ++i) echo(kBytes);
  EXPECT_EQ(returned(), fits) << "a second fills the budget, and no more than that";
}

TEST_F(EchoesTest, WhatOneDoctorSendsFits) {
  // A second of the flow of `weft doctor network`: 8 kB each 17 ms.
  for (int i = 0; i < 58; ++i) {
    echo(8'000);
    site.pass(17ms);
  }
  EXPECT_EQ(returned(), 58U);
}

}  // namespace
}  // namespace weft::server::test
