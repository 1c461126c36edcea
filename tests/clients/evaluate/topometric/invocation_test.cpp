#include <gtest/gtest.h>

#include "tests/clients/evaluate/parsed.hpp"

namespace weft::evaluate {
namespace {

TEST(TopometricInvocation, FlagsAndDefaults) {
  const auto plain = std::get<TopometricOptions>(parsed({"topometric"}));
  EXPECT_EQ(plain.seeds.first, 1U);
  EXPECT_EQ(plain.seeds.last, 5U);
  EXPECT_EQ(plain.extent.width_px, 320);
  EXPECT_FALSE(plain.extent.is_quick);
  EXPECT_FALSE(plain.is_json);
  EXPECT_EQ(plain.trial, "");
  EXPECT_EQ(plain.scenes, "deploy/sites/topometric");
  EXPECT_EQ(plain.out, "out/topometric");
  const auto given = std::get<TopometricOptions>(parsed({"topometric", "--seeds", "2..3", "--trial", "night",
                                                         "--size", "480", "--scenes", "s", "--out", "o", "--json"}));
  EXPECT_EQ(given.seeds.first, 2U);
  EXPECT_EQ(given.trial, "night");
  EXPECT_EQ(given.extent.width_px, 480);
  EXPECT_EQ(given.scenes, "s");
  EXPECT_EQ(given.out, "o");
  EXPECT_TRUE(given.is_json);
}

TEST(TopometricInvocation, OneSeedIfQuick) {
  const auto quick = std::get<TopometricOptions>(parsed({"topometric", "--quick"}));
  EXPECT_EQ(quick.seeds.last, 1U);
  EXPECT_TRUE(quick.extent.is_quick);
}

TEST(TopometricInvocation, WhatThereIsNotIsRefused) {
  EXPECT_EQ(std::get<NotRun>(parsed({"topometric", "--trial", "deliver"})).exit_code, 2);
  EXPECT_EQ(std::get<NotRun>(parsed({"topometric", "--size", "640"})).exit_code, 2);
  EXPECT_EQ(std::get<NotRun>(parsed({"topometric", "--quick", "--trial", "map"})).exit_code, 2);
}

}  // namespace
}  // namespace weft::evaluate
