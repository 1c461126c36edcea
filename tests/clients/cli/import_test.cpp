#include <gtest/gtest.h>

#include <chrono>
#include <fstream>

#include "clients/cli/uploader.hpp"
#include "tests/clients/cli/fleet.hpp"

namespace weft::cli::test {
namespace {
using namespace std::chrono_literals;

std::string file_of(const std::string& name, const std::string& text) {
  const std::string file = (folder() / name).string();
  std::ofstream(file) << text;
  return file;
}

/// Returns a chain with one loop at its end, as a g2o file.
std::string chain(int length) {
  std::string text;
  for (int i = 0; i + 1 < length; ++i) {
    text += "EDGE_SE2 " + std::to_string(i) + " " + std::to_string(i + 1) + " 1 0 0 100 0 0 100 0 400\n";
  }
  return text + "EDGE_SE2 0 " + std::to_string(length - 1) + " 0.5 0 0 100 0 0 100 0 400\n";
}

TEST(Import, AGraphJoinsTheMapThroughIntake) {
  Fleet fleet;
  const std::size_t before = fleet.service->snapshot().place_count();
  const Said said = fleet.weft({"map", "import", file_of("a.g2o", chain(750)), "--as", "site", "--json"});
  ASSERT_EQ(said.exit, Exit::done) << said.err;
  EXPECT_EQ(said.json()["places"], 750);
  EXPECT_EQ(said.json()["experiences"], 1);
  EXPECT_EQ(said.json()["stitches"], 1);
  EXPECT_EQ(fleet.service->snapshot().place_count(), before + 750);
  EXPECT_EQ(fleet.service->snapshot().experiences().size(), 3U);
  // It is a client's, not one more robot that has fallen silent.
  EXPECT_TRUE(fleet.weft({"robots", "--json"}).json()["robots"].empty());
}

TEST(Import, AgainIsHarmlessAndAnotherFileOfThatNameIsRefused) {
  Fleet fleet;
  const std::string file = file_of("a.g2o", chain(50));
  ASSERT_EQ(fleet.weft({"map", "import", file, "--as", "site"}).exit, Exit::done);
  const std::size_t places = fleet.service->snapshot().place_count();
  EXPECT_EQ(fleet.weft({"map", "import", file, "--as", "site"}).exit, Exit::done);
  EXPECT_EQ(fleet.service->snapshot().place_count(), places);
  const Said other = fleet.weft({"map", "import", file_of("b.g2o", chain(60)), "--as", "site"});
  EXPECT_EQ(other.exit, Exit::refused);
  EXPECT_NE(other.err.find("another hash"), std::string::npos) << other.err;
  EXPECT_EQ(fleet.service->snapshot().place_count(), places);
  EXPECT_EQ(fleet.weft({"map", "import", file_of("b.g2o", chain(60)), "--as", "hall"}).exit, Exit::done);
}

TEST(Import, AnExportComesBackUnderItsNameWithItsLabels) {
  Fleet fleet;
  const std::string file = (folder() / "whole.g2o").string();
  ASSERT_EQ(fleet.weft({"map", "export", file}).exit, Exit::done);
  const Snapshot before = fleet.service->snapshot();
  const Said said = fleet.weft({"map", "import", file, "--as", "copy"});
  ASSERT_EQ(said.exit, Exit::done) << said.err;
  const Snapshot after = fleet.service->snapshot();
  EXPECT_EQ(after.place_count(), 2 * before.place_count());
  EXPECT_EQ(after.stitch_count(), 2 * before.stitch_count());
  EXPECT_EQ(after.labels().at("dock"), before.labels().at("dock"));
  EXPECT_EQ(after.labels().at("copy.dock").index, 30U);
}

TEST(Import, WhatCannotBeReadIsSaid) {
  Fleet fleet;
  const Said wrong = fleet.weft({"map", "import", file_of("c.g2o", "EDGE_SE2 0 1 1\n"), "--as", "site"});
  EXPECT_EQ(wrong.exit, Exit::usage);
  EXPECT_NE(wrong.err.find("c.g2o:1: EDGE_SE2 has 3 numbers"), std::string::npos);
  EXPECT_EQ(fleet.weft({"map", "import", file_of("c.geojson", "{}"), "--as", "site"}).exit, Exit::usage);
  EXPECT_EQ(fleet.weft({"map", "import", file_of("a.g2o", chain(5)), "--as", "no name"}).exit, Exit::usage);
  EXPECT_EQ(fleet.weft({"map", "import", file_of("a.g2o", chain(5))}).exit, Exit::usage);
}

std::size_t batches_in(const std::vector<msg::Message>& messages) {
  std::size_t count = 0;
  for (const msg::Message& message : messages) count += std::holds_alternative<msg::ExperienceBatch>(message) ? 1 : 0;
  return count;
}

TEST(Uploader, RepeatsUntilAcknowledgedAndSendsWhatIsMissing) {
  std::vector<Batch> batches(7);
  for (std::size_t i = 0; i < batches.size(); ++i) {
    batches[i].experience = {i < 6 ? 1U : 2U};
    batches[i].sequence = i < 6 ? i + 1 : 1;
  }
  ContentHash hash;
  hash.bytes.fill(3);
  const std::map<ContentHash, Bytes> contents = {{hash, Bytes(msg::kChunkBytes + 1)}};
  Uploader uploader(batches, contents);
  SteadyTime now{};
  EXPECT_EQ(batches_in(uploader.due(now)), 4U);
  EXPECT_EQ(batches_in(uploader.due(now)), 0U);
  now += 3s;
  EXPECT_EQ(batches_in(uploader.due(now)), 4U);  // nothing was heard
  msg::BatchAck ack;
  ack.experience = {1};
  ack.durable_through = 2;
  ack.missing = {hash};
  ASSERT_TRUE(uploader.hear(ack).has_value());
  EXPECT_EQ(uploader.due(now).size(), 2U + 2U);  // two chunks, batches 5 and 6
  ASSERT_TRUE(uploader.hear(ack).has_value());
  EXPECT_TRUE(uploader.due(now).empty());  // the same list again: they are on their way
  now += 3s;
  ASSERT_TRUE(uploader.hear(ack).has_value());
  EXPECT_EQ(uploader.due(now).size(), 2U + 4U);  // lost, it seems
  ack.durable_through = 6;
  ack.missing.clear();
  ASSERT_TRUE(uploader.hear(ack).has_value());
  EXPECT_EQ(batches_in(uploader.due(now)), 1U);  // the next experience
  EXPECT_FALSE(uploader.done());
  ack.experience = {2};
  ack.durable_through = 1;
  ASSERT_TRUE(uploader.hear(ack).has_value());
  EXPECT_TRUE(uploader.done());
}

TEST(Uploader, ARefusalEndsItInTheServersWords) {
  std::vector<Batch> batches(1);
  batches[0].experience = {1};
  batches[0].sequence = 1;
  const std::map<ContentHash, Bytes> nothing;
  Uploader uploader(batches, nothing);
  msg::BatchAck ack;
  ack.experience = {1};
  ack.refused_sequence = 1;
  ack.refusal = "no room";
  const Result<void> heard = uploader.hear(ack);
  ASSERT_FALSE(heard.has_value());
  EXPECT_EQ(heard.error().code, ErrorCode::refused);
  EXPECT_NE(heard.error().message.find("no room"), std::string::npos);
}

}  // namespace
}  // namespace weft::cli::test
