#include "storage/formats/import.hpp"

#include <gtest/gtest.h>

#include "core/network/codec.hpp"
#include "storage/formats/g2o.hpp"
#include "storage/formats/network_export.hpp"
#include "tests/storage/formats/small_network.hpp"

namespace weft::formats::test {
namespace {

const std::string kUnit = " 1 0 0 1 0 1\n";

PoseGraph parsed(const std::string& text) {
  auto read = read_g2o(text, "a.g2o");
  EXPECT_TRUE(read.has_value()) << (read ? "" : read.error().message);
  return read ? read->value : PoseGraph{};
}

Snapshot network_of(const Import& import) {
  Snapshot network;
  for (const Batch& batch : import.batches) {
    for (const Error& issue : check(network, batch)) ADD_FAILURE() << issue.message;
    network = with(network, batch);
  }
  for (const auto& [label, place] : import.labels) network = with_label(network, label, place);
  return network;
}

TEST(Import, AnExportComesBackAsTheSameNetwork) {
  for (const bool spatial : {false, true}) {
    const SmallNetwork small = small_network(spatial);
    const auto exported = pose_graph_of(small.network, small.frame_from_place);
    ASSERT_TRUE(exported.has_value());
    const auto import = import_of(parsed(g2o_text(*exported)), "again");
    ASSERT_TRUE(import.has_value()) << import.error().message;
    EXPECT_TRUE(import->left_out.empty());
    const Window back = make_window(network_of(*import), WindowDefinition{});
    ASSERT_EQ(back.places.size(), small.network.places.size());
    ASSERT_EQ(back.edges.size(), small.network.edges.size());
    // Ids are new, made of the import's name; what they stand for is the same.
    std::map<PlaceId, PlaceId> now;
    auto vertex = exported->vertices.begin();
    for (const auto& [id, place] : small.network.places) now[id] = import->place_of_key.at((vertex++)->key);
    EXPECT_EQ(back.labels.at("dock"), now.at({{0xb2}, 2}));
    for (const auto& [id, edge] : small.network.edges) {
      const Edge* const same = back.edges.value({now.at(id.a), now.at(id.b)});
      ASSERT_NE(same, nullptr);
      EXPECT_EQ(same->origin, edge.origin);
      EXPECT_EQ(same->drivable, edge.drivable);
      EXPECT_NEAR(distance_m(same->a_from_b), distance_m(edge.a_from_b), 1e-12);
      EXPECT_NEAR(heading_rad(same->a_from_b), heading_rad(edge.a_from_b), 1e-12);
      EXPECT_TRUE(planar_covariance(same->a_from_b).isApprox(planar_covariance(edge.a_from_b), 1e-9));
    }
  }
}

TEST(Import, ChainsBreakWhereNothingJoinsTheNext) {
  const auto import = import_of(
      parsed("EDGE_SE2 0 1 1 0 0" + kUnit + "EDGE_SE2 3 2 1 0 0" + kUnit + "EDGE_SE2 0 3 5 0 0" + kUnit), "site");
  ASSERT_TRUE(import.has_value());
  const Snapshot network = network_of(*import);
  EXPECT_EQ(network.experiences().size(), 2U);
  EXPECT_EQ(network.stitch_count(), 1U);
  // Written from 3 to 2: turned round, so that it runs along the experience.
  const PlaceId two = import->place_of_key.at(2);
  EXPECT_EQ(two.index, 0U);
  const Experience* const second = network.experience(two.experience);
  ASSERT_EQ(second->chain.size(), 1U);
  EXPECT_NEAR(planar(second->chain[0].a_from_b).x, -1.0, 1e-12);
  EXPECT_EQ(second->chain[0].drivable, Drivable::a_to_b);
}

TEST(Import, RobotsByTheirLetterAreExperiencesOfTheirOwn) {
  const std::uint64_t a = std::uint64_t{'a'} << 56U;
  const std::uint64_t b = (std::uint64_t{'a'} << 56U) + (1ULL << 56U);
  const auto import =
      import_of(parsed("EDGE_SE2 " + std::to_string(a) + " " + std::to_string(b) + " 1 0 0" + kUnit), "site");
  ASSERT_TRUE(import.has_value());
  EXPECT_EQ(network_of(*import).experiences().size(), 2U);
}

TEST(Import, LongChainsComeInSeveralBatches) {
  std::string text;
  for (int i = 0; i < 500; ++i) {
    text += "EDGE_SE2 " + std::to_string(i) + " " + std::to_string(i + 1) + " 1 0 0" + kUnit;
  }
  const auto import = import_of(parsed(text), "site");
  ASSERT_TRUE(import.has_value());
  ASSERT_EQ(import->batches.size(), 6U);
  EXPECT_EQ(import->batches[5].sequence, 6U);
  EXPECT_FALSE(import->batches[4].seal);
  EXPECT_TRUE(import->batches[5].seal);
  EXPECT_EQ(network_of(*import).place_count(), 501U);
}

TEST(Import, AgainUnderTheSameNameIsARepeatAndUnderAnotherIsNot) {
  const PoseGraph one = parsed("EDGE_SE2 0 1 1 0 0" + kUnit);
  const auto first = import_of(one, "site");
  const auto again = import_of(one, "site");
  const auto other = import_of(one, "other");
  ASSERT_TRUE(first.has_value() && again.has_value() && other.has_value());
  EXPECT_EQ(hash(first->batches[0]), hash(again->batches[0]));
  EXPECT_NE(first->batches[0].experience, other->batches[0].experience);
  EXPECT_NE(first->robot, other->robot);
}

TEST(Import, WhatCannotBeImportedIsSaid) {
  EXPECT_EQ(import_of(PoseGraph{}, "site").error().message, "the graph has no vertices: nothing to import");
  EXPECT_EQ(import_of(parsed("EDGE_SE2 0 1 1 0 0" + kUnit), "no name").error().code, ErrorCode::invalid);
}

TEST(Import, StrangeNotesAreCounted) {
  const auto import =
      import_of(parsed("# weft tea 5\n# weft edge 0 1 stitch both\nEDGE_SE2 0 1 1 0 0" + kUnit), "site");
  ASSERT_TRUE(import.has_value());
  EXPECT_EQ(import->left_out, (std::vector<std::string>{"1 notes of ours that are not understood",
                                                        "1 notes of edges that do not suit where they lie"}));
}

TEST(ImportedContent, ReadsBackAndNamesWhatIsWrong) {
  const Pose3 pose{Eigen::Quaterniond(0.6, 0.0, 0.8, 0.0), {1.0, 2.0, 3.0}};
  for (const ImportedContent& content :
       {ImportedContent{5, std::nullopt}, ImportedContent{6, Pose2{1, 2, 3}}, ImportedContent{7, pose}}) {
    const Bytes bytes = encode(content);
    const auto back = decode_imported_content(bytes);
    ASSERT_TRUE(back.has_value()) << back.error().message;
    EXPECT_EQ(back->key, content.key);
    EXPECT_EQ(encode(*back), bytes);
  }
  Bytes bytes = encode(ImportedContent{6, Pose2{1, 2, 3}});
  bytes.pop_back();
  EXPECT_EQ(decode_imported_content(bytes).error().code, ErrorCode::corrupt);
  bytes = encode(ImportedContent{6, std::nullopt});
  bytes[8] = 3;
  EXPECT_NE(decode_imported_content(bytes).error().message.find("kind of estimate at byte 8"), std::string::npos);
}

}  // namespace
}  // namespace weft::formats::test
