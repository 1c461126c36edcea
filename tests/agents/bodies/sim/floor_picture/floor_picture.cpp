// For the judge: the bare floor of a site, without what [change] lays on it, as one picture, so that others can see
// whether it repeats. Usage: sim-floor SITE.toml OUT.pgm [--floors DIR] [--kind K]
// An 8-bit PGM, 10 mm a pixel, rows along y upwards, of the site's bounds; of a larger hall the 24 m in its middle.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>

#include "agents/bodies/sim/changes.hpp"
#include "agents/bodies/sim/floor/site_floor.hpp"
#include "agents/bodies/sim/floor/tile_cache.hpp"

namespace {

using namespace weft;
using namespace weft::agents;

constexpr std::size_t kLevel = 4;  // texels of 10 mm
constexpr int kSide = sim::kTileTexels >> kLevel;
constexpr double kMostM = 24.0;

std::string text_of(const std::string& path) {
  const std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Returns the first and the last of the tiles that cover the middle of [low, high].
std::pair<std::int32_t, std::int32_t> tiles_of(double low, double high) {
  const double middle = (low + high) / 2;
  const double half = std::min(high - low, kMostM) / 2;
  return {static_cast<std::int32_t>(std::floor((middle - half) / sim::kTileM)),
          static_cast<std::int32_t>(std::ceil((middle + half) / sim::kTileM)) - 1};
}

int write_picture(const sim::Site& site, const std::optional<std::string>& floors, const std::string& path) {
  auto floor = sim::make_site_floor(site, floors, [](const std::string& text) { std::cerr << text << '\n'; });
  if (!floor) {
    std::cerr << "sim-floor: " << floor.error().message << '\n';
    return 1;
  }
  const auto [first_x, last_x] = tiles_of(site.floor.x_min, site.floor.x_max);
  const auto [first_y, last_y] = tiles_of(site.floor.y_min, site.floor.y_max);
  const auto width = static_cast<std::size_t>(last_x - first_x + 1) * kSide;
  sim::TileCache cache(*floor, 8'000'000);
  std::ofstream file(path, std::ios::binary);
  file << "P5\n" << width << ' ' << (last_y - first_y + 1) * kSide << "\n255\n";
  std::vector<char> rows(width * kSide);
  for (std::int32_t y = first_y; y <= last_y; ++y) {
    for (std::int32_t x = first_x; x <= last_x; ++x) {
      const std::vector<std::uint8_t>& tile = cache.tile({x, y}).levels[kLevel];
      for (std::size_t j = 0; j < kSide; ++j) {
        std::copy_n(
            tile.begin() + static_cast<std::ptrdiff_t>(j * kSide), kSide,
            rows.begin() + static_cast<std::ptrdiff_t>(j * width + static_cast<std::size_t>(x - first_x) * kSide));
      }
    }
    file.write(rows.data(), static_cast<std::streamsize>(rows.size()));
  }
  if (!file.flush()) {
    std::cerr << "sim-floor: " << path << ": cannot be written\n";
    return 1;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  std::vector<std::string> words;
  std::optional<std::string> floors;
  std::optional<std::string> kind;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--floors" && i + 1 < argc) {
      floors = argv[++i];
    } else if (word == "--kind" && i + 1 < argc) {
      kind = argv[++i];
    } else {
      words.push_back(word);
    }
  }
  if (words.size() != 2) {
    std::cerr << "usage: sim-floor SITE.toml OUT.pgm [--floors DIR] [--kind K]\n";
    return 2;
  }
  auto site = sim::parse_site(text_of(words[0]), words[0]);
  if (site && kind) site = sim::on_floor(*site, *kind);
  if (!site) {
    std::cerr << "sim-floor: " << site.error().message << '\n';
    return 1;
  }
  site->change = {};
  return write_picture(*site, floors, words[1]);
} catch (const std::exception& problem) {
  std::fprintf(stderr, "sim-floor: %s\n", problem.what());
  return 1;
}
