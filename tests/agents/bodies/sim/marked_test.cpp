#include "agents/bodies/sim/floor/marked.hpp"

#include <gtest/gtest.h>

#include "agents/bodies/sim/floor/site_floor.hpp"
#include "sites.hpp"
#include "tiles.hpp"

namespace weft::agents::sim {
namespace {

/// Returns the grey value at (x, y), in metres, of the tile that begins at the site's origin.
int grey_at(const Tile& tile, double x, double y) {
  return tile[static_cast<std::size_t>(y / kTexelM) * kTileTexels + static_cast<std::size_t>(x / kTexelM)];
}

std::shared_ptr<const FloorSource> changed_floor(const Change& change) {
  Site site = empty_site();
  site.change = change;
  auto floor = make_site_floor(site, {}, {});
  EXPECT_TRUE(floor) << floor.error().message;
  return *floor;
}

int changed_texels(const Tile& a, const Tile& b) {
  int changed = 0;
  for (std::size_t i = 0; i < a.size(); ++i) changed += a[i] != b[i];
  return changed;
}

TEST(MarkedFloor, ALineCoversWhatLiesUnderIt) {
  Change change;
  change.lines.push_back({.x0 = 0.1, .y0 = 0.3, .x1 = 5.0, .y1 = 0.3, .width_m = 0.1, .grey = 220.0});
  const Tile bare = tile_of(*changed_floor({}), {0, 0});
  const Tile painted = tile_of(*changed_floor(change), {0, 0});
  EXPECT_NEAR(grey_at(painted, 0.4, 0.33), 220, 25);
  EXPECT_EQ(grey_at(painted, 0.4, 0.36), grey_at(bare, 0.4, 0.36));
  EXPECT_EQ(grey_at(painted, 0.02, 0.3), grey_at(bare, 0.02, 0.3));
  // 0.1 m wide and 0.54 m long, of 0.64 m squared.
  EXPECT_NEAR(changed_texels(bare, painted) * kTexelM * kTexelM, 0.1 * 0.56, 0.004);
  EXPECT_EQ(changed_texels(tile_of(*changed_floor({}), {0, 1}), tile_of(*changed_floor(change), {0, 1})), 0);
}

TEST(MarkedFloor, YellowPaintShinesUnderWarmLight) {
  Change change;
  change.lines.push_back({.x0 = 0.0, .y0 = 0.3, .x1 = 5.0, .y1 = 0.3, .width_m = 0.1, .grey = 150.0, .warmth = 0.5});
  const Tile white = tile_of(*changed_floor(change), {0, 0});
  change.light_warmth = 0.6;
  const Tile warm = tile_of(*changed_floor(change), {0, 0});
  EXPECT_GT(grey_at(warm, 0.4, 0.3), grey_at(white, 0.4, 0.3) + 20);
}

TEST(MarkedFloor, DirtComesAndGoesWithItsSeed) {
  Change change;
  change.dirt_per_m2 = 400.0;
  const Tile clean = tile_of(*changed_floor({}), {2, 1});
  const Tile dirty = tile_of(*changed_floor(change), {2, 1});
  EXPECT_EQ(dirty, tile_of(*changed_floor(change), {2, 1}));
  change.seed = 2;
  const Tile other = tile_of(*changed_floor(change), {2, 1});
  const int first = changed_texels(clean, dirty);
  const int second = changed_texels(clean, other);
  EXPECT_GT(first, 5000);
  EXPECT_LT(first, 80000);
  // What one seed has put somewhere the other has not: nearly all that differs from the clean floor differs between
  // them.
  EXPECT_GT(changed_texels(dirty, other), 0.8 * (first + second));
}

}  // namespace
}  // namespace weft::agents::sim
