#include "storage/formats/g2o.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::formats {
namespace {

const std::string kTwo = "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\n";
const std::string kIdentity = " 1 0 0 1 0 1\n";
const std::string kIdentity6 = " 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n";

PoseGraph read(const std::string& text) {
  auto graph = read_g2o(text, "a.g2o");
  EXPECT_TRUE(graph.has_value()) << (graph ? "" : graph.error().message);
  return graph ? graph->value : PoseGraph{};
}

TEST(G2o, PlanarNumbersStandWhereTheyBelong) {
  const PoseGraph graph = read("# made by hand\r\n" + kTwo + "FIX 0\nEDGE_SE2 0 1 1 2 0.5 11 1 2 22 3 33\n");
  ASSERT_EQ(graph.vertices.size(), 2U);
  EXPECT_EQ(std::get<Pose2>(graph.vertices[1].estimate), (Pose2{1.0, 0.0, 0.0}));
  EXPECT_EQ(graph.fixed, (std::vector<std::uint64_t>{0}));
  ASSERT_EQ(graph.edges.size(), 1U);
  const auto& seen = std::get<PlanarMeasurement>(graph.edges[0].seen);
  EXPECT_EQ(seen.a_from_b, (Pose2{1.0, 2.0, 0.5}));
  Eigen::Matrix3d information;
  information << 11, 1, 2, 1, 22, 3, 2, 3, 33;
  EXPECT_EQ(seen.information, information);
}

TEST(G2o, QuaternionsAreXyzwAndMadeUnit) {
  const PoseGraph graph = read("VERTEX_SE3:QUAT 7 1 2 3 0 0 0.70711 0.70711\n");
  const auto& pose = std::get<Pose3>(graph.vertices[0].estimate);
  EXPECT_EQ(pose.translation, Eigen::Vector3d(1, 2, 3));
  EXPECT_NEAR(pose.rotation.z(), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(pose.rotation.w(), std::sqrt(0.5), 1e-12);
  EXPECT_EQ(pose.rotation.x(), 0.0);
}

TEST(G2o, OtherTagsAreListedWithLineAndNumber) {
  const auto graph = read_g2o("VERTEX_XY 5 1 1\n" + kTwo + "VERTEX_XY 6 1 1\nEDGE_SE2_XY 0 5 1 1 1 0 1\n", "a.g2o");
  ASSERT_TRUE(graph.has_value());
  EXPECT_EQ(graph->not_understood, (std::vector<NotUnderstood>{{"VERTEX_XY", 1, 2}, {"EDGE_SE2_XY", 5, 1}}));
}

TEST(G2o, WithoutAnyVertexTheEdgesNameThem) {
  EXPECT_EQ(read("EDGE_SE2 4 9 1 0 0" + kIdentity).edges.size(), 1U);
}

TEST(G2o, AnotherRobotsVertexMayBeElsewhere) {
  const std::uint64_t mine = std::uint64_t{'a'} << 56U;
  const std::uint64_t other = std::uint64_t{'b'} << 56U;
  const std::string text = "VERTEX_SE2 " + std::to_string(mine) + " 0 0 0\nEDGE_SE2 " + std::to_string(mine) + " " +
                           std::to_string(other) + " 1 0 0" + kIdentity;
  EXPECT_EQ(read(text).edges.size(), 1U);
}

TEST(G2o, WhatNamesAVertexThatIsNotThereIsLeftOutAndListed) {
  const auto graph = read_g2o("FIX 0\nFIX 99 1\n" + kTwo + "EDGE_SE2 0 1 1 0 0" + kIdentity + "EDGE_SE2 1 9 1 0 0" +
                                  kIdentity + "EDGE_SE2 9 1 1 0 0" + kIdentity,
                              "a.g2o");
  ASSERT_TRUE(graph.has_value()) << graph.error().message;
  EXPECT_EQ(graph->value.vertices.size(), 2U);
  EXPECT_EQ(graph->value.edges.size(), 1U);
  EXPECT_EQ(graph->value.fixed, (std::vector<std::uint64_t>{0, 1}));
  EXPECT_EQ(graph->not_understood, (std::vector<NotUnderstood>{{"an edge to a vertex that is not declared", 6, 2},
                                                               {"FIX of a vertex that is not declared", 2, 1}}));
}

TEST(G2o, ALandmarkMayBeFixed) {
  const auto graph = read_g2o(kTwo + "VERTEX_XY 7 3 3\nFIX 7\nFIX 0\nEDGE_SE2 0 7 1 0 0" + kIdentity, "a.g2o");
  ASSERT_TRUE(graph.has_value()) << graph.error().message;
  EXPECT_EQ(graph->value.fixed, (std::vector<std::uint64_t>{0}));
  EXPECT_TRUE(graph->value.edges.empty());
  EXPECT_EQ(graph->not_understood, (std::vector<NotUnderstood>{{"VERTEX_XY", 3, 1},
                                                               {"an edge to a vertex that is not taken", 6, 1},
                                                               {"FIX of a vertex that is not taken", 4, 1}}));
}

TEST(G2o, WhatIsWrongIsSaidWithItsLine) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {kTwo + "EDGE_SE2 0 1 1 0 0 1 0 0 1 0\n", "a.g2o:3: EDGE_SE2 has 10 numbers, it needs 11"},
      {"VERTEX_SE2 0 0 0\n", "a.g2o:1: VERTEX_SE2 has 3 numbers, it needs 4"},
      {"VERTEX_SE2 0 0 0 nan\n", "a.g2o:1: 'nan' is no finite number"},
      {"VERTEX_SE2 0 0 0 0.1rad\n", "a.g2o:1: '0.1rad' is no finite number"},
      {"VERTEX_SE2 -1 0 0 0\n", "a.g2o:1: '-1' is no vertex id, a whole number from 0"},
      {kTwo + "\nVERTEX_SE2 1 0 0 0\n", "a.g2o:4: vertex 1 is declared a second time, first in line 2"},
      {kTwo + "FIX\n", "a.g2o:3: FIX names no vertex"},
      {kTwo + "EDGE_SE2 1 1 1 0 0" + kIdentity, "a.g2o:3: the edge joins vertex 1 to itself"},
      {kTwo + "EDGE_SE2 0 1 1 0 0 1 0 0 0 0 1\n", "a.g2o:3: the information matrix is not positive definite"},
      {kTwo + "EDGE_SE2 0 1 1 0 0 1 2 0 1 0 1\n", "a.g2o:3: the information matrix is not positive definite"},
      {"VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1.1\n", "a.g2o:1: the quaternion is not unit within 1e-3"},
      {"VERTEX_SE3:QUAT 0 0 0 0 0 0 0 0\n", "a.g2o:1: the quaternion is not unit within 1e-3"},
      {kTwo + "EDGE_SE3:QUAT 0 1 0 0 0 0 0 0 1" + kIdentity6,
       "a.g2o:3: a spatial entry in a graph that line 1 began as a planar one"}};
  for (const auto& [text, message] : table) {
    const auto graph = read_g2o(text, "a.g2o");
    ASSERT_FALSE(graph.has_value()) << message;
    EXPECT_EQ(graph.error().message, message);
    EXPECT_EQ(graph.error().code, ErrorCode::invalid);
  }
}

TEST(G2o, JoinRefusesWhatContradicts) {
  const PoseGraph one = read(kTwo);
  const PoseGraph moved = read("VERTEX_SE2 1 1 0 0.1\n");
  const PoseGraph spatial = read("VERTEX_SE3:QUAT 5 0 0 0 0 0 0 1\n");
  EXPECT_EQ(join({one, moved}).error().message, "vertex 1 stands in two graphs with different estimates");
  EXPECT_EQ(join({one, spatial}).error().code, ErrorCode::conflict);
  EXPECT_TRUE(identical(*join({one, one}), one));
}

}  // namespace
}  // namespace weft::formats
