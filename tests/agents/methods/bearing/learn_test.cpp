#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "agents/methods/bearing/bearing.hpp"
#include "tests/support/aisle.hpp"

namespace weft::agents {
namespace {

constexpr AlongPath kHere{0.0, 1e-4, 0.0, 1e-4};

/// Shows what a robot sees at one place of an aisle, on a day of its own and with some of the stock changed.
class BearingLearns : public testing::Test {
 protected:
  static sim::Site restocked(double stock) {
    sim::Site site = test::aisle_site();
    site.change.stock = stock;
    site.change.seed = 5;
    return site;
  }
  /// Returns the content of a view, rendered once for all tests.
  static const BearingContent& seen(double stock = 0.0, std::uint64_t day = 0, const Pose2& from = {6.0, 6.0, 0.0}) {
    static std::map<std::array<double, 5>, BearingContent> all;
    const auto [at, is_new] =
        all.try_emplace({stock, static_cast<double>(day), from.x, from.y, from.heading}, BearingContent{});
    if (!is_new) return at->second;
    test::Lookout lookout(restocked(stock), day);
    const auto content = Bearing::make({}, lookout.camera())->extract({}, lookout.from(from));
    EXPECT_TRUE(content) << content.error().reason;
    if (content) at->second = *content;
    return at->second;
  }
  std::size_t votes(const BearingContent& place, const BearingContent& view) const {
    const auto related = method_.relate(place, view, kHere);
    return related ? related->inliers : 0;
  }
  BearingContent after(BearingContent place, const BearingContent& view, int passes) const {
    for (int i = 0; i < passes; ++i) {
      auto learned = method_.learn(place, view, kHere);
      EXPECT_TRUE(learned);
      if (learned) place = std::move(*learned);
    }
    return place;
  }

