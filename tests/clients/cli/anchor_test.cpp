#include "clients/cli/anchor.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "core/network/change.hpp"
#include "tests/clients/cli/fleet.hpp"

namespace weft::cli::test {
namespace {

Window two_parts(bool stitched) {
  std::vector<Batch> batches = two_loops({0xA1}, {0xB2}, {}, {});
  if (!stitched) std::erase_if(batches.back().edges, [](const Edge& edge) { return edge.origin == Origin::stitch; });
  Snapshot snapshot;
  for (const Batch& batch : batches) snapshot = with(snapshot, batch);
  snapshot = with_label(snapshot, "start", {{0xA1}, 0});
  snapshot = with_label(snapshot, "corner", {{0xA1}, 24});  // 12 m ahead, where the loop turns left
  snapshot = with_label(snapshot, "other", {{0xB2}, 3});
  return make_window(snapshot, WindowDefinition{});
}

Anchored held(const Window& network, const std::vector<Anchor>& anchors) {
  auto result = anchored(network, lay_out(network), anchors);
  EXPECT_TRUE(result.has_value()) << (result ? "" : result.error().message);
  return result ? *std::move(result) : Anchored{};
}

TEST(ParseAnchor, TakesPositionsAndHeadings) {
  const auto anchor = parse_anchor("dock=-1.5, 2,0.5");
  ASSERT_TRUE(anchor.has_value());
  EXPECT_EQ(anchor->label, "dock");
  EXPECT_EQ(anchor->position, Eigen::Vector2d(-1.5, 2.0));
  EXPECT_EQ(anchor->heading, 0.5);
  EXPECT_FALSE(parse_anchor("dock=1,2")->heading.has_value());
  for (const char* const wrong : {"dock", "=1,2", "dock=1", "dock=1,x", "dock=1,2,3,4", "dock=nan,1", "dock="}) {
    EXPECT_FALSE(parse_anchor(wrong).has_value()) << wrong;
  }
}

TEST(Anchored, OneAnchorPutsItsPlaceExactlyThere) {
  const Anchored result = held(two_parts(true), {{"start", {5.0, 7.0}, std::numbers::pi / 2}});
  const Pose2 start = result.layout.drawing_from_place.at({{0xA1}, 0});
  EXPECT_NEAR(start.x, 5.0, 1e-9);
  EXPECT_NEAR(start.y, 7.0, 1e-9);
  // Ahead of the start, which looks along the site's y.
  const Pose2 corner = result.layout.drawing_from_place.at({{0xA1}, 24});
  EXPECT_NEAR(corner.x, 5.0, 0.05);
  EXPECT_NEAR(corner.y, 19.0, 0.05);
  EXPECT_NEAR(result.worst_m, 0.0, 1e-9);
  EXPECT_EQ(to_text(result, 1), "held by one anchor");
}

TEST(Anchored, SeveralAreFittedAndTheResidualIsSaid) {
  // They lie 12 m apart and are said to be 12.4 m apart: 0.2 m are left at each.
  const Anchored result = held(two_parts(true), {{"start", {0.0, 0.0}, {}}, {"corner", {0.0, 12.4}, {}}});
  EXPECT_NEAR(result.worst_m, 0.2, 0.03);
  const Pose2 start = result.layout.drawing_from_place.at({{0xA1}, 0});
  EXPECT_NEAR(start.y, 0.2, 0.03);
  EXPECT_NEAR(start.heading, std::numbers::pi / 2, 0.01);
  EXPECT_EQ(to_text(result, 2).substr(0, 24), "2 anchors fit within 0.2");
}

TEST(Anchored, AnAnchorThatContradictsTheOthersIsNamedAndLeftOut) {
  Window network = two_parts(true);
  const Layout layout = lay_out(network);
  std::vector<Anchor> anchors;
  for (const std::uint32_t index : {0U, 6U, 12U, 18U, 24U}) {
    const std::string label = "p" + std::to_string(index);
    network.labels.insert_or_assign(label, PlaceId{{0xA1}, index});
    anchors.push_back({label, layout.drawing_from_place.at({{0xA1}, index}).translation(), std::nullopt});
  }
  anchors[3].position.x() += 2.0;
  const auto result = anchored(network, layout, anchors);
  ASSERT_TRUE(result.has_value()) << result.error().message;
  ASSERT_EQ(result->contradicting.size(), 1U);
  EXPECT_EQ(result->contradicting[0].label, "p18");
  EXPECT_NEAR(result->contradicting[0].off_m, 2.0, 1e-6);
  EXPECT_NEAR(result->worst_m, 0.0, 1e-6);
  EXPECT_EQ(to_text(*result, 5), "4 anchors fit within 0.00 m, p18 contradicts the others by 2.00 m and is left out");
}

TEST(Anchored, PartsThatNoAnchorHoldsAreLeftOut) {
  const Window network = two_parts(false);
  const Anchored result = held(network, {{"start", {0.0, 0.0}, 0.0}});
  EXPECT_GT(result.left_out, 10U);
  EXPECT_EQ(result.network.places.size() + result.left_out, network.places.size());
  for (const auto& [id, place] : result.network.places) EXPECT_EQ(id.experience, ExperienceId{0xA1});
  EXPECT_FALSE(result.network.labels.contains("other"));
  EXPECT_NE(to_text(result, 1).find("left out"), std::string::npos);
}

TEST(Anchored, WhatCannotBeFittedIsSaid) {
  const Window network = two_parts(false);
  const Layout layout = lay_out(network);
  EXPECT_EQ(anchored(network, layout, {{"nowhere", {0, 0}, 0.0}}).error().code, ErrorCode::not_found);
  EXPECT_EQ(anchored(network, layout, {{"start", {0, 0}, {}}}).error().code, ErrorCode::invalid);
  EXPECT_EQ(anchored(network, layout, {}).error().code, ErrorCode::invalid);
  EXPECT_EQ(anchored(network, layout, {{"start", {0, 0}, {}}, {"other", {1, 0}, {}}}).error().code,
            ErrorCode::invalid);
  EXPECT_EQ(anchored(network, layout, {{"start", {0, 0}, {}}, {"start", {0, 0}, {}}}).error().code,
            ErrorCode::invalid);
}

}  // namespace
}  // namespace weft::cli::test
