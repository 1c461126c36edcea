#include "agents/navigation/rivals.hpp"

#include <gtest/gtest.h>

#include <map>

#include "tests/support/marks.hpp"

namespace weft::agents {
namespace {

/// Takes a place to be the more like any view the more it shows.
class Doubting : public MarksMethod {
 public:
  double likeness(const Content& place, const Content&) const { return static_cast<double>(place.sightings.size()); }
  double most_of_rival(double likeness) const { return 0.7 * likeness; }
};
static_assert(ComparesRivals<Doubting> && !ComparesRivals<MarksMethod>);

class RivalsTest : public testing::Test, public Contents {
 protected:
  std::shared_ptr<const Bytes> find(const ContentHash& hash) const override {
    const auto found = arrived_.find(hash);
    return found == arrived_.end() ? nullptr : found->second;
  }

  static PlaceId id(std::uint64_t run, std::uint32_t index) { return {ExperienceId{run}, index}; }

  /// Teaches a run of places 0.2 m apart, with so many marks each.
  void teach(std::uint64_t run, const std::vector<std::size_t>& marks, bool arrives = true) {
    for (std::uint32_t i = 0; i < marks.size(); ++i) {
      Doubting::Content content;
      content.sightings.resize(marks[i]);
      for (std::size_t mark = 0; mark < marks[i]; ++mark)
        content.sightings[mark].mark = static_cast<std::uint32_t>(100 * run + mark + 1);
      Place place;
      place.id = id(run, i);
      place.method = Doubting::name;
      place.content_format = Doubting::content_format;
      place.content.hash.bytes[0] = static_cast<std::uint8_t>(run);
      place.content.hash.bytes[1] = static_cast<std::uint8_t>(i);
      (arrives ? arrived_ : coming_)[place.content.hash] = std::make_shared<const Bytes>(method_.encode(content));
      window_.places.emplace(place.id, place);
      if (i == 0) continue;
      Edge edge;
      edge.id = {id(run, i - 1), place.id};
      edge.a_from_b = AlongPath{0.2, 1e-6};
      window_.edges.emplace(edge.id, edge);
    }
    index_edges(window_);
  }
  void begin(const PlaceId& at, const std::set<ExperienceId>& left_out = {}) {
    rivals_.begin({}, window_, at, {}, left_out);
  }
  OrRefusal<void> look(std::uint32_t tries) { return rivals_.look(window_, *this, decoded_, tries); }

  Doubting method_;
  Window window_;
  std::map<ContentHash, std::shared_ptr<const Bytes>> arrived_, coming_;
  DecodedContents<Doubting> decoded_{method_, 1U << 20U};
  Rivals<Doubting> rivals_{method_};
};

TEST_F(RivalsTest, APlaceElsewhereThatIsNearlyAsMuchLikeItIsOne) {
  teach(1, {5, 10, 5});
  teach(2, {3, 8});
  begin(id(1, 1));
  const OrRefusal<void> only = look(100);
  ASSERT_FALSE(only);
  EXPECT_EQ(only.error().reason, "looks_like_another");
  EXPECT_EQ(only.error().measured, 8.0);
  EXPECT_EQ(only.error().bound, 7.0);
  EXPECT_FALSE(rivals_.is_open());
}

TEST_F(RivalsTest, WhatIsLessLikeItIsNone) {
  teach(1, {5, 10, 5});
  teach(2, {3, 7});
  begin(id(1, 1));
  EXPECT_TRUE(look(100));
  EXPECT_FALSE(rivals_.is_open());
}

TEST_F(RivalsTest, NeighboursMayLookLikeItAndCountForIt) {
  teach(1, {6, 9, 10});
  teach(2, {7});
  begin(id(1, 0));
  EXPECT_TRUE(look(100)) << "the neighbour shows 10";
}

TEST_F(RivalsTest, AlongTheSameWayNoPlaceIsMoreLikeIt) {
  teach(1, {10, 1, 1, 1, 1, 1, 1, 1, 9});  // the last one 1.6 m on
  begin(id(1, 0));
  EXPECT_TRUE(look(100)) << "things are far off";
  teach(2, {10, 1, 1, 1, 1, 1, 1, 1, 11});
  begin(id(2, 0));
  EXPECT_EQ(look(100).error().bound, 10.0);
}

TEST_F(RivalsTest, FarAlongTheSameRunIsElsewhere) {
  teach(1, {10, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 8});  // 5.2 m on
  begin(id(1, 0));
  EXPECT_FALSE(look(100));
}

TEST_F(RivalsTest, ARunThatIsLeftOutIsNone) {
  teach(1, {10});
  teach(2, {10});
  begin(id(1, 0), {ExperienceId{2}});
  EXPECT_TRUE(look(100));
}

TEST_F(RivalsTest, OnlySoManyAreLookedAtAtATime) {
  teach(1, {10, 10});
  teach(2, {1, 1, 1});
  begin(id(1, 0));
  for (const double left : {3.0, 1.0}) {
    const OrRefusal<void> some = look(2);
    ASSERT_FALSE(some);
    EXPECT_EQ(some.error().reason, "weighing");
    EXPECT_EQ(some.error().measured, left);
    EXPECT_TRUE(rivals_.is_open());
  }
  EXPECT_TRUE(look(2));
}

TEST_F(RivalsTest, ContentsThatHaveNotArrivedAreWaitedFor) {
  teach(1, {10});
  teach(2, {9}, false);
  begin(id(1, 0));
  EXPECT_EQ(look(100).error().reason, "weighing");
  arrived_.insert(coming_.begin(), coming_.end());
  EXPECT_EQ(look(100).error().reason, "looks_like_another");
}

TEST_F(RivalsTest, ContentsThatNeverArriveAreNotWaitedForForEver) {
  teach(1, {10});
  teach(2, {9}, false);
  begin(id(1, 0));
  int samples = 0;
  while (!look(100) && samples < 200) ++samples;
  EXPECT_LT(samples, 100);
}

}  // namespace
}  // namespace weft::agents