  static const Bearing& method() {
    static const Bearing made = *Bearing::make({}, test::Lookout(test::aisle_site()).camera());
    return made;
  }
  const Bearing& method_ = method();
};

TEST_F(BearingLearns, CountsWhatIsThereAndWhatIsNot) {
  const BearingContent taught = seen();
  const auto learned = method_.learn(taught, seen(0.0, 1), kHere);
  ASSERT_TRUE(learned);
  ASSERT_EQ(learned->sightings.size(), learned->features.size());
  std::size_t again = 0;
  std::size_t missed = 0;
  for (std::size_t i = 0; i < taught.features.size(); ++i) {
    ASSERT_EQ(learned->features[i].pixel, taught.features[i].pixel) << "nothing goes that was missed once";
    if (learned->sightings[i] == Sightings{2, 2}) ++again;
    if (learned->sightings[i] == Sightings{2, 1}) ++missed;
  }
  EXPECT_EQ(again + missed, taught.features.size());
  EXPECT_GT(again, taught.features.size() / 3);
  EXPECT_GT(missed, 0U);
}

TEST_F(BearingLearns, NewcomersStandWhereTheyWouldHaveBeenSeen) {
  const BearingContent whole = seen();
  BearingContent half = whole;
  half.features.clear();
  for (std::size_t i = 0; i < whole.features.size(); i += 2) half.features.push_back(whole.features[i]);
  const auto learned = method_.learn(half, seen(0.0, 1, {6.05, 6.0, 0.06}), AlongPath{0.05, 1e-4, 0.06, 1e-4});
  ASSERT_TRUE(learned);
  std::vector<double> off_px;
  for (std::size_t i = 1; i < whole.features.size(); i += 2) {
    for (std::size_t k = half.features.size(); k < learned->features.size(); ++k) {
      constexpr int same_bits = 45;
      if (hamming(whole.features[i].descriptor, learned->features[k].descriptor) > same_bits) continue;
      off_px.push_back(static_cast<double>((whole.features[i].pixel - learned->features[k].pixel).norm()));
    }
  }
  ASSERT_GT(off_px.size(), 5U) << "enough for a median";
  std::sort(off_px.begin(), off_px.end());
  EXPECT_LT(off_px[off_px.size() / 2], 2.0) << "23 pixels as they are in the view";
}

TEST_F(BearingLearns, NotFromAViewThatIsNotSure) {
  const BearingContent taught = seen();
  EXPECT_TRUE(method_.learn(taught, seen(), kHere));
  EXPECT_FALSE(method_.learn(taught, seen(), AlongPath{0.2, 1e-4, 0.0, 1e-4})) << "too far before it";
  EXPECT_FALSE(method_.learn(taught, seen(), AlongPath{0.0, 0.04, 0.0, 1e-4})) << "who knows where";
  EXPECT_FALSE(method_.learn(taught, seen(), AlongPath{0.0, 1e-4, 0.2, 1e-4})) << "other places say otherwise";
  EXPECT_FALSE(method_.learn(taught, seen(0.0, 0, {6.0, 6.0, M_PI}), kHere)) << "nothing of it is there";
  EXPECT_FALSE(method_.learn(taught, seen(0.0, 0, {6.0, 6.8, 0.0}), kHere)) << "from aside";
  BearingContent other = taught;
  other.focal_px = 300.0;
  EXPECT_FALSE(method_.learn(other, seen(), kHere));
}

TEST_F(BearingLearns, HasRoomForSoManyOnly) {
  BearingContent place = seen();
  for (std::uint64_t day = 1; day <= 6; ++day) {
    const auto learned = method_.learn(place, seen(0.08 * static_cast<double>(day), day), kHere);
    if (learned) place = *learned;
    ASSERT_LE(place.features.size(), static_cast<std::size_t>(method_.config().learn.features));
    for (const Sightings& one : place.sightings) ASSERT_LE(one.could, method_.config().learn.fade_passes);
  }
  EXPECT_GT(place.features.size(), 300U);
}

TEST_F(BearingLearns, WhatChangedComesInAndWhatIsGoneGoes) {
  const BearingContent taught = seen();
  const BearingContent now = seen(0.6, 1);
  const BearingContent learned = after(taught, now, 3);
  EXPECT_GT(votes(learned, seen(0.6, 2)), votes(taught, seen(0.6, 2)) * 5 / 4);
  const BearingContent later = after(taught, now, 15);
  const auto stays = std::count_if(taught.features.begin(), taught.features.end(), [&](const UprightFeature& one) {
    return std::any_of(later.features.begin(), later.features.end(), [&](const UprightFeature& other) {
      return one.pixel == other.pixel && one.descriptor == other.descriptor;
    });
  });
  EXPECT_LT(static_cast<std::size_t>(stays), taught.features.size() * 3 / 4);
}

TEST_F(BearingLearns, WhatIsSeenEveryThirdPassStays) {
  const BearingContent taught = seen();
  const BearingContent as_before = seen(0.0, 1);
  const BearingContent changed = seen(0.6, 1);
  const std::size_t at_first = votes(taught, seen(0.0, 2));
  BearingContent place = taught;
  for (int i = 0; i < 8; ++i) place = after(after(place, changed, 2), as_before, 1);
  EXPECT_GE(votes(place, seen(0.0, 2)), at_first * 95 / 100);
  EXPECT_GT(votes(place, seen(0.6, 2)), votes(taught, seen(0.6, 2)) * 5 / 4);
}

TEST_F(BearingLearns, SoonNothingIsWorthSharingWhereNothingChanges) {
  BearingContent shared = seen();
  BearingContent place = shared;
  std::vector<int> shared_on;
  for (int day = 1; day <= 8; ++day) {
    const auto learned = method_.learn(place, seen(0.0, static_cast<std::uint64_t>(day)), kHere);
    ASSERT_TRUE(learned);
    place = *learned;
    EXPECT_FALSE(method_.is_worth_sharing(place, place));
    if (!method_.is_worth_sharing(shared, place)) continue;
    shared = place;
    shared_on.push_back(day);
  }
  EXPECT_LE(shared_on.size(), 2U);
  for (const int day : shared_on) EXPECT_LE(day, 4);
}

TEST_F(BearingLearns, AChangeIsWorthSharingAtOnce) {
  BearingContent shared = after(seen(), seen(0.0, 1), 4);
  const auto learned = method_.learn(shared, seen(0.6, 2), kHere);
  ASSERT_TRUE(learned);
  EXPECT_TRUE(method_.is_worth_sharing(shared, *learned));
}

}  // namespace
}  // namespace weft::agents
