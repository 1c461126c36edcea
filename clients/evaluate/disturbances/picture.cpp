#include "clients/evaluate/disturbances/picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "clients/chart/canvas.hpp"

namespace weft::evaluate {
namespace {

using namespace charts;

constexpr double kNames = 170.0;  // left of the panels
constexpr double kPanel = 260.0;  // width
constexpr double kGap = 34.0;
constexpr double kTop = 150.0;
constexpr double kRow = 30.0;
constexpr double kBottom = 70.0;

constexpr Colour kWithout = kBlue;
constexpr Colour kOnly = kVermilion;
constexpr Colour kWith = kGreen;

struct Panel {
  const char* title;
  const char* unit;
  double Score::*value;
};
constexpr std::array kPanels = {
    Panel{"speed error of odometry", "mm/s, RMS over 0.5 s", &Score::speed_error_mm_s},
    Panel{"drift of odometry over 10 m", "mm, median", &Score::drift_mm},
    Panel{"error of fixes", "mm, median", &Score::fix_mm},
    Panel{"right fixes", "% of the views near a place", &Score::fixes_percent},
};

/// A round number of at least `value`, and the distance of its grid lines.
std::pair<double, double> axis(double value) {
  const double size = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-3))));
  for (const auto& [most, step] :
       {std::pair{1.0, 0.25}, {2.0, 0.5}, {3.0, 1.0}, {4.0, 1.0}, {6.0, 2.0}, {8.0, 2.0}}) {
    if (value <= most * size) return {most * size, step * size};
  }
  return {10.0 * size, 2.5 * size};
}

class Drawing {
 public:
  Drawing(const std::filesystem::path& file, double wide, double tall, const Rows& rows,
          const std::vector<std::string>& names, Seeds seeds)
      : canvas_(file, wide, tall), rows_(rows), names_(names), seeds_(seeds) {}

  void title(const std::string& about) {
    text(24.0, 36.0, "What each disturbance of the simulated body costs", 20.0, kInk);
    text(24.0, 58.0, about, 12.0, kQuiet);
    double x = 30.0;
    x = key(
        x, [&](double at) { mark(at, 86.0, kWithout, false); }, "all but this one");
    x = key(
        x, [&](double at) { mark(at, 86.0, kWith, false); }, "all and this one");
    x = key(
        x, [&](double at) { mark(at, 86.0, kOnly, true); }, "this one alone");
    x = key(
        x, [&](double at) { upright(at, 78.0, 94.0, kWithout, true); }, "all");
    x = key(
        x, [&](double at) { upright(at, 78.0, 94.0, kOnly, true); }, "none");
    key(
        x, [&](double at) { bar(at - 8.0, at + 8.0, 86.0, kQuiet); }, "least and most of the seeds");
  }

  void names() {
    for (std::size_t i = 0; i < names_.size(); ++i) text(24.0, row(i) + 4.0, names_[i], 13.0, kInk);
  }

  void panel(std::size_t number) {
    const Panel& panel = kPanels.at(number);
    const double left = kNames + static_cast<double>(number) * (kPanel + kGap);
    const auto [most, step] = axis(largest(panel.value));
    const auto x = [left = left, most = most](double value) { return left + kPanel * value / most; };
    const double end = row(names_.size()) - 8.0;
    text(left, kTop - 28.0, panel.title, 14.0, kInk);
    text(left, kTop - 12.0, panel.unit, 11.0, kQuiet);
    for (double value = 0.0; value <= most * 1.001; value += step) {
      upright(x(value), kTop - 4.0, end, kGrid, false);
      std::array<char, 32> words{};
      std::snprintf(words.data(), words.size(), "%g", value);
      text(x(value) - 0.5 * width(words.data(), 11.0), end + 16.0, words.data(), 11.0, kQuiet);
    }
    upright(x(spread("all", panel.value).mean), kTop - 4.0, end, kWithout, true);
    upright(x(spread("none", panel.value).mean), kTop - 4.0, end, kOnly, true);
    for (std::size_t i = 0; i < names_.size(); ++i) {
      show(spread("without " + names_[i], panel.value), x, row(i) - 5.0, kWithout, false);
      show(spread("with " + names_[i], panel.value), x, row(i) - 5.0, kWith, false);
      show(spread("only " + names_[i], panel.value), x, row(i) + 5.0, kOnly, true);
    }
  }

  Result<void> write() { return canvas_.write(); }

 private:
  static double row(std::size_t i) { return kTop + kRow * (static_cast<double>(i) + 0.5); }

  Spread spread(const std::string& variant, double Score::*value) const {
    return spread_of(rows_, variant, seeds_, value);
  }

  double largest(double Score::*value) const {
    double most = 0.0;
    for (const auto& [key, score] : rows_) {
      if (key.second >= seeds_.first && key.second <= seeds_.last) most = std::fmax(most, score.*value);
    }
    return most;
  }

  template <class Scale>
  void show(const Spread& spread, const Scale& x, double y, const Colour& ink, bool full) {
    if (!std::isfinite(spread.mean)) return;
    bar(x(spread.least), x(spread.most), y, ink);
    mark(x(spread.mean), y, ink, full);
  }

  template <class Sign>
  double key(double x, const Sign& sign, const std::string& words) {
    sign(x);
    text(x + 14.0, 90.0, words, 12.0, kInk);
    return x + 14.0 + width(words, 12.0) + 30.0;
  }

  void mark(double x, double y, const Colour& ink, bool full) { canvas_.mark({x, y}, 4.0, ink, full); }
  void bar(double from, double to, double y, const Colour& ink) { canvas_.line({from, y}, {to, y}, ink, 1.2); }
  void upright(double x, double from, double to, const Colour& ink, bool dashed) {
    if (std::isfinite(x)) canvas_.line({x, from}, {x, to}, ink, dashed ? 1.4 : 1.0, dashed);
  }
  void text(double x, double y, const std::string& words, double size, const Colour& ink) {
    canvas_.text(x, y, words, size, ink);
  }
  double width(const std::string& words, double size) { return canvas_.width(words, size); }

  Canvas canvas_;
  const Rows& rows_;
  const std::vector<std::string>& names_;
  Seeds seeds_;
};

}  // namespace

Result<void> draw_disturbances(const Rows& rows, const std::vector<std::string>& disturbances, Seeds seeds,
                               const std::string& about, const std::filesystem::path& file) {
  const double wide = kNames + static_cast<double>(kPanels.size()) * (kPanel + kGap);
  const double tall = kTop + kRow * static_cast<double>(disturbances.size()) + kBottom;
  Drawing drawing(file, wide, tall, rows, disturbances, seeds);
  drawing.title(about);
  drawing.names();
  for (std::size_t i = 0; i < kPanels.size(); ++i) drawing.panel(i);
  return drawing.write();
}

}  // namespace weft::evaluate
