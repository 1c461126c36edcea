// For people: draws a site with lines from above (site.png), and what a robot sees while it is led along the first
// one (frame-NNNN.png, of a pair both images); and 2.6 m of the floor from above, about where it starts (floor.png).
// Usage: sim-look SITE.toml ROBOT OUT_DIR LINE... [--floors DIR] [--every N] [--kind K] [--light L] [--wear W]
#include <cairo/cairo.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <opencv2/core.hpp>
#include <sstream>

#include "agents/bodies/sim/changes.hpp"
#include "agents/bodies/sim/floor/site_floor.hpp"
#include "agents/bodies/sim/floor/tile_cache.hpp"
#include "agents/bodies/sim/sim_body.hpp"
#include "tests/support/raw_png.hpp"

namespace {

using namespace weft;
using namespace weft::agents;

std::string text_of(const std::string& path) {
  const std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<SitePoint> line_from(const std::string& path) {
  std::vector<SitePoint> line;
  std::ifstream file(path);
  for (std::string text; std::getline(file, text);) {
    std::stringstream row(text.substr(0, text.find('#')));
    SitePoint p;
    if (row >> p.x >> p.y) {
      line.push_back(p);
    }
  }
  return line;
}

/// Fills a rectangle about a pose, its length along the heading.
void fill_rectangle(cairo_t* cr, const Pose2& middle, double length_m, double width_m) {
  cairo_save(cr);
  cairo_translate(cr, middle.x, middle.y);
  cairo_rotate(cr, middle.heading);
  cairo_rectangle(cr, -length_m / 2, -width_m / 2, length_m, width_m);
  cairo_fill(cr);
  cairo_restore(cr);
}

/// Draws where cameras see nothing, and what stands in the way for a while.
void draw_hindrances(cairo_t* cr, const sim::Site& site) {
  for (const sim::Blackout& blackout : site.blackouts) {
    if (!blackout.near) continue;
    cairo_set_source_rgb(cr, 0.8, 0.8, 0.95);
    cairo_arc(cr, blackout.near->x, blackout.near->y, blackout.near->radius_m, 0, 7);
    cairo_fill(cr);
  }
  for (const sim::Obstacle& obstacle : site.obstacles) {
    cairo_set_source_rgb(cr, 0.9, 0.6, 0.3);
    fill_rectangle(cr, obstacle.site_from_obstacle, obstacle.length_m, obstacle.width_m);
  }
}

void draw_site(const sim::Site& site, const std::vector<std::vector<SitePoint>>& lines, const std::string& path) {
  constexpr double kPerMetre = 50.0;
  const auto& floor = site.floor;
  const int width = static_cast<int>((floor.x_max - floor.x_min + 1.0) * kPerMetre);
  const int height = static_cast<int>((floor.y_max - floor.y_min + 1.0) * kPerMetre);
  cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
  cairo_t* cr = cairo_create(surface);
  cairo_set_source_rgb(cr, 1, 1, 1);
  cairo_paint(cr);
  cairo_translate(cr, (0.5 - floor.x_min) * kPerMetre, height - (0.5 - floor.y_min) * kPerMetre);
  cairo_scale(cr, kPerMetre, -kPerMetre);
  draw_hindrances(cr, site);
  for (const sim::Box& box : site.boxes) {
    const double grey = box.has_signs ? 0.6 : 0.85;  // plain walls are pale
    cairo_set_source_rgb(cr, grey, grey, grey + 0.05);
    fill_rectangle(cr, box.site_from_box, box.length_m, box.width_m);
  }
  for (const sim::Lamp& lamp : site.lamps) {
    cairo_arc(cr, lamp.x, lamp.y, 0.12, 0, 7);
    cairo_set_source_rgb(cr, 0.9, 0.8, 0.1);
    cairo_fill(cr);
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const SitePoint& p : lines[i]) {
      cairo_line_to(cr, p.x, p.y);
    }
    cairo_set_source_rgb(cr, i == 0 ? 0.8 : 0.1, 0.1, i == 0 ? 0.1 : 0.8);
    cairo_set_line_width(cr, 0.04);
    cairo_stroke(cr);
    cairo_new_path(cr);
    cairo_arc(cr, lines[i].back().x, lines[i].back().y, 0.4, 0, 7);
    cairo_stroke(cr);
  }
  const auto mark = [&](const Pose2& pose, const std::string& name, double red, double up) {
    cairo_set_source_rgb(cr, red, 0.5, 0.1);
    cairo_new_path(cr);
    cairo_arc(cr, pose.x, pose.y, 0.1, 0, 7);
    cairo_fill(cr);
    cairo_move_to(cr, pose.x, pose.y);
    cairo_line_to(cr, pose.x + 0.4 * std::cos(pose.heading), pose.y + 0.4 * std::sin(pose.heading));
    cairo_stroke(cr);
    cairo_save(cr);
    cairo_move_to(cr, pose.x + 0.15, pose.y + up);
    cairo_scale(cr, 1, -1);
    cairo_set_font_size(cr, 0.35);
    cairo_show_text(cr, name.c_str());
    cairo_restore(cr);
  };
  for (const sim::Station& station : site.stations) {
    mark(station.site_from_station, station.name, 0.0, 0.3);
  }
  for (const sim::RobotStart& robot : site.robots) {
    mark(robot.site_from_robot, robot.name, 0.9, -0.5);
  }
  cairo_surface_write_to_png(surface, path.c_str());
  cairo_destroy(cr);
  cairo_surface_destroy(surface);
}

/// Draws the floor from above, y up, without lamps; the middle is where the line begins.
void draw_floor(const sim::FloorSource& floor, const SitePoint& about, const std::string& path) {
  constexpr int kAcross = 4;
  constexpr int kShrunk = 2;
  const auto tile_at = [](double metres) { return static_cast<std::int32_t>(std::floor(metres / sim::kTileM)); };
  const sim::TileKey first{tile_at(about.x) - kAcross / 2, tile_at(about.y) - kAcross / 2};
  constexpr int kSide = sim::kTileTexels >> kShrunk;
  cv::Mat picture(kAcross * kSide, kAcross * kSide, CV_8U);
  sim::TileCache cache(std::shared_ptr<const sim::FloorSource>(&floor, [](const auto*) {}), 20'000'000);
  for (int j = 0; j < kAcross; ++j) {
    for (int i = 0; i < kAcross; ++i) {
      std::vector<std::uint8_t> texels = cache.tile({first.x + i, first.y + j}).levels[kShrunk];
      cv::Mat tile(kSide, kSide, CV_8U, texels.data());
      cv::Mat upright;
      cv::flip(tile, upright, 0);
      upright.copyTo(picture(cv::Rect(i * kSide, (kAcross - 1 - j) * kSide, kSide, kSide)));
    }
  }
  weft::test::write_png(path,
                        {images::Shades::grey, picture.cols, picture.rows, {picture.datastart, picture.dataend}});
}

/// Returns what a view shows; a pair's images side by side, the left one on the left.
cv::Mat picture_of(const View& view) {
  const auto mat = [](const Image& image) {
    return cv::Mat(image.height, image.width, CV_8U, const_cast<std::uint8_t*>(image.pixels->data())).clone();
  };
  if (const auto* const image = std::get_if<Image>(&view.data)) return mat(*image);
  const auto& pair = std::get<StereoPair>(view.data);
  cv::Mat both;
  cv::hconcat(mat(pair.left), mat(pair.right), both);
  return both;
}

struct Options {
  std::optional<std::string> floors, kind, light, wear;
  int every = 60;
};

Result<sim::Site> site_from(const std::string& path, const Options& options) {
  auto site = sim::parse_site(text_of(path), path);
  if (site && options.kind) site = sim::on_floor(*site, *options.kind);
  if (site && options.light) site = sim::under_light(*site, *options.light);
  if (site && options.wear) site = sim::with_wear(*site, *options.wear);
  return site;
}

int look(const std::vector<std::string>& words, const Options& options) {
  auto site = site_from(words[0], options);
  if (!site) {
    std::cerr << site.error().message << '\n';
    return 1;
  }
  std::vector<std::vector<SitePoint>> lines;
  for (std::size_t i = 3; i < words.size(); ++i) {
    lines.push_back(line_from(words[i]));
  }
  draw_site(*site, lines, words[2] + "/site.png");
  sim::SimBodyConfig config;
  config.site = *site;
  config.robot = words[1];
  config.floors_dir = options.floors;
  config.warn = [](const std::string& text) { std::cerr << text << '\n'; };
  auto body = sim::make_sim_body(config);
  if (!body) {
    std::cerr << body.error().message << '\n';
    return 1;
  }
  if (auto floor = sim::make_site_floor(*site, options.floors, {}); floor) {
    draw_floor(**floor, lines.front().front(), words[2] + "/floor.png");
  }
  if (auto led = (*body)->drive_by_hand(lines.front()); !led) {
    std::cerr << led.error().message << '\n';
    return 1;
  }
  for (bool done = false; !done;) {
    const auto sample = (*body)->step({});
    if (!sample) {
      std::cerr << sample.error().message << '\n';
      return 1;
    }
    done = sample->hand_done;
    if (!sample->views.empty() && (sample->frame % static_cast<std::uint64_t>(options.every) == 1 || done)) {
      const cv::Mat image = picture_of(sample->views.front());
      char name[40];
      std::snprintf(name, sizeof name, "/frame-%04d.png", static_cast<int>(sample->frame));
      weft::test::write_png(words[2] + name,
                            {images::Shades::grey, image.cols, image.rows, {image.datastart, image.dataend}});
    }
    if (done) {
      std::printf("%.1f s, %llu frames\n", seconds(sample->time.time_since_epoch()),
                  static_cast<unsigned long long>(sample->frame));
    }
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  std::vector<std::string> words;
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--floors" && i + 1 < argc) {
      options.floors = argv[++i];
    } else if (word == "--every" && i + 1 < argc) {
      options.every = std::max(1, std::atoi(argv[++i]));
    } else if (word == "--kind" && i + 1 < argc) {
      options.kind = argv[++i];
    } else if (word == "--light" && i + 1 < argc) {
      options.light = argv[++i];
    } else if (word == "--wear" && i + 1 < argc) {
      options.wear = argv[++i];
    } else {
      words.push_back(word);
    }
  }
  if (words.size() < 4) {
    std::cerr << "usage: sim-look SITE.toml ROBOT OUT_DIR LINE... [--floors DIR] [--every N] [--kind K] [--light L] "
                 "[--wear W]\n";
    return 2;
  }
  return look(words, options);
} catch (const std::exception& problem) {
  std::fprintf(stderr, "sim-look: %s\n", problem.what());
  return 1;
}
