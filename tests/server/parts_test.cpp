#include <gtest/gtest.h>

#include "server/fleet/incarnations.hpp"
#include "server/windows/patch_parts.hpp"

namespace weft::server {
namespace {

TEST(PatchParts, EveryEntityIsInExactlyOnePart) {
  Patch patch;
  patch.target = Revision{7};
  for (std::uint32_t i = 0; i < 5; ++i) {
    Place place;
    place.id = {{1}, i};
    patch.added.push_back(place);
    patch.removed.push_back({{2}, i});
  }
  patch.labels["dock"] = {{1}, 3};
  const std::vector<Patch> parts = parts_of(patch, 4);
  ASSERT_EQ(parts.size(), 3U);
  std::size_t added = 0;
  std::size_t removed = 0;
  std::size_t labels = 0;
  for (const Patch& part : parts) {
    EXPECT_EQ(part.target, Revision{7});
    EXPECT_LE(part.added.size() + part.removed.size() + part.labels.size(), 4U);
    added += part.added.size();
    removed += part.removed.size();
    labels += part.labels.size();
  }
  EXPECT_EQ(added, 5U);
  EXPECT_EQ(removed, 5U);
  EXPECT_EQ(labels, 1U);
}

TEST(PatchParts, EmptyPatchIsOnePart) {
  EXPECT_EQ(parts_of(Patch{}, 500).size(), 1U);
}

SteadyTime at(int seconds_since) {
  return SteadyTime(std::chrono::seconds(seconds_since));
}

TEST(Incarnations, RestartIsNotATwin) {
  Incarnations incarnations;
  EXPECT_EQ(incarnations.hear(1, at(0)), Incarnations::Verdict::first);
  EXPECT_EQ(incarnations.hear(1, at(1)), Incarnations::Verdict::current);
  EXPECT_EQ(incarnations.hear(2, at(2)), Incarnations::Verdict::fresh);
  EXPECT_EQ(incarnations.hear(1, at(3)), Incarnations::Verdict::late);
  EXPECT_EQ(incarnations.hear(2, at(10)), Incarnations::Verdict::current);
  EXPECT_FALSE(incarnations.twins());
}

TEST(Incarnations, OneThatGoesOnSpeakingIsATwin) {
  Incarnations incarnations;
  EXPECT_EQ(incarnations.hear(1, at(0)), Incarnations::Verdict::first);
  EXPECT_EQ(incarnations.hear(2, at(1)), Incarnations::Verdict::fresh);
  EXPECT_EQ(incarnations.hear(1, at(6)), Incarnations::Verdict::late);
  EXPECT_EQ(incarnations.hear(1, at(7)), Incarnations::Verdict::twin);
  EXPECT_EQ(incarnations.hear(2, at(8)), Incarnations::Verdict::twin);
  EXPECT_FALSE(incarnations.settle(at(9), std::chrono::seconds(5)));
  EXPECT_EQ(incarnations.hear(2, at(13)), Incarnations::Verdict::twin);
  EXPECT_TRUE(incarnations.settle(at(14), std::chrono::seconds(5)));
  EXPECT_EQ(incarnations.hear(2, at(15)), Incarnations::Verdict::current);
}

}  // namespace
}  // namespace weft::server
