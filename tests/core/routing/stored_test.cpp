#include "tests/core/routing/laws.hpp"
#include "tests/support/site_network.hpp"

namespace weft::routing {
namespace {

TEST(StoredRoutes, ComeBackAsTheyWere) {
  const Snapshot snapshot = support::make_site({.places = 10'000, .seed = 8});
  const Preparation preparation = prepare(snapshot, {"floor"});
  const Bytes bytes = encode(preparation);
  const Result<Preparation> again = decode(bytes, snapshot);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(encode(*again), bytes);
  for (std::size_t level = 0; level < kLevels; ++level) {
    for (std::size_t cell = 0; cell < preparation.overlays[level].size(); ++cell) {
      EXPECT_EQ(*again->overlays[level][cell], *preparation.overlays[level][cell]);
    }
  }
}

TEST(StoredRoutes, FollowANetworkThatMovedOnOrBack) {
  SiteGenerator generator({.places = 8'000, .seed = 9});
  std::vector<Snapshot> revisions{Snapshot{}};
  while (!generator.is_done()) revisions.push_back(with(revisions.back(), generator.next()));
  Random random(2);
  const Bytes bytes = encode(prepare(revisions[revisions.size() / 2], {"floor"}));
  for (const std::size_t at :
       {std::size_t{1}, revisions.size() / 3, revisions.size() / 2 + 1, revisions.size() - 1}) {
    const Result<Preparation> moved = decode(bytes, revisions[at]);
    ASSERT_TRUE(moved) << moved.error().message;
    expect_as_dijkstra(random, *moved, revisions[at], 25);
    const Preparation next = update(*moved, revisions.back());
    expect_as_dijkstra(random, next, revisions.back(), 15);
  }
}

TEST(StoredRoutes, AreRefusedWhenShortOrLong) {
  Random random(4);
  const Snapshot snapshot = support::make_network(random, 4, 6, 20, 5);
  Bytes bytes = encode(prepare(snapshot, {"marks"}));
  for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 200) {
    const Result<Preparation> cut = decode(ByteView(bytes).first(size), snapshot);
    ASSERT_FALSE(cut) << size;
    EXPECT_EQ(cut.error().code, ErrorCode::corrupt);
  }
  bytes.push_back(0);
  EXPECT_EQ(decode(bytes, snapshot).error().code, ErrorCode::corrupt);
}

/// Shows that whatever is read is safe to search, although it is the store's checksum that finds a wrong number.
TEST(StoredRoutes, DoNoHarmWhenDamaged) {
  Random random(14);
  const Snapshot snapshot = support::make_network(random, 4, 6, 30, 5);
  const Bytes bytes = encode(prepare(snapshot, {"marks"}));
  std::size_t refused = 0;
  for (int turn = 0; turn < 400; ++turn) {
    Bytes damaged = bytes;
    const std::size_t reach = turn % 2 == 0 ? damaged.size() : 400;
    damaged[random.below(std::min(reach, damaged.size()))] ^= static_cast<std::uint8_t>(1U + random.below(255));
    const Result<Preparation> read = decode(damaged, snapshot);
    if (!read) {
      EXPECT_EQ(read.error().code, ErrorCode::corrupt);
      ++refused;
      continue;
    }
    const PlaceId from = support::pick_place(random, snapshot);
    const PlaceId to = support::pick_place(random, snapshot);
    const Result<Path> path = shortest_path(*read, snapshot, from, to, read->methods);
    if (path) expect_drivable(snapshot, *path, read->methods);
  }
  EXPECT_GT(refused, 20U);
}

}  // namespace
}  // namespace weft::routing
