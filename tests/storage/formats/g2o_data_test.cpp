#include <gtest/gtest.h>

#include "core/network/network.hpp"
#include "storage/formats/g2o.hpp"
#include "storage/formats/import.hpp"
#include "tests/storage/formats/data_files.hpp"

namespace weft::formats::test {
namespace {

class G2oFiles : public testing::Test {
 protected:
  void SetUp() override {
    const auto data = data_folder();
    if (!data) GTEST_SKIP() << no_data("pose graphs");
    folder_ = *data;
    files_ = files_that_end(folder_, ".g2o");
    if (files_.empty()) GTEST_SKIP() << no_data("pose graphs (*.g2o)");
  }
  PoseGraph graph(const std::string& file) const {
    const auto read = read_g2o(read_text(folder_ / file), file);
    if (!read) throw std::runtime_error(read.error().message);
    return read->value;
  }
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> files_;
};

TEST_F(G2oFiles, EveryLineIsUnderstood) {
  for (const auto& file : files_) {
    const std::string text = read_text(file);
    const auto read = read_g2o(text, file.string());
    ASSERT_TRUE(read.has_value()) << read.error().message;
    EXPECT_TRUE(read->not_understood.empty()) << to_string(read->not_understood.front(), file.string());
    EXPECT_EQ(read->value.vertices.size(), lines_with(text, "VERTEX_SE2") + lines_with(text, "VERTEX_SE3:QUAT"))
        << file;
    EXPECT_EQ(read->value.edges.size(), lines_with(text, "EDGE_SE2") + lines_with(text, "EDGE_SE3:QUAT")) << file;
    EXPECT_GT(read->value.edges.size(), 10U) << file;
  }
}

TEST_F(G2oFiles, WhatIsWrittenIsReadBackTheSame) {
  for (const auto& file : files_) {
    const auto first = read_g2o(read_text(file), file.string());
    ASSERT_TRUE(first.has_value()) << first.error().message;
    const auto second = read_g2o(g2o_text(first->value), "written");
    ASSERT_TRUE(second.has_value()) << second.error().message;
    EXPECT_TRUE(identical(first->value, second->value)) << file;
  }
}

/// Returns the network of an import, through the checks that a server's intake makes.
Snapshot taken_in(const Import& import) {
  Snapshot network;
  for (const Batch& batch : import.batches) {
    const std::vector<Error> issues = check(network, batch);
    EXPECT_TRUE(issues.empty()) << issues.front().message;
    if (!issues.empty()) return network;
    network = with(network, batch);
  }
  return network;
}

TEST_F(G2oFiles, EachBecomesANetworkThatIntakeTakes) {
  for (const auto& file : files_) {
    const auto read = read_g2o(read_text(file), file.string());
    ASSERT_TRUE(read.has_value()) << read.error().message;
    const auto import = import_of(read->value, "site");
    ASSERT_TRUE(import.has_value()) << import.error().message;
    const Snapshot network = taken_in(*import);
    EXPECT_EQ(network.place_count(), import->place_of_key.size()) << file;
    const std::size_t declared = read->value.vertices.size();
    EXPECT_TRUE(declared == 0 || network.place_count() == declared) << file;
    for (const auto& [id, experience] : network.experiences()) EXPECT_TRUE(experience->sealed);
  }
}

TEST_F(G2oFiles, AChainIsOneExperienceAndItsLoopsAreStitches) {
  // 3500 places in one chain, 5453 edges; SE-Sync's table of data sets has the same numbers.
  const auto import = import_of(graph("pose-graphs/M3500a.g2o"), "site");
  ASSERT_TRUE(import.has_value());
  const Snapshot network = taken_in(*import);
  EXPECT_EQ(network.experiences().size(), 1U);
  EXPECT_EQ(network.place_count(), 3500U);
  EXPECT_EQ(network.stitch_count(), 5453U - 3499U);
  EXPECT_TRUE(import->left_out.empty());
}

TEST_F(G2oFiles, SecondEdgesOfAPairAreSaid) {
  for (const char* const file : {"pose-graphs/kitti_00.g2o", "pose-graphs/CSAIL.g2o"}) {
    const auto import = import_of(graph(file), "site");
    ASSERT_TRUE(import.has_value());
    ASSERT_EQ(import->left_out.size(), 1U) << file;
    EXPECT_EQ(import->left_out[0], "1 edges between vertices that another edge joins already");
  }
}

TEST_F(G2oFiles, FilesOfSeveralRobotsJoinToTheWholeGraph) {
  const std::string folder = "multi-robot-graphs/blocks_world/2robots/";
  const PoseGraph one = graph(folder + "0.g2o");
  const auto joined = join({one, graph(folder + "1.g2o")});
  ASSERT_TRUE(joined.has_value()) << joined.error().message;
  const PoseGraph whole = graph(folder + "fullGraph.g2o");
  EXPECT_EQ(joined->vertices.size(), whole.vertices.size());
  EXPECT_EQ(joined->edges.size(), whole.edges.size());
  EXPECT_EQ(robot_of(one.vertices.front().key), 'a');
  const auto alone = import_of(one, "site");
  ASSERT_TRUE(alone.has_value());
  ASSERT_EQ(alone->left_out.size(), 1U);
  EXPECT_EQ(alone->left_out[0], "16 edges to vertices of other files");
  const auto together = import_of(*joined, "site");
  ASSERT_TRUE(together.has_value());
  EXPECT_TRUE(together->left_out.empty());
  EXPECT_EQ(taken_in(*together).place_count(), 64U);
}

}  // namespace
}  // namespace weft::formats::test
