// For people: draws a site with lines from above (site.png), and what a robot sees while it is led along the first
// one (frame-NNNN.png). Usage: sim-look SITE.toml ROBOT OUT_DIR LINE... [--floors DIR] [--every N]
#include <cairo/cairo.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "agents/bodies/sim/sim_body.hpp"

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
  for (const sim::Box& box : site.boxes) {
    cairo_save(cr);
    cairo_translate(cr, box.site_from_box.x, box.site_from_box.y);
    cairo_rotate(cr, box.site_from_box.heading);
    cairo_rectangle(cr, -box.length_m / 2, -box.width_m / 2, box.length_m, box.width_m);
    cairo_set_source_rgb(cr, 0.6, 0.6, 0.65);
    cairo_fill(cr);
    cairo_restore(cr);
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

int look(const std::vector<std::string>& words, const std::optional<std::string>& floors, int every) {
  auto site = sim::parse_site(text_of(words[0]), words[0]);
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
  config.floors_dir = floors;
  config.warn = [](const std::string& text) { std::cerr << text << '\n'; };
  auto body = sim::make_sim_body(config);
  if (!body) {
    std::cerr << body.error().message << '\n';
    return 1;
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
    if (sample->view && (sample->frame % static_cast<std::uint64_t>(every) == 1 || done)) {
      const Image& image = std::get<Image>(sample->view->data);
      char name[40];
      std::snprintf(name, sizeof name, "/frame-%04d.png", static_cast<int>(sample->frame));
      cv::imwrite(words[2] + name,
                  cv::Mat(image.height, image.width, CV_8U, const_cast<std::uint8_t*>(image.pixels->data())));
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
  std::optional<std::string> floors;
  int every = 60;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--floors" && i + 1 < argc) {
      floors = argv[++i];
    } else if (word == "--every" && i + 1 < argc) {
      every = std::max(1, std::atoi(argv[++i]));
    } else {
      words.push_back(word);
    }
  }
  if (words.size() < 4) {
    std::cerr << "usage: sim-look SITE.toml ROBOT OUT_DIR LINE... [--floors DIR] [--every N]\n";
    return 2;
  }
  return look(words, floors, every);
} catch (const std::exception& problem) {
  std::fprintf(stderr, "sim-look: %s\n", problem.what());
  return 1;
}
