#include "agents/bodies/sim/hall/mural.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/agents/bodies/sim/sites.hpp"

namespace weft::agents::sim {
namespace {

Site site_under(CeilingKind kind) {
  Site site = empty_site();
  site.floor.x_max = 10.0;
  site.floor.y_max = 8.0;
  site.hall.ceiling.kind = kind;
  site.hall.ceiling.stains_per_m2 = kind == CeilingKind::bare ? 0.0 : 0.2;
  return site;
}

std::size_t texel_at(const Mural& mural, double x, double y) {
  const auto column = static_cast<std::size_t>((x - mural.x0) / mural.texel_m);
  const auto row = static_cast<std::size_t>((y - mural.y0) / mural.texel_m);
  return row * static_cast<std::size_t>(mural.side) + column;
}

/// Returns the standard deviation of grey levels in a square of 0.5 m.
double contrast_at(const Mural& mural, double x, double y) {
  double sum = 0.0;
  double squares = 0.0;
  int count = 0;
  for (double v = 0.0; v < 0.5; v += mural.texel_m) {
    for (double u = 0.0; u < 0.5; u += mural.texel_m, ++count) {
      const double grey = mural.texels[texel_at(mural, x + u, y + v)];
      sum += grey;
      squares += grey * grey;
    }
  }
  return std::sqrt(squares / count - sum * sum / count / count);
}

TEST(Mural, IsAFunctionOfItsSeed) {
  for (const CeilingKind kind : {CeilingKind::concrete, CeilingKind::sheet, CeilingKind::panels}) {
    Site site = site_under(kind);
    const Mural first = draw_mural(site);
    EXPECT_EQ(first.texels, draw_mural(site).texels);
    site.floor.seed += 1;
    EXPECT_NE(first.texels, draw_mural(site).texels);
  }
}

TEST(Mural, ShowsSomethingEverywhereButWhereItIsBare) {
  for (const CeilingKind kind : {CeilingKind::concrete, CeilingKind::sheet, CeilingKind::panels}) {
    const Mural mural = draw_mural(site_under(kind));
    for (double x = 0.0; x < 9.5; x += 1.3)
      for (double y = 0.0; y < 7.5; y += 1.1) EXPECT_GT(contrast_at(mural, x, y), 3.0) << x << " " << y;
  }
  const Mural bare = draw_mural(site_under(CeilingKind::bare));
  for (double x = 0.0; x < 9.5; x += 1.3) EXPECT_LT(contrast_at(bare, x, 4.0), 1.0);
}

TEST(Mural, NoPartIsAnother) {
  const Mural mural = draw_mural(site_under(CeilingKind::concrete));
  int same = 0;
  int all = 0;
  for (double u = 0.0; u < 2.0; u += 0.05) {
    for (double v = 0.0; v < 2.0; v += 0.05, ++all) {
      const int here = mural.texels[texel_at(mural, 1.0 + u, 1.0 + v)];
      const int there = mural.texels[texel_at(mural, 1.0 + u + 2.5, 1.0 + v + 2.5)];
      same += std::abs(here - there) < 3 ? 1 : 0;
    }
  }
  EXPECT_LT(same, all / 2);
}

TEST(Mural, OfALargeHallHasLargerTexels) {
  Site site = site_under(CeilingKind::bare);
  EXPECT_EQ(draw_mural(site).texel_m, 0.005);
  EXPECT_EQ(draw_mural(site).side, 4096);
  site.floor.x_max = 60.0;
  const Mural mural = draw_mural(site);
  EXPECT_NEAR(mural.texel_m, 62.0 / 4095.0, 1e-9);
  EXPECT_EQ(mural.side, 4096);
}

}  // namespace
}  // namespace weft::agents::sim
