#include "clients/evaluate/taught_map.hpp"

#include <gtest/gtest.h>

#include "core/network/codec.hpp"

namespace weft::evaluate {
namespace {

constexpr ExperienceId kRun{1};

agents::Kept kept(std::uint32_t index, Bytes content) {
  agents::Kept one;
  one.place.id = {kRun, index};
  one.place.method = "along";
  one.place.content = {hash_bytes(content), content.size()};
  one.place.robot = RobotId{{1}};
  one.content = std::move(content);
  if (index == 0) return one;
  Edge edge;
  edge.id = {{kRun, index - 1}, {kRun, index}};
  edge.a_from_b = AlongPath{0.2, 1e-4, 0.0, 1e-4};
  edge.method = "along";
  one.edges.push_back(edge);
  return one;
}

TEST(TaughtMap, APlaceTakesWhatWasLearnedUponItsContent) {
  TaughtMap map;
  const auto taken = map.take(kRun, RobotId{{1}}, "along", {kept(0, {1}), kept(1, {2})});
  ASSERT_TRUE(taken) << taken.error().message;
  const Revision before = map.snapshot().revision();
  const agents::LearnedPlace learned_place{{kRun, 1}, hash_bytes(Bytes{2}), 2, {3, 4}};
  EXPECT_TRUE(map.take(learned_place));
  const Place* const place = map.view().window.place({kRun, 1});
  ASSERT_NE(place, nullptr);
  EXPECT_EQ(place->entity_version, 2U);
  EXPECT_EQ(place->content_format, 2U);
  EXPECT_EQ(place->content.size, 2U);
  EXPECT_EQ(*map.find(place->content.hash), (Bytes{3, 4}));
  EXPECT_GT(map.snapshot().revision(), before);
  EXPECT_EQ(map.view().window.place({kRun, 0})->entity_version, 1U);
  EXPECT_EQ(map.view().window.edges.size(), 1U);
}

TEST(TaughtMap, WhatWasLearnedUponAnotherContentIsVoid) {
  TaughtMap map;
  ASSERT_TRUE(map.take(kRun, RobotId{{1}}, "along", {kept(0, {1})}));
  const Revision before = map.snapshot().revision();
  EXPECT_FALSE(map.take({{kRun, 0}, hash_bytes(Bytes{9}), 2, {3}}));
  EXPECT_FALSE(map.take({{kRun, 5}, hash_bytes(Bytes{1}), 2, {3}}));
  EXPECT_EQ(map.snapshot().revision(), before);
}

}  // namespace
}  // namespace weft::evaluate
