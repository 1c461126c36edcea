#include "agents/bodies/sim/hall/mural.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <opencv2/core.hpp>

#include "agents/bodies/sim/hall/ceiling_canvas.hpp"
#include "agents/bodies/sim/hall/panels.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {
namespace {

/// Calls `put` at so many places a square metre.
template <class Put>
void strew(const CeilingCanvas& canvas, double per_m2, Random random, Put&& put) {
  const auto count = static_cast<int>(per_m2 * canvas.area_m2());
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(0.0, canvas.width_m());
    const double y = random.uniform(0.0, canvas.depth_m());
    put(random, x, y);
  }
}

/// Strews specks of 1 to 4 cm across, mostly dark, and scratches.
void add_dirt(CeilingCanvas& canvas, double per_m2, Random random) {
  strew(canvas, per_m2, random.fork(1), [&](Random& r, double x, double y) {
    const double grey = r.chance(0.8) ? r.uniform(60.0, 112.0) : r.uniform(145.0, 175.0);
    const double radius = 0.005 + 0.015 * r.uniform() * r.uniform();
    canvas.disc(x, y, radius, grey);
    if (r.chance(0.3)) canvas.disc(x + 0.8 * radius, y + 0.5 * radius, 0.8 * radius, grey + 6.0);
  });
  strew(canvas, 0.15 * per_m2, random.fork(2), [&](Random& r, double x, double y) {
    const double angle = r.uniform(0.0, 2.0 * CV_PI);
    const double length = r.uniform(0.03, 0.3);
    canvas.line(x, y, x + length * std::cos(angle), y + length * std::sin(angle), 0.006, r.uniform(85.0, 150.0));
  });
}

void add_stains(CeilingCanvas& canvas, double per_m2, Random random) {
  strew(canvas, per_m2, random, [&](Random& r, double x, double y) {
    const double radius = r.uniform(0.06, 0.45);
    const double grey = r.uniform(8.0, 34.0);
    canvas.stain(x, y, radius, grey, Random(r.next()));
  });
}

/// Lays cables in straight pieces along x and y, with clips, and boxes where they turn.
void add_cables(CeilingCanvas& canvas, double per_m2, Random random) {
  strew(canvas, per_m2, random, [&](Random& r, double x, double y) {
    bool is_along_x = r.chance(0.5);
    const double grey = r.chance(0.6) ? r.uniform(55.0, 85.0) : r.uniform(165.0, 190.0);
    const auto pieces = 2 + static_cast<int>(r.below(3));
    for (int i = 0; i < pieces; ++i, is_along_x = !is_along_x) {
      const double length = r.uniform(0.5, 4.0) * (r.chance(0.5) ? 1.0 : -1.0);
      const double to_x = x + (is_along_x ? length : 0.0);
      const double to_y = y + (is_along_x ? 0.0 : length);
      canvas.line(x, y, to_x, to_y, 0.014, grey);
      for (double at = r.uniform(0.2, 0.5); at < std::abs(length); at += r.uniform(0.4, 0.7))
        canvas.disc(x + (to_x - x) * at / std::abs(length), y + (to_y - y) * at / std::abs(length), 0.014, 150.0);
      x = to_x;
      y = to_y;
      if (r.chance(0.5)) canvas.rectangle(x - 0.05, y - 0.05, 0.1, 0.1, grey > 128.0 ? 150.0 : 170.0);
    }
  });
}

