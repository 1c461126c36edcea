// A byte order mark before its text changes nothing of what a reader makes of it, nor the lines that it names.
#include <gtest/gtest.h>

#include "storage/formats/cloud.hpp"
#include "storage/formats/floor_plan.hpp"
#include "storage/formats/g2o.hpp"
#include "storage/formats/lines.hpp"
#include "storage/formats/pgm.hpp"
#include "storage/formats/route_graph.hpp"
#include "storage/formats/trajectory.hpp"
#include "tests/storage/formats/bytes_of.hpp"

namespace weft::formats {
namespace {

const std::string kOrderMark = "\xEF\xBB\xBF";

TEST(ByteOrderMark, IsNoPartOfTheFirstLine) {
  const std::string text = kOrderMark + "a\nb";
  Lines lines(text);
  EXPECT_EQ(lines.next(), "a");
  EXPECT_EQ(lines.number(), 1U);
  EXPECT_EQ(lines.offset(), kOrderMark.size() + 2);
  EXPECT_FALSE(Lines(kOrderMark).next().has_value());
}

TEST(ByteOrderMark, IsSkippedInGraphsAndTrajectories) {
  const auto graph =
      read_g2o(kOrderMark + "EDGE_SE2 1 2 1 0 0 1 0 0 1 0 1\nVERTEX_SE2 1 0 0 0\nVERTEX_SE2 2 0 0 0\n", "a");
  ASSERT_TRUE(graph.has_value()) << graph.error().message;
  EXPECT_EQ(graph->value.edges.size(), 1U);
  EXPECT_TRUE(graph->not_understood.empty());
  EXPECT_TRUE(read_tum(kOrderMark + "1 0 0 0 0 0 0 1\n", "a").has_value());
  EXPECT_TRUE(read_tum(kOrderMark + "# t x y z\n1 0 0 0 0 0 0 1\n", "a").has_value());
  EXPECT_TRUE(read_euroc_csv(kOrderMark + "#time\n1,0,0,0,1,0,0,0\n", "a").has_value());
  EXPECT_TRUE(read_route_graph(kOrderMark + R"({"type": "FeatureCollection", "features": []})", "a").has_value());
}

TEST(ByteOrderMark, IsSkippedInClouds) {
  const auto pcd =
      read_pcd(bytes_of(kOrderMark + "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nDATA ascii\n"
                                     "1 2 3\n"),
               "a");
  ASSERT_TRUE(pcd.has_value()) << pcd.error().message;
  EXPECT_TRUE(pcd->not_understood.empty());
  EXPECT_TRUE(
      read_ply(bytes_of(kOrderMark + "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                                     "property float z\nend_header\n1 2 3\n"),
               "a")
          .has_value());
}

TEST(ByteOrderMark, IsSkippedInFloorPlans) {
  EXPECT_TRUE(read_pgm(bytes_of(kOrderMark + "P2 1 1 9\n1"), "a").has_value());
  EXPECT_TRUE(read_map_server(kOrderMark +
                                  "image: a\nresolution: 1\norigin: [1, 2, 0]\nnegate: 0\noccupied_thresh: 1\n"
                                  "free_thresh: 0\n",
                              "a")
                  .has_value());
}

}  // namespace
}  // namespace weft::formats
