// What loads and signs look like, drawn once.
#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>

#include "agents/bodies/sim/hall/textures.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {
namespace {

constexpr int kSide = 128;

class Picture {
 public:
  explicit Picture(double grey) : grey_(kSide, kSide, CV_8U, cv::Scalar(grey)) {}

  void fill(double x, double y, double w, double h, double grey) {
    cv::rectangle(grey_, box(x, y, w, h), cv::Scalar(grey), cv::FILLED);
  }
  void frame(double x, double y, double w, double h, double grey, int thickness = 1) {
    cv::rectangle(grey_, box(x, y, w, h), cv::Scalar(grey), thickness);
  }
  /// Draws rows of dashes, as print looks from where it cannot be read.
  void print(double x, double y, double w, double h, double grey, Random& random) {
    for (double row = y; row + 2 <= y + h; row += 4.0)
      for (double at = x; at < x + w - 2;) {
        const double dash = random.uniform(2.0, 9.0);
        fill(at, row, std::min(dash, x + w - at), 2, grey);
        at += dash + random.uniform(1.0, 3.0);
      }
  }
  void disc(double x, double y, double radius, double grey) {
    cv::circle(grey_, {static_cast<int>(x), static_cast<int>(y)}, static_cast<int>(radius), cv::Scalar(grey),
               cv::FILLED);
  }
  void line(double x0, double y0, double x1, double y1, double grey, int thickness) {
    cv::line(grey_, {static_cast<int>(x0), static_cast<int>(y0)}, {static_cast<int>(x1), static_cast<int>(y1)},
             cv::Scalar(grey), thickness, cv::LINE_AA);
  }
  /// Returns the picture with the grain of paper and paint.
  Texture done(Random& random) const {
    std::vector<std::uint8_t> texels;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        texels.push_back(
            static_cast<std::uint8_t>(std::clamp(grey_.at<std::uint8_t>(y, x) + 4.0 * random.normal(), 2.0, 253.0)));
    return {kSide, std::move(texels)};
  }

