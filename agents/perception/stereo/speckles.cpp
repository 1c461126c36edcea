#include "agents/perception/stereo/speckles.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace weft::agents {
namespace {

/// Holds pixels of one row that lie side by side in one patch.
struct Run {
  std::int32_t row, begin, end;
  std::int32_t patch;   // index of a run that stands for it; its own: this one does
  std::int32_t pixels;  // of the patch, where this run stands for it
};

class Runs {
 public:
  /// Adds a row's runs and joins them with those of the row above.
  void add(const std::int16_t* values, int row, int width, int range, std::int16_t none) {
    const std::size_t above = last_row_;
    last_row_ = runs_.size();
    for (int x = 0; x < width;) {
      if (values[x] == none) {
        ++x;
        continue;
      }
      const int begin = x++;
      while (x < width && values[x] != none && std::abs(values[x] - values[x - 1]) <= range) ++x;
      runs_.push_back({row, begin, x, static_cast<std::int32_t>(runs_.size()), x - begin});
    }
    if (row > 0) join(above, values, width, range);
  }

  void remove(std::vector<std::int16_t>& values, int width, int fewest, std::int16_t none) {
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      if (runs_[patch_of(i)].pixels >= fewest) continue;
      std::int16_t* const row = values.data() + static_cast<std::ptrdiff_t>(runs_[i].row) * width;
      std::fill(row + runs_[i].begin, row + runs_[i].end, none);
    }
  }

 private:
  std::size_t patch_of(std::size_t run) {
    while (runs_[run].patch != static_cast<std::int32_t>(run)) {
      runs_[run].patch = runs_[static_cast<std::size_t>(runs_[run].patch)].patch;
      run = static_cast<std::size_t>(runs_[run].patch);
    }
    return run;
  }

  void join(std::size_t above, const std::int16_t* values, int width, int range) {
    std::size_t upper = above;
    for (std::size_t lower = last_row_; lower < runs_.size(); ++lower) {
      while (upper < last_row_ && runs_[upper].end <= runs_[lower].begin) ++upper;
      for (std::size_t other = upper; other < last_row_ && runs_[other].begin < runs_[lower].end; ++other) {
        const int begin = std::max(runs_[lower].begin, runs_[other].begin);
        const int end = std::min(runs_[lower].end, runs_[other].end);
        bool touches = false;
        for (int x = begin; x < end && !touches; ++x) touches = std::abs(values[x] - values[x - width]) <= range;
        if (touches) unite(lower, other);
      }
    }
  }

  void unite(std::size_t one, std::size_t other) {
    const std::size_t a = patch_of(one);
    const std::size_t b = patch_of(other);
    if (a == b) return;
    const std::size_t kept = std::min(a, b);
    const std::size_t gone = std::max(a, b);
    runs_[gone].patch = static_cast<std::int32_t>(kept);
    runs_[kept].pixels += runs_[gone].pixels;
  }

  std::vector<Run> runs_;
  std::size_t last_row_ = 0;  // the newest row's first run
};

}  // namespace

void remove_speckles(std::vector<std::int16_t>& values, int width, int fewest, int range, std::int16_t none) {
  if (fewest <= 1 || width <= 0) return;
  const int height = static_cast<int>(values.size() / static_cast<std::size_t>(width));
  Runs runs;
  for (int row = 0; row < height; ++row)
    runs.add(values.data() + static_cast<std::ptrdiff_t>(row) * width, row, width, range, none);
  runs.remove(values, width, fewest, none);
}

}  // namespace weft::agents
