// Checks when robots see nothing, and what their cameras give meanwhile.
#include "agents/bodies/sim/blackout.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

#include "tests/agents/bodies/sim/sites.hpp"

namespace weft::agents::sim {
namespace {

using testing::HasSubstr;

/// Returns a hall in which r1 looks ahead with a small pair, ten times a second.
Site site_with_a_pair() {
  Site site = empty_site();
  site.robots.front().looks.clear();
  site.robots.front().has_stereo = true;
  site.stereo_camera.width = site.stereo_camera.height = 64;
  site.stereo_camera.focal_px = 50.0;
  site.disturbances.dropped_frames = 0.0;
  return site;
}

/// Returns the first pairs of a robot that drives ahead at that speed; one each tenth of a second, from 0.1 s on.
std::vector<StereoPair> pairs_of(const Site& site, std::size_t count, double speed_m_s = 0.3) {
  auto body = make_sim_body(config_of(site));
  EXPECT_TRUE(body);
  std::vector<StereoPair> pairs;
  while (body && pairs.size() < count) {
    const Result<Sample> sample = (*body)->step({speed_m_s, 0.0});
    EXPECT_TRUE(sample);
    pairs.push_back(std::get<StereoPair>(sample->views.front().data));
  }
  return pairs;
}

struct Greys {
  double mean = 0.0, sigma = 0.0;
};
Greys greys_in(const Image& image) {
  const Bytes& pixels = *image.pixels;
  const auto count = static_cast<double>(pixels.size());
  Greys greys;
  greys.mean = std::accumulate(pixels.begin(), pixels.end(), 0.0) / count;
  for (const std::uint8_t pixel : pixels) greys.sigma += (pixel - greys.mean) * (pixel - greys.mean) / count;
  greys.sigma = std::sqrt(greys.sigma);
  return greys;
}

/// Returns the site with a blackout from its 6th pair to its 10th.
Site blacked_out(Site site, Blackout::Kind kind) {
  site.blackouts.push_back({kind, 0.55, 1.05});
  return site;
}

TEST(Blackout, HoldsInItsTimeAndAtItsPlace) {
  Blackout blackout;
  blackout.from_s = 2.0;
  blackout.to_s = 3.0;
  EXPECT_FALSE(blackout.holds(1.9, 0.0, 0.0));
  EXPECT_TRUE(blackout.holds(2.0, 0.0, 0.0));
  EXPECT_FALSE(blackout.holds(3.0, 0.0, 0.0));
  blackout.near = {5.0, 5.0, 1.0};
  EXPECT_FALSE(blackout.holds(2.5, 0.0, 0.0));
  EXPECT_TRUE(blackout.holds(2.5, 5.6, 5.6));
  EXPECT_FALSE(blackout.holds(1.0, 5.0, 5.0));
}

TEST(Blackout, LeavesAloneWhatIsSeenAtOtherTimes) {
  const std::vector<StereoPair> open = pairs_of(site_with_a_pair(), 8);
  Site site = site_with_a_pair();
  site.blackouts.push_back({Blackout::Kind::dark, 100.0, 200.0});
  const std::vector<StereoPair> later = pairs_of(site, 8);
  for (std::size_t i = 0; i < open.size(); ++i) EXPECT_EQ(*open[i].left.pixels, *later[i].left.pixels) << i;
}

TEST(Blackout, InTheDarkHardlyAnythingIsSeenAndTheCameraAmplifies) {
  const std::vector<StereoPair> pairs = pairs_of(blacked_out(site_with_a_pair(), Blackout::Kind::dark), 12);
  EXPECT_GT(greys_in(pairs[4].left).mean, 60.0);
  for (std::size_t i = 5; i < 10; ++i) {
    EXPECT_LT(greys_in(pairs[i].left).mean, 10.0) << i;
    EXPECT_LT(greys_in(pairs[i].right).mean, 10.0) << i;
  }
  EXPECT_GT(greys_in(pairs[10].left).mean, greys_in(pairs[4].left).mean)
      << "light falls on a lens that waited for it";
}

TEST(Blackout, ACoverHidesAllAndIsNotDark) {
  const std::vector<StereoPair> pairs = pairs_of(blacked_out(site_with_a_pair(), Blackout::Kind::covered), 12);
  for (std::size_t i = 5; i < 10; ++i) {
    for (const Image& image : {pairs[i].left, pairs[i].right}) {
      EXPECT_NEAR(greys_in(image).mean, 30.0, 1.0) << i;
      EXPECT_LT(greys_in(image).sigma, 3.0) << "noise alone";
    }
  }
  EXPECT_GT(greys_in(pairs[10].left).sigma, 6.0);
  EXPECT_NE(*pairs[5].left.pixels, *pairs[5].right.pixels) << "each has a noise of its own";
}

TEST(Blackout, ACoverOfTheLeftLensLeavesTheRightOne) {
  const std::vector<StereoPair> open = pairs_of(site_with_a_pair(), 10);
  const std::vector<StereoPair> pairs = pairs_of(blacked_out(site_with_a_pair(), Blackout::Kind::left_covered), 10);
  EXPECT_EQ(*pairs[4].left.pixels, *open[4].left.pixels);
  EXPECT_LT(greys_in(pairs[7].left).sigma, 3.0);
  EXPECT_EQ(*pairs[7].right.pixels, *open[7].right.pixels);
}

TEST(Blackout, AFrozenCameraGivesTheImageBefore) {
  const std::vector<StereoPair> pairs = pairs_of(blacked_out(site_with_a_pair(), Blackout::Kind::frozen), 12);
  EXPECT_NE(*pairs[3].left.pixels, *pairs[4].left.pixels);
  for (std::size_t i = 5; i < 10; ++i) {
    EXPECT_EQ(*pairs[i].left.pixels, *pairs[4].left.pixels) << i;
    EXPECT_EQ(*pairs[i].right.pixels, *pairs[4].right.pixels) << i;
  }
  EXPECT_NE(*pairs[10].left.pixels, *pairs[4].left.pixels);
}

TEST(Blackout, MayBeAPlace) {
  Site site = site_with_a_pair();
  site.blackouts.push_back({});
  site.blackouts.front().kind = Blackout::Kind::covered;
  site.blackouts.front().near = {5.0, 6.0, 0.5};  // r1 begins 1 m before it
  const std::vector<StereoPair> pairs = pairs_of(site, 30, 0.5);
  EXPECT_GT(greys_in(pairs.front().left).sigma, 6.0);
  EXPECT_LT(greys_in(pairs.back().left).sigma, 3.0);
}

TEST(BlackoutKeys, SayWhenWhereAndHow) {
  const std::string start =
      "[floor]\nx_min = 0\ny_min = 0\nx_max = 9\ny_max = 9\n[[robot]]\nname = \"r1\"\nx = 4\ny = 4\n";
  const auto refused = [&start](const std::string& more) {
    const auto site = parse_site(start + more, "s.toml");
    return site ? std::string("nothing is wrong") : site.error().message;
  };
  const auto site = parse_site(start + R"(looks = ["stereo"]
[[blackout]]
kind = "frozen"
from_s = 3
to_s = 4.5
[[blackout]]
kind = "left-covered"
near = [1, 2, 0.5]
)",
                               "s.toml");
  ASSERT_TRUE(site) << site.error().message;
  ASSERT_EQ(site->blackouts.size(), 2U);
  EXPECT_EQ(site->blackouts[0].kind, Blackout::Kind::frozen);
  EXPECT_EQ(site->blackouts[0].from_s, 3.0);
  EXPECT_EQ(site->blackouts[0].to_s, 4.5);
  EXPECT_FALSE(site->blackouts[0].near);
  EXPECT_EQ(site->blackouts[1].kind, Blackout::Kind::left_covered);
  ASSERT_TRUE(site->blackouts[1].near);
  EXPECT_EQ(site->blackouts[1].near->radius_m, 0.5);
  EXPECT_THAT(refused("[[blackout]]\nkind = \"dark\"\n"), HasSubstr("would never end"));
  EXPECT_THAT(refused("[[blackout]]\nkind = \"night\"\nto_s = 1\n"), HasSubstr("left-covered"));
  EXPECT_THAT(refused("[[blackout]]\nto_s = 1\n"), HasSubstr("kind"));
  EXPECT_THAT(refused("[[blackout]]\nkind = \"dark\"\nfrom_s = 3\nto_s = 3\n"), HasSubstr("greater than from_s"));
  EXPECT_THAT(refused("[[blackout]]\nkind = \"dark\"\nnear = [1, 2, 0]\n"), HasSubstr("radius"));
  EXPECT_THAT(refused("[[blackout]]\nkind = \"dark\"\nnear = [1, 2]\n"), HasSubstr("near"));
  EXPECT_THAT(refused("[[blackout]]\nkind = \"left-covered\"\nto_s = 1\n"),
              HasSubstr("no [[robot]] looks \"stereo\""));
}

}  // namespace
}  // namespace weft::agents::sim