 private:
  static cv::Rect box(double x, double y, double w, double h) {
    return {static_cast<int>(x), static_cast<int>(y), std::max(1, static_cast<int>(w)),
            std::max(1, static_cast<int>(h))};
  }
  cv::Mat grey_;
};

void carton(Picture& picture, double x, double y, double w, double h, Random& random) {
  const double grey = random.uniform(95.0, 165.0);
  picture.fill(x, y, w, h, grey);
  picture.frame(x, y, w, h, grey - 45.0);
  picture.fill(x + 1, y + 0.5 * h - 1.5, w - 2, 3, grey + random.uniform(10.0, 40.0));  // tape
  if (random.chance(0.7)) {
    const double label_w = random.uniform(0.2, 0.4) * w;
    const double label_h = random.uniform(0.2, 0.35) * h;
    const double at_x = x + random.uniform(0.05, 0.55) * w;
    const double at_y = y + random.uniform(0.05, 0.6) * h;
    picture.fill(at_x, at_y, label_w, label_h, random.uniform(200.0, 240.0));
    picture.print(at_x + 1, at_y + 1, label_w - 2, label_h - 2, 40.0, random);
  }
  if (random.chance(0.3)) picture.print(x + 0.1 * w, y + 0.7 * h, 0.6 * w, 0.2 * h, grey - 60.0, random);
}

Texture cartons(Random& random) {
  Picture picture(60.0);
  const auto rows = 1 + static_cast<int>(random.below(4));
  const double h = static_cast<double>(kSide) / rows;
  for (int row = 0; row < rows; ++row) {
    const auto columns = 1 + static_cast<int>(random.below(4));
    const double w = static_cast<double>(kSide) / columns;
    for (int column = 0; column < columns; ++column) carton(picture, column * w, row * h, w - 1, h - 1, random);
  }
  return picture.done(random);
}

/// Draws film over dark or light goods: streaks from side to side, a label.
Texture wrapped(Random& random) {
  const double grey = random.uniform(60.0, 190.0);
  Picture picture(grey);
  for (int streak = 0; streak < 26; ++streak) {
    const double y = random.uniform(-30.0, kSide + 30.0);
    picture.line(0, y, kSide, y + random.uniform(-30.0, 30.0), grey + random.uniform(-35.0, 50.0), 1);
  }
  const double x = random.uniform(10.0, 70.0);
  const double y = random.uniform(10.0, 80.0);
  picture.fill(x, y, 36, 26, 235.0);
  picture.print(x + 2, y + 2, 32, 22, 30.0, random);
  return picture.done(random);
}

Texture drums(Random& random) {
  Picture picture(45.0);
  for (int drum = 0; drum < 2; ++drum) {
    const double grey = random.uniform(70.0, 180.0);
    const double x = drum * 64.0;
    for (int i = 0; i < 60; ++i) {
      const double round = 1.0 - 0.6 * std::abs(i - 25.0) / 30.0;
      picture.fill(x + 2 + i, 4, 1, 120, grey * round);
    }
    for (const double y : {30.0, 62.0, 94.0}) picture.fill(x + 2, y, 60, 3, grey * 0.5);
    picture.fill(x + random.uniform(8.0, 34.0), 40, 20, 16, 220.0);
  }
  return picture.done(random);
}

Texture sign(Random& random) {
  const bool dark = random.chance(0.4);
  const double ground = dark ? random.uniform(40.0, 90.0) : random.uniform(180.0, 235.0);
  const double ink = dark ? 230.0 : 25.0;
  Picture picture(ground);
  picture.frame(3, 3, 121, 121, ink, 3);
  switch (random.below(4)) {
    case 0:
      picture.disc(64, 50, 30, ink);
      picture.disc(64, 50, random.uniform(8.0, 22.0), ground);
      picture.print(14, 92, 100, 22, ink, random);
      break;
    case 1:
      for (int stripe = -2; stripe < 6; ++stripe) picture.line(stripe * 26, 128, stripe * 26 + 90, 0, ink, 9);
      break;
    case 2:
      picture.print(12, 14, 100, 100, ink, random);
      break;
    default: {
      const double x = random.uniform(20.0, 60.0);
      picture.fill(x, 20, random.uniform(14.0, 44.0), 60, ink);
      picture.fill(20, random.uniform(40.0, 60.0), 88, 14, ink);
      picture.print(14, 94, 100, 20, ink, random);
    }
  }
  return picture.done(random);
}

template <class Draw>
std::vector<Texture> drawn(std::size_t count, std::uint64_t seed, const Draw& draw) {
  std::vector<Texture> textures;
  for (std::size_t i = 0; i < count; ++i) {
    Random random(Random(seed).fork(i));
    textures.push_back(draw(i, random));
  }
  return textures;
}

}  // namespace

std::vector<Texture> draw_loads(std::uint64_t seed) {
  return drawn(64, seed, [](std::size_t i, Random& random) {
    if (i % 8 == 7) return drums(random);
    return i % 4 == 2 ? wrapped(random) : cartons(random);
  });
}

std::vector<Texture> draw_signs(std::uint64_t seed) {
  return drawn(24, seed ^ 0x5167ULL, [](std::size_t, Random& random) { return sign(random); });
}

