#include <gtest/gtest.h>

#include "tests/clients/evaluate/parsed.hpp"

namespace weft::evaluate {
namespace {

TEST(BearingInvocation, OneTrialIfQuick) {
  EXPECT_EQ(std::get<BearingOptions>(parsed({"bearing"})).seeds.last, 2U);
  EXPECT_EQ(std::get<BearingOptions>(parsed({"bearing", "--quick"})).trial, "oval-behind");
}

TEST(BearingInvocation, LookAlikesAreFewIfQuick) {
  const auto plain = std::get<BearingRelocaliseOptions>(parsed({"bearing-relocalise"}));
  EXPECT_EQ(plain.seeds.last, 4U);
  EXPECT_EQ(plain.trials, 11U);
  EXPECT_EQ(plain.site, "deploy/sites/bearing/yard.toml");
  EXPECT_EQ(plain.out, "out/bearing-relocalise");
  const auto quick = std::get<BearingRelocaliseOptions>(parsed({"bearing-relocalise", "--quick"}));
  EXPECT_EQ(quick.seeds.last, 1U);
  EXPECT_EQ(quick.trials, 2U);
  const auto given = std::get<BearingRelocaliseOptions>(
      parsed({"bearing-relocalise", "--quick", "--seeds", "3..5", "--trials", "7", "--kind", "k"}));
  EXPECT_EQ(given.seeds.last, 5U);
  EXPECT_EQ(given.trials, 7U);
  EXPECT_EQ(given.kind, "k");
}

}  // namespace
}  // namespace weft::evaluate
