#include "agents/perception/exposure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace weft::agents {
namespace {

constexpr int kColumns = 16;  // of parts of an image, as corners are spread over it
constexpr int kRows = 8;
constexpr int kEvery = 3;  // one pixel of so many is looked at, each way
constexpr int kApart = 3;  // pixels that are held against each other
constexpr std::size_t kFactors = 13;
constexpr std::size_t kAsItIs = kFactors / 2;
constexpr double kStep = 1.0 / 3.0;  // from factor to factor, powers of 2
constexpr std::size_t kGreys = 256;

using PerFactor = std::array<double, kFactors>;

double factor_at(double i) {
  return std::exp2(kStep * (i - static_cast<double>(kAsItIs)));
}

/// Returns how much each difference of grey levels will tell once light is multiplied by each factor.
std::array<std::array<float, kFactors>, kGreys> told_by_difference(double noise_grey) {
  constexpr double scale = 0.25;  // 1 over the grey levels from where on more tells little more
  std::array<std::array<float, kFactors>, kGreys> told{};
  for (std::size_t i = 0; i < kFactors; ++i) {
    const double factor = factor_at(static_cast<double>(i));
    for (std::size_t difference = 0; difference < kGreys; ++difference) {
      const double above = factor * static_cast<double>(difference) - noise_grey;
      told[difference][i] = static_cast<float>(std::log1p(scale * std::max(0.0, above)));
    }
  }
  return told;
}

/// Counts, for each grey level, how many factors, the lowest first, leave it below white.
std::array<std::size_t, kGreys> factors_below_white(double white_grey) {
  std::array<std::size_t, kGreys> many{};
  for (std::size_t grey = 0; static_cast<double>(grey) < white_grey; ++grey)
    while (many[grey] < kFactors &&
           factor_at(static_cast<double>(many[grey])) * static_cast<double>(grey) < white_grey)
      ++many[grey];
  return many;
}

struct Part {
  std::array<float, kFactors> told{};
  std::array<float, kFactors> below_white{};  // pixels looked at
  float seen = 0.0F;
  float white = 0.0F;
};
using Parts = std::array<Part, kColumns * kRows>;

Parts parts_of(const Image& image, double gain, const ExposureConfig& config) {
  const auto told = told_by_difference(config.noise_grey * std::sqrt(std::max(1.0, gain)));
  const auto below = factors_below_white(config.white_grey);
  Parts parts{};
  const std::ptrdiff_t lower = static_cast<std::ptrdiff_t>(kApart) * image.width;
  for (int y = 0; y + kApart < image.height; y += kEvery) {
    const std::uint8_t* const row = image.pixels->data() + static_cast<std::ptrdiff_t>(y) * image.width;
    Part* const first = &parts[static_cast<std::size_t>(y * kRows / image.height * kColumns)];
    for (int x = 0; x + kApart < image.width; x += kEvery) {
      const int here = row[x];
      const int right = row[x + kApart];
      const int down = row[x + lower];
      const auto difference = static_cast<std::size_t>(std::max(std::abs(right - here), std::abs(down - here)));
      const std::size_t many = below[static_cast<std::size_t>(std::max({here, right, down}))];
      Part& part = first[x * kColumns / image.width];
      part.seen += 1.0F;
      if (many == 0) part.white += 1.0F;
      for (std::size_t i = 0; i < many; ++i) {
        part.told[i] += told[difference][i];
        part.below_white[i] += 1.0F;
      }
    }
  }
  return parts;
}

/// Predicts how much an image of each factor will show. What is white now is as rich as the rest where it comes back.
/// One more corner in a crowd is worth less than one in an empty part: the root.
PerFactor shown(const Parts& parts, const ExposureConfig& config) {
  PerFactor shows{};
  for (std::size_t i = 0; i < kFactors; ++i) {
    double told = 0.0;
    double below_white = 0.0;
    for (const Part& part : parts) {
      told += static_cast<double>(part.told[i]);
      below_white += static_cast<double>(part.below_white[i]);
    }
    const double usual = told / std::max(1.0, below_white);
    const double factor = factor_at(static_cast<double>(i));
    const double comes_back = factor < 1.0 ? 1.0 - std::pow(factor, config.hidden_slope) : 0.0;
    for (const Part& part : parts) {
      const double back = comes_back * static_cast<double>(part.white);
      const double tells = static_cast<double>(part.told[i]) + back * usual;
      const double not_white = static_cast<double>(part.below_white[i]) + back;
      shows[i] += std::sqrt(tells * not_white / std::max(1.0, static_cast<double>(part.seen)));
    }
  }
  return shows;
}

/// Returns the factor that brings an image to the middle of the scale, for one that shows nothing at any factor:
/// something may turn up there.
double towards_grey(const Image& image) {
  constexpr double middle_grey = 110.0;
  double sum = 1.0;
  for (const std::uint8_t grey : *image.pixels) sum += static_cast<double>(grey);
  const double mean = sum / static_cast<double>(image.pixels->size());
  return std::clamp(middle_grey / mean, factor_at(0.0), factor_at(static_cast<double>(kFactors - 1)));
}

}  // namespace

double exposure_factor(const Image& image, double gain, const ExposureConfig& config) {
  const PerFactor shows = shown(parts_of(image, gain, config), config);
  const auto best = static_cast<std::size_t>(std::max_element(shows.begin(), shows.end()) - shows.begin());
  if (!(shows[best] > 0.0)) return std::pow(towards_grey(image), config.followed);
  auto peak = static_cast<double>(best);
  if (best > 0 && best + 1 < kFactors) {
    const double bend = shows[best - 1] - 2.0 * shows[best] + shows[best + 1];
    if (bend < 0.0) peak += 0.5 * (shows[best - 1] - shows[best + 1]) / bend;
  }
  return std::pow(factor_at(peak), config.followed);
}

Exposure brightened(const Exposure& taken, double factor, double moves_px_s, const ExposureConfig& config) {
  constexpr double slowest_px_s = 1e-3;
  const double light_s = factor * taken.light_s();
  const double sharp_s = config.most_blur_px / std::max(moves_px_s, slowest_px_s);
  const double time_s = std::min({light_s, config.longest_time_s, sharp_s});
  return {time_s, light_s / time_s};
}

}  // namespace weft::agents
