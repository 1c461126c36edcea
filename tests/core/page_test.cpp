#include "core/network/page.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "core/network/change.hpp"
#include "core/network/removal.hpp"
#include "tests/support/network_maker.hpp"

/// Tests that all of a network can be read a page at a time.
namespace weft {
namespace {

using support::make_network;
using support::pick_place;

Window whole(const Snapshot& network) {
  return make_window(network, {std::nullopt, 0, 1'000'000, {}});
}

void expect_same(const Window& read, const Window& whole) {
  EXPECT_EQ(read.revision, whole.revision);
  EXPECT_EQ(digest(read), digest(whole));
  EXPECT_EQ(read.ends, whole.ends);
  EXPECT_EQ(read.first_end, whole.first_end);
}

PagedNetwork read(const Snapshot& network, const Snapshot* other, std::size_t entities,
                  std::size_t* pages = nullptr) {
  PagedNetwork paged;
  std::uint64_t total = 0;
  while (!paged.is_whole()) {
    const NetworkPage page = page_of(network, other, paged.after(), entities);
    if (paged.done() == 0) total = page.total;
    const Result<void> added = paged.add(page);
    EXPECT_TRUE(added) << added.error().message;
    if (!added) break;
    if (pages != nullptr) ++*pages;
  }
  EXPECT_EQ(paged.done(), total) << "the first page says how many places are to come";
  return paged;
}

TEST(NetworkPages, MakeTheWholeNetworkWhateverTheirSize) {
  Random random(61);
  for (int round = 0; round < 20; ++round) {
    const Snapshot network = make_network(random, 3, 3, 5, 4);
    for (const std::size_t entities : {1U, 7U, 50U, 100'000U}) {
      std::size_t pages = 0;
      PagedNetwork paged = read(network, nullptr, entities, &pages);
      expect_same(paged.take(), whole(network));
      EXPECT_EQ(pages > 1, entities < 100'000);
      EXPECT_LE(pages, network.place_count() + 1);
    }
  }
}

TEST(NetworkPages, OfAnEmptyNetworkAreOne) {
  PagedNetwork paged;
  ASSERT_TRUE(paged.add(page_of(Snapshot{}, nullptr, {}, 10)));
  EXPECT_TRUE(paged.is_whole());
  EXPECT_TRUE(paged.take().places.empty());
}

TEST(NetworkPages, ApartFromAnotherRevisionHoldTheSameRunsFromEitherSide) {
  Random random(62);
  std::size_t untouched = 0;
  for (int round = 0; round < 20; ++round) {
    const Snapshot before = make_network(random, 4, 2, 5, 2);
    const PlaceId gone = pick_place(random, before);
    const Snapshot after = without(before, {{{gone.experience, gone.index, gone.index}}, {}});
    PagedNetwork then = read(before, &after, 6);
    PagedNetwork now = read(after, &before, 6);
    const Window old = then.take();
    const Window fresh = now.take();
    EXPECT_NE(old.place(gone), nullptr);
    EXPECT_EQ(fresh.place(gone), nullptr);
    // Whatever stands in one of them alone is on the pages of that one, and nothing else differs.
    const Patch found = difference(old, fresh, {});
    const Patch expected = difference(whole(before), whole(after), {});
    EXPECT_EQ(found.removed, expected.removed);
    EXPECT_EQ(found.edges_removed, expected.edges_removed);
    EXPECT_EQ(found.added, expected.added);
    EXPECT_EQ(found.labels_removed, expected.labels_removed);
    untouched += before.place_count() - old.places.size();
  }
  EXPECT_GT(untouched, 0U) << "no run was left out: nothing was tested";
}

TEST(NetworkPages, ApartFromTheSameAreEmptyWhereverItWasReadFrom) {
  Random random(63);
  Random again(63);
  const Snapshot network = make_network(random, 3, 3, 5, 3);
  const Snapshot read_anew = make_network(again, 3, 3, 5, 3);
  const NetworkPage page = page_of(network, &read_anew, {}, 100);
  EXPECT_TRUE(page.is_last);
  EXPECT_EQ(page.total, 0U);
  EXPECT_TRUE(page.places.empty());
}

TEST(NetworkPages, ComeInPiecesThatHoldAllOfIt) {
  Random random(64);
  const NetworkPage page = page_of(make_network(random, 3, 3, 5, 3), nullptr, {}, 100'000);
  const std::vector<NetworkPage> pieces = pieces_of(page, 4);
  std::size_t places = 0, edges = 0, labels = 0;
  for (const NetworkPage& piece : pieces) {
    EXPECT_LE(piece.places.size() + piece.edges.size() + piece.labels.size(), 4U);
    EXPECT_TRUE(piece.is_last);
    EXPECT_EQ(piece.revision, page.revision);
    places += piece.places.size();
    edges += piece.edges.size();
    labels += piece.labels.size();
  }
  EXPECT_EQ(places, page.places.size());
  EXPECT_EQ(edges, page.edges.size());
  EXPECT_EQ(labels, page.labels.size());
  EXPECT_EQ(pieces_of(NetworkPage{}, 4).size(), 1U);
}

TEST(PagedNetwork, TakesNoPageOfAnotherRevisionAndNoPlaceTwice) {
  Random random(65);
  const Snapshot network = make_network(random, 2, 3, 5, 0);
  PagedNetwork paged;
  ASSERT_TRUE(paged.add(page_of(network, nullptr, {}, 4)));
  NetworkPage other = page_of(network, nullptr, paged.after(), 4);
  other.revision.value += 1;
  EXPECT_EQ(paged.add(other).error().code, ErrorCode::stale);
  EXPECT_EQ(paged.add(page_of(network, nullptr, {}, 4)).error().code, ErrorCode::invalid);
}

TEST(PagedNetwork, TakesNoEmptyPageThatIsNotTheLast) {
  NetworkPage empty;
  empty.revision = Revision{3};
  PagedNetwork paged;
  const Result<void> added = paged.add(empty);
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().code, ErrorCode::invalid);
  EXPECT_FALSE(paged.is_whole());
  empty.is_last = true;
  EXPECT_TRUE(paged.add(empty));
  EXPECT_TRUE(paged.is_whole());
}

}  // namespace
}  // namespace weft
