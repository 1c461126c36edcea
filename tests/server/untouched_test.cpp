#include "server/windows/untouched.hpp"

#include <gtest/gtest.h>

#include "core/network/removal.hpp"
#include "tests/support/network_maker.hpp"
#include "tests/support/site_network.hpp"

namespace weft::server {
namespace {

/// Shows that what is said to be untouched looks the same, and that it is said often enough to be of use.
TEST(Untouched, WindowsLookTheSame) {
  Random random(1);
  int untouched = 0;
  int changed = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Snapshot snapshot = support::make_site({.places = 6'000, .seed = seed});
    for (int turn = 0; turn < 80; ++turn) {
      WindowDefinition definition;
      definition.centre = support::pick_place(random, snapshot);
      definition.hops = 1 + static_cast<std::uint32_t>(random.below(10));
      definition.cap = 1 + static_cast<std::uint32_t>(random.below(300));
      if (random.chance(0.3)) definition.route.push_back(support::pick_place(random, snapshot));
      const Window window = make_window(snapshot, definition);
      const support::BatchPlan plan{{random.next() | 1U}, support::random_id<RobotId>(random), 1, 5, 2, "floor"};
      const PlaceId gone = random.chance(0.5) ? *definition.centre : support::pick_place(random, snapshot);
      const Snapshot next = random.chance(0.7) ? with(snapshot, support::make_batch(random, snapshot, plan))
                                               : without(snapshot, {{{gone.experience, gone.index, gone.index}}, {}});
      const bool looks_the_same = digest(make_window(next, definition)) == digest(window);
      if (is_untouched(definition, window, snapshot, next)) {
        EXPECT_TRUE(looks_the_same);
        ++untouched;
      }
      changed += looks_the_same ? 0 : 1;
      snapshot = next;
    }
  }
  EXPECT_GT(untouched, 20);
  EXPECT_GT(changed, 10);
}

TEST(Untouched, IsNotSaidOfWhatMayComeFromAnywhere) {
  Random random(2);
  const Snapshot before = support::make_network(random, 3, 2, 4, 2);
  const PlaceId centre = support::pick_place(random, before);
  const support::BatchPlan plan{{99}, support::random_id<RobotId>(random), 1, 2, 0, "marks"};
  const Snapshot after = with(before, support::make_batch(random, before, plan));
  const auto said = [&](const WindowDefinition& definition, const Snapshot& now) {
    return is_untouched(definition, make_window(before, definition), before, now);
  };
  EXPECT_TRUE(said({.centre = centre, .hops = 1, .cap = 5, .route = {}}, after));
  EXPECT_FALSE(said({.centre = std::nullopt, .hops = 1, .cap = 50, .route = {}}, after)) << "the whole network grew";
  EXPECT_FALSE(said({.centre = PlaceId{{99}, 0}, .hops = 1, .cap = 5, .route = {}}, after)) << "the centre came";
  EXPECT_FALSE(said({.centre = centre, .hops = 1, .cap = 5, .route = {{{99}, 1}}}, after)) << "of the route came";
  EXPECT_FALSE(said({.centre = centre, .hops = 1, .cap = 5, .route = {}}, with_label(after, "here", centre)));
}

}  // namespace
}  // namespace weft::server
