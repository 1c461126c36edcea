#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/network/codec.hpp"
#include "storage/content_coder.hpp"
#include "tests/server/arranged_site.hpp"
#include "tests/storage/clouds/sample_clouds.hpp"

namespace weft::server::test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

struct Contents : testing::Test {
  Contents() {
    site.arrive(r1, std::nullopt);
    site.arrive(r2, std::nullopt);
  }
  void ask(const std::vector<msg::ContentRequest::Item>& items) {
    site.say(msg::ContentRequest{.header = r2.header(), .to = {}, .items = items});
  }
  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  Peer r2{.id = robot_id(2), .name = "r2"};
  TaughtRun run{r1, 10};
};

TEST_F(Contents, ServesAContentInChunks) {
  const Handed handed = run.next(1, 2 * msg::kChunkBytes + 5);
  site.hand_in(r1, handed);
  ask({{handed.batch.places[0].content.hash, 0}});
  Bytes got;
  for (const msg::Chunk& chunk : site.heard<msg::Chunk>()) {
    EXPECT_EQ(chunk.to, r2.id);
    EXPECT_EQ(chunk.offset, got.size());
    got.insert(got.end(), chunk.data.begin(), chunk.data.end());
  }
  EXPECT_EQ(got, handed.contents[0]);
}

TEST_F(Contents, GoesOnFromAnOffset) {
  const Handed handed = run.next(1, msg::kChunkBytes + 5);
  site.hand_in(r1, handed);
  ask({{handed.batch.places[0].content.hash, msg::kChunkBytes}});
  ASSERT_THAT(site.heard<msg::Chunk>(), SizeIs(1));
  EXPECT_EQ(site.last<msg::Chunk>()->data.size(), 5U);
}

TEST_F(Contents, ServesAContentAsItIsStored) {
  const Handed handed = run.next(1, 4 * msg::kChunkBytes, 16);
  const ContentRef stated = handed.batch.places[0].content;
  site.hand_in(r1, handed);
  ask({{stated.hash, 0}});
  Bytes got;
  for (const msg::Chunk& chunk : site.heard<msg::Chunk>()) {
    EXPECT_EQ(chunk.coding, msg::Coding::zstd);
    EXPECT_LT(chunk.total, stated.size * 6 / 10);
    got.insert(got.end(), chunk.data.begin(), chunk.data.end());
  }
  EXPECT_EQ(got.size(), site.last<msg::Chunk>()->total);
  EXPECT_EQ(storage::ContentCoder().decode(msg::Coding::zstd, got, stated.size).value(), handed.contents[0]);
}

TEST_F(Contents, ServesACloudWithFeaturesAsACloud) {
  Handed handed = run.next(1);
  handed.contents[0] = clouds::sample::place_content(2, 9000);
  const ContentRef stated{hash_bytes(handed.contents[0]), handed.contents[0].size()};
  handed.batch.places[0].content = stated;
  site.hand_in(r1, handed);
  ask({{stated.hash, 0}});
  Bytes got;
  for (const msg::Chunk& chunk : site.heard<msg::Chunk>()) {
    EXPECT_EQ(chunk.coding, msg::Coding::cloud);
    EXPECT_LT(chunk.total, stated.size * 6 / 10);
    got.insert(got.end(), chunk.data.begin(), chunk.data.end());
  }
  EXPECT_EQ(storage::ContentCoder().decode(msg::Coding::cloud, got, stated.size).value(), handed.contents[0]);
}

TEST_F(Contents, AnOffsetBeyondWhatIsStoredBeginsAnew) {
  const Handed handed = run.next(1, msg::kChunkBytes, 2);
  const ContentRef stated = handed.batch.places[0].content;
  site.hand_in(r1, handed);
  ask({{stated.hash, stated.size - 1}});
  ASSERT_THAT(site.heard<msg::Chunk>(), SizeIs(1));
  EXPECT_EQ(site.last<msg::Chunk>()->offset, 0U);
  EXPECT_EQ(site.last<msg::Chunk>()->data.size(), site.last<msg::Chunk>()->total);
}

TEST_F(Contents, SmallGoesBeforeBig) {
  const Handed big = run.next(1, 5 * msg::kChunkBytes);
  const Handed small = run.next(1, 50);
  site.hand_in(r1, big);
  site.hand_in(r1, small);
  ask({{big.batch.places[0].content.hash, 0}, {small.batch.places[0].content.hash, 0}});
  ASSERT_FALSE(site.heard<msg::Chunk>().empty());
  EXPECT_EQ(site.heard<msg::Chunk>().front().hash, small.batch.places[0].content.hash);
}

TEST_F(Contents, KeepsToItsBudget) {
  const std::size_t size = 16U << 20U;
  const Handed handed = run.next(1, size);
  site.hand_in(r1, handed);
  ask({{handed.batch.places[0].content.hash, 0}});
  site.pass(1s);
  const std::size_t after_a_second = site.heard<msg::Chunk>().size() * msg::kChunkBytes;
  EXPECT_GT(after_a_second, 3U << 20U);
  EXPECT_LT(after_a_second, 6U << 20U);
  site.pass(4s);
  EXPECT_EQ(site.heard<msg::Chunk>().size() * msg::kChunkBytes, size);
}

TEST_F(Contents, UnknownContentIsCounted) {
  ContentHash hash;
  hash.bytes[0] = 3;
  ask({{hash, 0}});
  EXPECT_THAT(site.heard<msg::Chunk>(), IsEmpty());
  EXPECT_EQ(site.counted("library: content that nobody handed in"), 1U);
}

}  // namespace
}  // namespace weft::server::test
