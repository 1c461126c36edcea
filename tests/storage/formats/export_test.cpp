#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <set>

#include "storage/formats/g2o.hpp"
#include "storage/formats/network_export.hpp"
#include "tests/storage/formats/small_network.hpp"

namespace weft::formats::test {
namespace {

std::size_t times(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST(PoseGraphOf, HasEveryPlaceAndEdgeAndReadsBack) {
  for (const bool spatial : {false, true}) {
    const SmallNetwork small = small_network(spatial);
    const auto graph = pose_graph_of(small.network, small.frame_from_place);
    ASSERT_TRUE(graph.has_value()) << graph.error().message;
    EXPECT_EQ(graph->vertices.size(), 7U);
    EXPECT_EQ(graph->edges.size(), small.network.edges.size());
    EXPECT_EQ(robot_of(graph->vertices.front().key), 'a');
    EXPECT_EQ(robot_of(graph->vertices.back().key), 'b');
    EXPECT_EQ(graph->vertices.front().estimate.index(), spatial ? 1U : 0U);
    const auto again = read_g2o(g2o_text(*graph), "g");
    ASSERT_TRUE(again.has_value()) << again.error().message;
    EXPECT_TRUE(identical(*graph, again->value));
  }
}

TEST(PoseGraphOf, InformationIsTheInverseOfTheCovariance) {
  const SmallNetwork small = small_network();
  const auto graph = pose_graph_of(small.network, small.frame_from_place);
  ASSERT_TRUE(graph.has_value());
  const auto& seen = std::get<PlanarMeasurement>(graph->edges.front().seen);
  const auto& relation = std::get<Metric2>(small.network.edges.begin()->second.a_from_b);
  EXPECT_EQ(seen.a_from_b, relation.a_from_b);
  EXPECT_TRUE((seen.information * relation.covariance).isIdentity(1e-9));
}

TEST(PoseGraphOf, WhatIsCertainGetsTheLeastVariance) {
  const SmallNetwork small = small_network();
  Window network;
  network.revision = small.network.revision;
  network.places = small.network.places;
  for (auto [id, held] : small.network.edges) {
    Edge certain = held;
    std::get<Metric2>(certain.a_from_b).covariance.setZero();
    network.edges.insert_or_assign(id, certain);
  }
  const auto graph = pose_graph_of(network, small.frame_from_place);
  ASSERT_TRUE(graph.has_value());
  const auto& seen = std::get<PlanarMeasurement>(graph->edges.front().seen);
  EXPECT_TRUE(seen.information.isApprox(Eigen::Matrix3d::Identity() * 1e12));
  EXPECT_TRUE(read_g2o(g2o_text(*graph), "g").has_value());
}

TEST(PoseGraphOf, APlaceWithoutAPoseIsNamed) {
  SmallNetwork small = small_network();
  small.frame_from_place.erase({{0xa1}, 2});
  const auto graph = pose_graph_of(small.network, small.frame_from_place);
  ASSERT_FALSE(graph.has_value());
  EXPECT_EQ(graph.error().code, ErrorCode::not_found);
  EXPECT_NE(graph.error().message.find("00000000000000a1:2"), std::string::npos);
}

TEST(RouteGraphOf, HasAnEdgeForEachWayThatCanBeDriven) {
  const SmallNetwork small = small_network();
  const auto graph = route_graph_of(small.network, small.frame_from_place);
  ASSERT_TRUE(graph.has_value()) << graph.error().message;
  EXPECT_EQ(graph->nodes.size(), 7U);
  EXPECT_EQ(graph->edges.size(), 5U + 2U);  // odometry one way, a stitch both ways, one no way
  EXPECT_NE(graph->nodes.back().metadata.find("\"labels\":\"dock\""), std::string::npos);
  EXPECT_NEAR(*graph->edges.front().cost, 1.0, 1e-12);
  const auto again = read_route_graph(route_graph_text(*graph), "g");
  ASSERT_TRUE(again.has_value()) << again.error().message;
  EXPECT_EQ(again->value, *graph);
}

TEST(TrajectoryOf, IsOneExperienceOverItsRobotsTime) {
  const SmallNetwork small = small_network();
  const auto trajectory = trajectory_of(small.network, small.frame_from_place, {0xa1});
  ASSERT_TRUE(trajectory.has_value()) << trajectory.error().message;
  ASSERT_EQ(trajectory->samples.size(), 4U);
  EXPECT_EQ(trajectory->samples[3].time_s, 1.5);
  EXPECT_EQ(trajectory->samples[3].frame_from_body.translation.x(), 3.0);
  EXPECT_EQ(trajectory_of(small.network, small.frame_from_place, {0xc3}).error().code, ErrorCode::not_found);
}

TEST(DotText, HasOneStatementAPlaceAndAnEdge) {
  SmallNetwork small = small_network();
  small.network.labels = {{"dock\"\\", {{0xb2}, 2}}};
  const std::string text = dot_text(small.network, small.frame_from_place);
  EXPECT_EQ(times(text, "experience="), 7U);
  EXPECT_EQ(times(text, " -> "), small.network.edges.size());
  EXPECT_EQ(times(text, "style=dashed"), 1U);
  EXPECT_EQ(times(text, "dir=both"), 1U);
  EXPECT_EQ(times(text, "dir=none"), 1U);
  EXPECT_NE(text.find(R"(label="dock\"\\")"), std::string::npos);
  EXPECT_NE(text.find(R"("00000000000000a1:0" -> "00000000000000a1:1" [origin=odometry)"), std::string::npos);
  EXPECT_EQ(text.find("pos="), text.find("pos=\"0,0!\""));
}

TEST(GraphmlText, IsWellFormedAndHoldsTheNetwork) {
  SmallNetwork small = small_network();
  small.network.labels = {{"dock <&\"> \x01", {{0xb2}, 2}}};
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(graphml_text(small.network, small.frame_from_place).c_str()), tinyxml2::XML_SUCCESS)
      << document.ErrorStr();
  const tinyxml2::XMLElement* const root = document.RootElement();
  std::set<std::string> declared;
  for (const auto* key = root->FirstChildElement("key"); key != nullptr; key = key->NextSiblingElement("key")) {
    EXPECT_TRUE(declared.insert(key->Attribute("id")).second);
  }
  std::size_t nodes = 0;
  std::size_t edges = 0;
  std::string labels;
  for (const auto* item = root->FirstChildElement("graph")->FirstChildElement(); item != nullptr;
       item = item->NextSiblingElement()) {
    (item->Name() == std::string("node") ? nodes : edges) += 1;
    for (const auto* data = item->FirstChildElement("data"); data != nullptr; data = data->NextSiblingElement()) {
      EXPECT_TRUE(declared.contains(data->Attribute("key"))) << data->Attribute("key");
      if (data->Attribute("key") == std::string("labels")) labels = data->GetText();
    }
  }
  EXPECT_EQ(nodes, 7U);
  EXPECT_EQ(edges, small.network.edges.size());
  EXPECT_EQ(labels, "dock <&\">  ");
}

}  // namespace
}  // namespace weft::formats::test