namespace {

/// Describes clouds of a size (texels) and strength (grey levels); `clouds` adds several up, about 128.
struct Cloud {
  int size;
  double grey;
};
cv::Mat clouds(std::initializer_list<Cloud> of, int side, Random& random) {
  cv::Mat sum(side, side, CV_32F, cv::Scalar(128.0));
  for (const Cloud& cloud : of) {
    const int cells = std::max(2, side / cloud.size);
    cv::Mat coarse(cells, cells, CV_32F);
    for (int y = 0; y < cells; ++y)
      for (int x = 0; x < cells; ++x) coarse.at<float>(y, x) = static_cast<float>(cloud.grey * random.normal());
    cv::Mat fine;
    cv::resize(coarse, fine, {side, side}, 0, 0, cloud.size == 1 ? cv::INTER_NEAREST : cv::INTER_CUBIC);
    sum += fine;
  }
  return sum;
}

/// Draws sheet metal with scratches, dents, drops of paint and rivets here and there.
cv::Mat sheet_metal(int side, Random& random) {
  cv::Mat look = clouds({{4, 3.0}, {9, 5.0}, {60, 9.0}}, side, random);
  const auto at = [&] { return static_cast<int>(random.below(static_cast<std::uint64_t>(side))); };
  for (int i = 0; i < 40; ++i) {
    const cv::Point from(at(), at());
    const cv::Point to = from + cv::Point(static_cast<int>(random.uniform(-50.0, 50.0)),
                                          static_cast<int>(random.uniform(-12.0, 12.0)));
    cv::line(look, from, to, cv::Scalar(random.uniform(85.0, 165.0)), 1, cv::LINE_AA);
  }
  for (int i = 0; i < 110; ++i) {
    const auto radius = 1 + static_cast<int>(random.below(3));
    cv::circle(look, {at(), at()}, radius, cv::Scalar(random.chance(0.7) ? random.uniform(60.0, 100.0) : 165.0),
               cv::FILLED, cv::LINE_AA);
  }
  for (int i = 0; i < 6; ++i) {
    const cv::Point label(at(), at());
    cv::rectangle(look, {label.x, label.y, 24, 14}, cv::Scalar(190.0), cv::FILLED);
    cv::rectangle(look, {label.x + 3, label.y + 4, 15, 2}, cv::Scalar(70.0), cv::FILLED);
  }
  return look;
}

cv::Mat look_of(Stuff stuff, int side, Random& random) {
  switch (stuff) {
    case Stuff::wall: {  // blocks, 0.4 x 0.2 m, and stains
      cv::Mat look = clouds({{1, 3.0}, {8, 4.0}, {100, 8.0}}, side, random);
      for (int y = 0; y < side; y += 40) {
        cv::line(look, {0, y}, {side, y}, cv::Scalar(105.0), 2);
        for (int x = (y / 40 % 2) * 40; x < side; x += 80) cv::line(look, {x, y}, {x, y + 40}, cv::Scalar(108.0), 2);
      }
      return look;
    }
    case Stuff::ceiling: {  // trapezoidal sheet
      cv::Mat look = clouds({{1, 2.0}, {60, 6.0}}, side, random);
      for (int x = 0; x < side; x += 50) cv::rectangle(look, {x, 0, 12, side}, cv::Scalar(100.0), cv::FILLED);
      return look;
    }
    case Stuff::steel: {
      cv::Mat look = clouds({{1, 2.0}, {20, 3.0}}, side, random);
      for (int y = 0; y < side; y += 10)
        for (int x = 3; x < side; x += 20) cv::rectangle(look, {x, y, 3, 5}, cv::Scalar(60.0), cv::FILLED);
      return look;
    }
    case Stuff::pallet: {
      cv::Mat look = clouds({{1, 5.0}, {3, 8.0}, {40, 12.0}}, side, random);
      for (int x = 0; x < side; x += 28) cv::rectangle(look, {x, 0, 9, side}, cv::Scalar(45.0), cv::FILLED);
      return look;
    }
    case Stuff::clothing:
      return clouds({{1, 3.0}, {10, 14.0}, {30, 14.0}}, side, random);
    case Stuff::vehicle: {
      cv::Mat look = clouds({{1, 2.0}, {50, 12.0}}, side, random);
      for (int y = 20; y < side; y += 60) cv::rectangle(look, {0, y, side, 10}, cv::Scalar(40.0), cv::FILLED);
      return look;
    }
    case Stuff::duct:
      return sheet_metal(side, random);
    default:
      return clouds({{1, 2.0}}, side, random);
  }
}

}  // namespace

Texture draw_plain(Stuff stuff, std::uint64_t seed) {
  constexpr int side = 512;
  Random random(seed);
  cv::Mat look = look_of(stuff, side, random);
  look *= 128.0 / cv::mean(look)[0];
  look.convertTo(look, CV_8U);
  return {side, {look.datastart, look.dataend}};
}

}  // namespace weft::agents::sim
