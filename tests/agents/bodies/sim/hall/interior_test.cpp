#include "agents/bodies/sim/hall/interior.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include <algorithm>

#include "agents/bodies/sim/hall/quad_scene.hpp"
#include "agents/bodies/sim/hall/stock.hpp"
#include "tests/agents/bodies/sim/sites.hpp"

namespace weft::agents::sim {
namespace {

Box rack() {
  return {Box::Kind::rack, "a rack", {10.0, 6.0, 0.5}, 10.8, 1.0, 4.5};
}

std::vector<Quad> stocked(const Site& site) {
  std::vector<Quad> quads;
  add_rack(rack(), site, quads);
  return quads;
}

std::vector<Quad> loads_of(std::vector<Quad> quads) {
  std::erase_if(quads, [](const Quad& quad) { return quad.stuff != Stuff::load; });
  return quads;
}

bool is_in(const Quad& quad, const std::vector<Quad>& quads) {
  return std::any_of(quads.begin(), quads.end(), [&](const Quad& other) {
    return other.corner == quad.corner && other.across == quad.across && other.grey == quad.grey;
  });
}

TEST(Stock, ARackHoldsWhatItHeld) {
  const std::vector<Quad> first = loads_of(stocked(empty_site()));
  const std::vector<Quad> again = loads_of(stocked(empty_site()));
  ASSERT_EQ(first.size(), again.size());
  EXPECT_GT(first.size(), 100U);
  for (const Quad& quad : first) EXPECT_TRUE(is_in(quad, again));
}

TEST(Stock, AsMuchChangesAsIsSaid) {
  Site changed = empty_site();
  changed.change.stock = 0.3;
  const std::vector<Quad> before = loads_of(stocked(empty_site()));
  const std::vector<Quad> after = loads_of(stocked(changed));
  const auto stayed =
      std::count_if(before.begin(), before.end(), [&](const Quad& quad) { return is_in(quad, after); });
  const double share = static_cast<double>(stayed) / static_cast<double>(before.size());
  EXPECT_NEAR(share, 0.7, 0.12);
}

TEST(Stock, ChangesAgainAndAgain) {
  Site changed = empty_site();
  changed.change.stock = 0.3;
  std::vector<Quad> before = loads_of(stocked(empty_site()));
  const auto first = before;
  for (int time = 1; time <= 4; ++time) {
    changed.change.stock_times = time;
    const std::vector<Quad> after = loads_of(stocked(changed));
    const auto share = [&](const std::vector<Quad>& of) {
      const auto stayed = std::count_if(of.begin(), of.end(), [&](const Quad& quad) { return is_in(quad, after); });
      return static_cast<double>(stayed) / static_cast<double>(of.size());
    };
    EXPECT_NEAR(share(before), 0.7, 0.15) << time;
    EXPECT_NEAR(share(first), std::pow(0.7, time), 0.15) << time;
    before = after;
  }
}

TEST(Stock, ARackThatIsTooNarrowHoldsNothing) {
  Box narrow = rack();
  narrow.width_m = 0.12;
  std::vector<Quad> quads;
  add_rack(narrow, empty_site(), quads);
  EXPECT_TRUE(loads_of(quads).empty());
  EXPECT_FALSE(quads.empty()) << "its uprights stand there";
}

TEST(Stock, StandsWithinItsRack) {
  for (const Quad& quad : stocked(empty_site())) {
    for (const auto& [u, v] : {std::pair{0.0F, 0.0F}, {1.0F, 0.0F}, {0.0F, 1.0F}, {1.0F, 1.0F}}) {
      const Eigen::Vector3d p = quad.at(u, v).cast<double>();
      const Eigen::Vector2d in_rack = rack().site_from_box.inverse() * Eigen::Vector2d(p.x(), p.y());
      EXPECT_LT(std::abs(in_rack.x()), 5.4 + 0.05);
      EXPECT_LT(std::abs(in_rack.y()), 0.5 + 0.01);
      EXPECT_GE(p.z(), -0.15);
      EXPECT_LE(p.z(), 4.5 + 0.01);
    }
  }
}

TEST(Interior, ARackThatIsLikeAnotherShowsTheSame) {
  Site site = empty_site();
  site.boxes.push_back(rack());
  const std::size_t first = interior_of(site).size();
  Box other = rack();
  other.name = "another rack";
  other.like = rack().name;
  other.site_from_box = {12.0, 2.0, -1.0};
  site.boxes.push_back(other);
  const std::vector<Quad> quads = interior_of(site);
  site.boxes.clear();
  const std::size_t without = interior_of(site).size();
  ASSERT_EQ(quads.size() - first, first - without);
  for (std::size_t i = 0; i < first - without; ++i) {
    const Quad& here = quads[without + i];
    const Quad& there = quads[first + i];
    EXPECT_EQ(there.pattern, here.pattern);
    EXPECT_EQ(there.grey, here.grey);
    EXPECT_NEAR(there.across.norm(), here.across.norm(), 1e-5F);
    const auto in_rack = [](const Quad& quad, const Box& box) {
      const Eigen::Vector3d p = quad.at(0.5F, 0.5F).cast<double>();
      const Eigen::Vector2d on_floor = box.site_from_box.inverse() * Eigen::Vector2d(p.x(), p.y());
      return Eigen::Vector3d(on_floor.x(), on_floor.y(), p.z());
    };
    EXPECT_NEAR((in_rack(there, other) - in_rack(here, rack())).norm(), 0.0, 1e-4);
  }
}

/// Returns what is seen of one wall in an empty hall: panels and signs.
std::vector<Quad> seen_of_wall(double contrast, bool has_signs) {
  Site site = empty_site();
  const std::size_t without = interior_of(site).size();
  Box wall{Box::Kind::wall, "wall", {10.0, 6.0, 0.0}, 12.0, 0.2, 4.0};
  wall.contrast = contrast;
  wall.has_signs = has_signs;
  site.boxes.push_back(wall);
  std::vector<Quad> quads = interior_of(site);
  quads.erase(quads.begin(), quads.begin() + static_cast<std::ptrdiff_t>(without));
  return quads;
}

TEST(Interior, APlainWallHasNoSignsAndOthersHaveThemInFullContrast) {
  for (const Quad& quad : seen_of_wall(0.02, false)) {
    EXPECT_EQ(quad.stuff, Stuff::wall);
    EXPECT_FLOAT_EQ(quad.contrast, 0.02F);
  }
  int signs = 0;
  for (const Quad& quad : seen_of_wall(0.2, true)) {
    signs += quad.stuff == Stuff::sign ? 1 : 0;
    EXPECT_FLOAT_EQ(quad.contrast, quad.stuff == Stuff::sign ? 1.0F : 0.2F);
  }
  EXPECT_GT(signs, 3);
}

TEST(Interior, WhoStandsInTheHallSeesNoWayOut) {
  Site site = empty_site();
  site.boxes.push_back(rack());
  const std::vector<Quad> quads = interior_of(site);
  const QuadScene scene(quads);
  RayPacket rays;
  for (int step = 0; step < 100; ++step) {
    for (std::size_t i = 0; i < kRays; ++i) {
      const double around = 0.3927 * static_cast<double>(i);
      const double up = -1.4 + 0.028 * step;
      rays.x[i] = static_cast<float>(std::cos(around) * std::cos(up));
      rays.y[i] = static_cast<float>(std::sin(around) * std::cos(up));
      rays.z[i] = static_cast<float>(std::sin(up));
    }
    scene.cast({4.0F, 2.0F, 0.4F}, rays);
    for (const std::int32_t quad : rays.quad) EXPECT_GE(quad, 0);
  }
}

}  // namespace
}  // namespace weft::agents::sim
