#include "idl/bus/topics.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "idl/bus/link.hpp"

namespace weft::bus {
namespace {

TEST(Topics, DocumentIsTheCommittedOne) {
  std::ifstream file(WEFT_WIRE_DOCUMENT);
  const std::string committed{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(committed, wire_document()) << "run: build/dev/bin/weft-wire-doc > docs/wire.md";
}

TEST(Topics, NamesAreUniqueAndFitBothVendors) {
  std::set<std::string_view> names;
  for (const Topic& topic : topics()) {
    EXPECT_TRUE(names.insert(topic.name).second) << topic.name;
    for (const char c : topic.name) {
      EXPECT_TRUE((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '/') << topic.name;
    }
    const bool is_hello = topic.id == TopicId::hello;
    EXPECT_EQ(topic.name.starts_with("weft/1/"), !is_hello) << topic.name;
  }
  EXPECT_EQ(topic(TopicId::hello).name, "weft/hello");
}

TEST(Topics, OneEndOfEachIsTheServer) {
  for (const Topic& topic : topics()) {
    if (topic.id == TopicId::hello) continue;
    EXPECT_NE(topic.writers.has(msg::Role::server), topic.readers.has(msg::Role::server)) << topic.name;
    EXPECT_TRUE(!topic.addressed || topic.writers.has(msg::Role::server)) << topic.name;
  }
}

TEST(Topics, StateIsKeyed) {
  for (const Topic& topic : topics()) EXPECT_EQ(topic.keyed, topic.delivering == Delivering::state) << topic.name;
}

TEST(Topics, LargestChunkFits) {
  msg::Chunk chunk;
  chunk.header.sender.bytes.fill(1);
  chunk.header.signature.resize(64);
  chunk.to.bytes.fill(2);
  chunk.data.resize(msg::kChunkBytes);
  chunk.total = chunk.data.size();
  chunk.hash.bytes.fill(3);
  EXPECT_TRUE(encode(chunk, msg::Role::server));
  EXPECT_TRUE(encode(chunk, msg::Role::agent));
}

TEST(Topics, LargestEchoFits) {
  msg::Echo echo;
  echo.header.sender.bytes.fill(1);
  echo.header.signature.resize(64);
  echo.to.bytes.fill(2);
  echo.load.resize(msg::kEchoBytes);
  EXPECT_TRUE(encode(echo, msg::Role::server));
  EXPECT_TRUE(encode(echo, msg::Role::client));
  EXPECT_FALSE(encode(echo, msg::Role::agent));
}

TEST(Topics, LargestReportFits) {
  msg::TaughtStretch stretch;
  stretch.first = {ExperienceId{1}, 0};
  stretch.reason = std::string(64, 'x');
  stretch.found.assign(msg::kReportConditions, {std::string(64, 'x'), 1.0, 0.0, 0.5});
  msg::AgentReply reply;
  reply.header.sender.bytes.fill(1);
  reply.report.assign(msg::kReportRows, stretch);
  EXPECT_TRUE(encode(reply, msg::Role::agent));
  msg::OperatorReply passed_on;
  passed_on.header = reply.header;
  passed_on.to.bytes.fill(2);
  passed_on.message = std::string(2048, 'x');
  passed_on.report = reply.report;
  EXPECT_TRUE(encode(passed_on, msg::Role::server));
}

TEST(Topics, LongestSignatureAndMostProposalsFit) {
  msg::Recognise asked;
  asked.header.sender.bytes.fill(1);
  asked.seen.assign(msg::kSignatureNumbers, 0.5F);
  asked.method = std::string(64, 'x');
  EXPECT_TRUE(encode(asked, msg::Role::agent));
  msg::Recognised answered;
  answered.header = asked.header;
  answered.to.bytes.fill(2);
  answered.message = std::string(2048, 'x');
  answered.places.assign(msg::kRecognisedPlaces, {ExperienceId{1}, 0});
  EXPECT_TRUE(encode(answered, msg::Role::server));
}

}  // namespace
}  // namespace weft::bus
