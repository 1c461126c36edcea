#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>

#include "idl/bus/link.hpp"
#include "idl/bus/topics.hpp"
#include "tests/idl/examples.hpp"
#include "tests/idl/golden_files.hpp"

namespace weft::bus {
namespace {

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const Example& example : examples()) all.push_back(example.name);
  return all;
}

Example example_named(const std::string& name) {
  for (const Example& example : examples()) {
    if (example.name == name) return example;
  }
  std::abort();
}

class Golden : public testing::TestWithParam<std::string> {};

// WEFT_UPDATE_GOLDEN=1 writes the files anew: only for a new message or a new major version.
TEST_P(Golden, EncodesToTheseBytes) {
  const Example example = example_named(GetParam());
  const Result<Encoded> encoded = encode(example.message, example.sender);
  ASSERT_TRUE(encoded) << encoded.error().message;
  if (std::getenv("WEFT_UPDATE_GOLDEN") != nullptr) std::ofstream(golden_path(GetParam())) << hex_text(encoded->cdr);
  EXPECT_EQ(hex_text(encoded->cdr), hex_text(read_golden(GetParam())));
}

TEST_P(Golden, DecodesAndEncodesToTheSameBytes) {
  const Example example = example_named(GetParam());
  const Bytes golden = read_golden(GetParam());
  const Result<Encoded> encoded = encode(example.message, example.sender);
  ASSERT_TRUE(encoded);
  const Result<msg::Message> message = decode(encoded->topic, golden);
  ASSERT_TRUE(message) << message.error().message;
  EXPECT_EQ(message->index(), example.message.index());
  const Result<Encoded> again = encode(*message, example.sender);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(hex_text(again->cdr), hex_text(golden));
  EXPECT_EQ(again->to, encoded->to);
}

TEST_P(Golden, EachShorterMessageIsRefused) {
  const Example example = example_named(GetParam());
  const Result<Encoded> encoded = encode(example.message, example.sender);
  ASSERT_TRUE(encoded);
  for (std::size_t size = 0; size < encoded->cdr.size(); ++size) {
    EXPECT_FALSE(decode(encoded->topic, ByteView(encoded->cdr).first(size))) << "of " << size << " bytes";
  }
  Bytes longer = encoded->cdr;
  longer.push_back(0);
  EXPECT_FALSE(decode(encoded->topic, longer));
}

// A changed byte gives another message or a refusal, never a crash (the sanitizers watch).
TEST_P(Golden, EachChangedByteIsReadOrRefused) {
  const Example example = example_named(GetParam());
  const Result<Encoded> encoded = encode(example.message, example.sender);
  ASSERT_TRUE(encoded);
  for (std::size_t i = 0; i < encoded->cdr.size(); ++i) {
    for (const int flip : {0x01, 0x80, 0xff}) {
      Bytes changed = encoded->cdr;
      changed[i] = static_cast<std::uint8_t>(changed[i] ^ flip);
      const Result<msg::Message> message = decode(encoded->topic, changed);
      if (message)
        EXPECT_EQ(message->index(), example.message.index());
      else
        EXPECT_EQ(message.error().code, ErrorCode::invalid);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(EachMessage, Golden, testing::ValuesIn(names()), [](const auto& of) { return of.param; });

TEST(Examples, CoverEachTopicAndMessage) {
  std::set<TopicId> covered;
  std::set<std::size_t> kinds;
  for (const Example& example : examples()) {
    const Result<Encoded> encoded = encode(example.message, example.sender);
    ASSERT_TRUE(encoded) << example.name << ": " << encoded.error().message;
    covered.insert(encoded->topic);
    kinds.insert(example.message.index());
  }
  EXPECT_EQ(covered.size(), kTopics);
  EXPECT_EQ(kinds.size(), std::variant_size_v<msg::Message>);
}

}  // namespace
}  // namespace weft::bus
