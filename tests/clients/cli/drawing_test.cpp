#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

#include "clients/cli/draw.hpp"
#include "clients/cli/exit.hpp"
#include "clients/cli/layout.hpp"
#include "core/network/change.hpp"
#include "tests/clients/cli/fleet.hpp"

namespace weft::cli::test {
namespace {

Window loops(bool stitched) {
  std::vector<Batch> batches = two_loops({0xA1}, {0xB2}, {}, {});
  if (!stitched) std::erase_if(batches.back().edges, [](const Edge& edge) { return edge.origin == Origin::stitch; });
  Snapshot snapshot;
  for (const Batch& batch : batches) snapshot = with(snapshot, batch);
  snapshot = with_label(snapshot, "dock", {{0xA1}, 30});
  return make_window(snapshot, WindowDefinition{});
}

Subject subject_of(Window network) {
  Subject subject;
  subject.layout = lay_out(network);
  subject.network = std::move(network);
  return subject;
}

std::string read(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(LayOut, RelationsHoldOnTheSheet) {
  const Window network = loops(true);
  const Layout layout = lay_out(network);
  EXPECT_EQ(layout.islands, 1U);
  ASSERT_EQ(layout.drawing_from_place.size(), network.places.size());
  for (const auto& [id, edge] : network.edges) {
    const Pose2 drawn = layout.drawing_from_place.at(id.a).inverse() * layout.drawing_from_place.at(id.b);
    EXPECT_NEAR(drawn.x, planar(edge.a_from_b).x, 1e-3);
    EXPECT_NEAR(drawn.y, planar(edge.a_from_b).y, 1e-3);
  }
}

TEST(LayOut, WhatNothingJoinsStandsSideBySide) {
  const Window network = loops(false);
  const Layout layout = lay_out(network);
  EXPECT_EQ(layout.islands, 2U);
  double first_right = -1e9;
  double second_left = 1e9;
  for (const auto& [id, pose] : layout.drawing_from_place) {
    if (id.experience.value == 0xA1) first_right = std::max(first_right, pose.x);
    if (id.experience.value == 0xB2) second_left = std::min(second_left, pose.x);
  }
  EXPECT_GT(second_left, first_right + 1.0);
}

TEST(Draw, MakesAPicture) {
  const std::filesystem::path file = folder() / "network.png";
  ASSERT_TRUE(draw(subject_of(loops(true)), file.string()).has_value());
  const std::string bytes = read(file);
  EXPECT_EQ(bytes.substr(1, 3), "PNG");
  EXPECT_GT(bytes.size(), 5000U);
}

/// Returns how many dashed strokes the vector picture of a network has.
std::size_t dashed_strokes(const Window& network) {
  const std::filesystem::path file = folder() / "network.svg";
  EXPECT_TRUE(draw(subject_of(network), file.string()).has_value());
  const std::string svg = read(file);
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  std::size_t count = 0;
  for (auto at = svg.find("stroke-dasharray"); at != std::string::npos; at = svg.find("stroke-dasharray", at + 1)) {
    ++count;
  }
  return count;
}

TEST(Draw, WhatIsJoinedByOdometryAloneIsDashedAndExplained) {
  std::vector<Batch> batches = two_loops({0xA1}, {0xB2}, {}, {});
  std::size_t blind = 0;
  Snapshot snapshot;
  for (Batch& batch : batches) {
    for (Edge& edge : batch.edges) {
      if (edge.origin != Origin::odometry || edge.id.a.index % 7 != 3) continue;
      edge.origin = Origin::blind;
      ++blind;
    }
    snapshot = with(snapshot, batch);
  }
  ASSERT_GT(blind, 0U);
  EXPECT_EQ(dashed_strokes(make_window(snapshot, WindowDefinition{})), blind + 1);
  EXPECT_EQ(dashed_strokes(loops(true)), 0U);
}

/// Draws one robot whose look is that, or without one the network's own picture; returns the picture's text.
std::string picture_with(std::optional<RobotMark::Look> look, std::vector<PlaceId> held = {}) {
  const std::filesystem::path file = folder() / "robots.svg";
  Subject subject = subject_of(loops(true));
  if (look.has_value()) {
    RobotMark robot;
    robot.name = robot.words = "r1";
    robot.look = *look;
    robot.drawing_from_robot = subject.layout.drawing_from_place.at({{0xA1}, 12});
    robot.radius_m = 0.4;
    robot.held = std::move(held);
    subject.robots = RobotsOnMap{{robot}, {}};
  }
  EXPECT_TRUE(draw(subject, file.string()).has_value());
  return read(file);
}

TEST(Draw, RobotsAndWhatTheyHoldAreInThePicture) {
  const std::string bare = picture_with(std::nullopt);
  const std::string heard = picture_with(RobotMark::Look::heard);
  const std::string held = picture_with(RobotMark::Look::heard, {{{0xA1}, 12}, {{0xA1}, 13}, {{0xA1}, 14}});
  EXPECT_NE(heard, bare);
  EXPECT_NE(picture_with(RobotMark::Look::lost), heard);
  EXPECT_NE(picture_with(RobotMark::Look::silent), heard);
  const std::string band = "stroke-opacity:0.5";  // nothing else is pale
  const std::string other = "stroke-opacity=\"0.5\"";
  EXPECT_TRUE(held.find(band) != std::string::npos || held.find(other) != std::string::npos);
  EXPECT_TRUE(heard.find(band) == std::string::npos && heard.find(other) == std::string::npos);
}

TEST(Draw, EmptyNetworkIsAPictureToo) {
  EXPECT_TRUE(draw(Subject{}, (folder() / "empty.png").string()).has_value());
}

TEST(Draw, OtherEndingsAndMissingFoldersAreRefused) {
  EXPECT_EQ(draw(Subject{}, "x.pdf").error().code, ErrorCode::invalid);
  // Not the operator's grammar, and no word of a server: it failed.
  EXPECT_EQ(exit_of(draw(Subject{}, "/nowhere/x.png").error()), Exit::failed);
  EXPECT_EQ(exit_of(draw(Subject{}, "/nowhere/x.svg").error()), Exit::failed);
}

}  // namespace
}  // namespace weft::cli::test
