// Which form a content is kept and sent in, and that it comes back to the byte.
#include "storage/content_coder.hpp"

#include <gmock/gmock.h>

#include "tests/storage/clouds/sample_clouds.hpp"

namespace weft::storage {
namespace {

Coded expect_back(const Bytes& content) {
  ContentCoder coder;
  const Coded coded = coder.encode(content);
  const Bytes& kept = coded.coding == Coding::raw ? content : coded.bytes;
  EXPECT_EQ(coder.decode(coded.coding, kept, content.size()).value(), content);
  return coded;
}

TEST(ContentCoder, ACloudWithFeaturesIsKeptAsACloud) {
  const Bytes content = clouds::sample::place_content(1, 16'000);
  const Coded coded = expect_back(content);
  EXPECT_EQ(coded.coding, Coding::cloud);
  EXPECT_LT(coded.bytes.size() * 2, content.size());
}

TEST(ContentCoder, TheSameBytesWithSomethingInFrontAreNone) {
  Bytes content = clouds::sample::place_content(1, 1000);
  content.insert(content.begin(), 0);
  EXPECT_NE(expect_back(content).coding, Coding::cloud);
}

TEST(ContentCoder, BytesBehindACloudThatItsHeadDoesNotCountMakeItNone) {
  Bytes content = clouds::sample::place_content(1, 1000);
  content.push_back(0);
  EXPECT_NE(expect_back(content).coding, Coding::cloud);
}

TEST(ContentCoder, ACloudOfAnotherSizeThanStatedIsCorrupt) {
  const Bytes content = clouds::sample::place_content(1, 1000);
  ContentCoder coder;
  const Coded coded = coder.encode(content);
  const auto decoded = coder.decode(coded.coding, coded.bytes, content.size() - 1);
  ASSERT_FALSE(decoded);
  EXPECT_EQ(decoded.error().code, ErrorCode::corrupt);
  EXPECT_THAT(decoded.error().message, testing::HasSubstr(std::to_string(content.size())));
}

}  // namespace
}  // namespace weft::storage