void draw_concrete(CeilingCanvas& canvas, double dirt, Random random) {
  constexpr double board_m = 1.25;
  canvas.fill({{0.03, 3.0}, {0.25, 6.0}, {1.5, 9.0}}, random.fork(1));
  Random boards = random.fork(2);
  for (double y = 0.0; y < canvas.depth_m(); y += 2.0 * board_m) {
    for (double x = 0.0; x < canvas.width_m(); x += board_m) {
      canvas.shade(x, y, board_m, 2.0 * board_m, boards.normal(0.0, 5.0));
      for (const auto& [u, v] : {std::pair{0.3, 0.5}, {0.95, 0.5}, {0.3, 2.0}, {0.95, 2.0}})
        canvas.disc(x + u + boards.uniform(-0.02, 0.02), y + v + boards.uniform(-0.02, 0.02), 0.014, 62.0);
    }
  }
  for (double x = board_m; x < canvas.width_m(); x += board_m)
    canvas.line(x, 0.0, x + boards.uniform(-0.005, 0.005), canvas.depth_m(), 0.01, boards.uniform(92.0, 110.0));
  for (double y = 2.0 * board_m; y < canvas.depth_m(); y += 2.0 * board_m)
    canvas.line(0.0, y, canvas.width_m(), y + boards.uniform(-0.005, 0.005), 0.012, boards.uniform(92.0, 110.0));
  strew(canvas, 20.0 * dirt, random.fork(3),
        [&](Random& r, double x, double y) { canvas.disc(x, y, r.uniform(0.003, 0.008), r.uniform(70.0, 100.0)); });
  add_cables(canvas, 0.03, random.fork(4));
  add_dirt(canvas, 8.0 * dirt, random.fork(5));
}

/// Draws sheet steel with its ribs along y: screws with washers in the valleys, sheets that overlap, rust and dirt
/// that ran down. The ribs themselves are faces of their own.
void draw_sheet(CeilingCanvas& canvas, double dirt, Random random) {
  constexpr double period_m = 0.25;
  canvas.fill({{0.04, 2.5}, {0.3, 4.0}, {1.2, 6.0}}, random.fork(1));
  Random sheets = random.fork(2);
  for (double x = 0.0; x < canvas.width_m(); x += 4.0 * period_m) {
    for (double y = sheets.uniform(-4.0, 0.0); y < canvas.depth_m(); y += 6.0) {
      canvas.shade(x, y, 4.0 * period_m, 6.0, sheets.normal(0.0, 7.0));
      canvas.line(x, y, x + 4.0 * period_m, y, 0.012, 80.0);
    }
    canvas.line(x + 0.06, 0.0, x + 0.06, canvas.depth_m(), 0.006, 95.0);
  }
  for (double x = 0.175; x < canvas.width_m(); x += period_m) {
    for (double y = sheets.uniform(0.2, 0.6); y < canvas.depth_m(); y += sheets.uniform(1.3, 1.7)) {
      const double at_x = x + sheets.uniform(-0.012, 0.012);
      canvas.disc(at_x, y, 0.016, sheets.uniform(140.0, 165.0));
      canvas.disc(at_x, y, 0.009, sheets.uniform(50.0, 80.0));
      if (sheets.chance(0.25 * dirt))
        canvas.line(at_x, y, at_x + sheets.uniform(-0.02, 0.02), y + sheets.uniform(0.08, 0.5), 0.018,
                    sheets.uniform(85.0, 108.0));
    }
  }
  add_cables(canvas, 0.02, random.fork(3));
  add_dirt(canvas, 9.0 * dirt, random.fork(4));
}

/// Draws one panel of mineral fibre or what is let into the grid in its place.
void draw_panel(CeilingCanvas& canvas, double x, double y, double side, Random& random) {
  canvas.shade(x, y, side, side, random.normal(0.0, 3.0));
  const double kind = random.uniform();
  if (kind < 0.03) {  // a grille
    canvas.rectangle(x + 0.04, y + 0.04, side - 0.08, side - 0.08, 135.0);
    for (double at = 0.07; at < side - 0.08; at += 0.04) canvas.rectangle(x + 0.06, y + at, side - 0.12, 0.018, 45.0);
  } else if (kind < 0.07) {  // a smoke detector or a loudspeaker
    const double radius = random.uniform(0.05, 0.1);
    canvas.disc(x + 0.5 * side, y + 0.5 * side, radius, 95.0);
    canvas.disc(x + 0.5 * side, y + 0.5 * side, 0.85 * radius, 150.0);
    canvas.disc(x + 0.5 * side, y + 0.5 * side, 0.3 * radius, 70.0);
  } else if (kind < 0.1) {  // a corner is broken
    const double broken = random.uniform(0.03, 0.1);
    canvas.rectangle(x + 0.015, y + 0.015, broken, 0.7 * broken, 50.0);
  }
}

void draw_panels(CeilingCanvas& canvas, double dirt, Random random) {
  constexpr double side_m = 0.6;
  constexpr double bar_m = 0.024;
  canvas.fill({{0.02, 2.0}, {0.3, 2.0}, {3.0, 4.0}}, random.fork(1));
  strew(canvas, 45.0 * dirt, random.fork(2), [&](Random& r, double x, double y) {  // fissures
    const double angle = r.uniform(0.0, 2.0 * CV_PI);
    const double length = r.uniform(0.004, 0.02);
    canvas.line(x, y, x + length * std::cos(angle), y + length * std::sin(angle), 0.005, r.uniform(85.0, 112.0));
  });
  Random panels = random.fork(3);
  for (double y = 0.0; y < canvas.depth_m(); y += side_m)
    for (double x = 0.0; x < canvas.width_m(); x += side_m) draw_panel(canvas, x, y, side_m, panels);
  for (const bool is_across : {false, true}) {
    const double far = is_across ? canvas.depth_m() : canvas.width_m();
    for (double at = 0.0; at < far; at += side_m) {
      const auto bar = [&](double beside, double width, double grey) {
        is_across ? canvas.rectangle(0.0, at + beside, canvas.width_m(), width, grey)
                  : canvas.rectangle(at + beside, 0.0, width, canvas.depth_m(), grey);
      };
      bar(-0.5 * bar_m - 0.004, bar_m + 0.008, 84.0);
      bar(-0.5 * bar_m, bar_m, 146.0);
    }
  }
  add_dirt(canvas, 4.0 * dirt, random.fork(4));
}

}  // namespace

Mural draw_mural(const Site& site) {
  constexpr double finest_m = 0.005;
  constexpr double most_texels = 4096.0;
  const double width_m = site.floor.x_max - site.floor.x_min + 2.0 * kBeyondM;
  const double depth_m = site.floor.y_max - site.floor.y_min + 2.0 * kBeyondM;
  Mural mural;
  mural.x0 = site.floor.x_min - kBeyondM;
  mural.y0 = site.floor.y_min - kBeyondM;
  mural.texel_m = std::max(finest_m, std::max(width_m, depth_m) / (most_texels - 1.0));
  CeilingCanvas canvas(width_m, depth_m, mural.texel_m);
  Random random(site.floor.seed ^ 0x6d7572616cULL);
  const CeilingSetup& ceiling = site.hall.ceiling;
  if (ceiling.kind == CeilingKind::concrete) {
    draw_concrete(canvas, ceiling.dirt, random.fork(1));
  } else if (ceiling.kind == CeilingKind::sheet) {
    draw_sheet(canvas, ceiling.dirt, random.fork(1));
  } else if (ceiling.kind == CeilingKind::panels) {
    draw_panels(canvas, ceiling.dirt, random.fork(1));
  } else {
    canvas.fill({{2.0, 1.0}}, random.fork(1));
  }
  add_stains(canvas, ceiling.stains_per_m2, random.fork(2));
  const cv::Mat picture = canvas.done();
  mural.side = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(picture.cols, picture.rows))));
  const auto side = static_cast<std::size_t>(mural.side);
  mural.texels.assign(side * side, 128);
  for (int row = 0; row < picture.rows; ++row)
    std::copy_n(picture.ptr(row), picture.cols, mural.texels.begin() + static_cast<std::ptrdiff_t>(side) * row);
  return mural;
}

}  // namespace weft::agents::sim
