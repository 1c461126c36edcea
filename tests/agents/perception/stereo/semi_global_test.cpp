#include "agents/perception/stereo/semi_global.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "core/random.hpp"

namespace weft::agents::semi_global {
namespace {

/// Holds a row of random census bits whose right image is the left one moved by `shift`, and what rows leave.
class RandomRow {
 public:
  RandomRow(int width, int disparities, int shift, std::uint64_t seed)
      : bytes_(static_cast<std::size_t>(padded(disparities))), near_(256) {
    Random random(seed);
    const auto columns = static_cast<std::size_t>(width);
    const std::size_t plane = columns + kMostDisparities;
    left_.resize(kCensusPlanes * plane);
    right_.resize(kCensusPlanes * plane);
    for (std::uint8_t& nibble : left_) nibble = static_cast<std::uint8_t>(random.below(16));
    for (std::uint8_t& nibble : right_) nibble = static_cast<std::uint8_t>(random.below(16));
    for (std::size_t p = 0; p < kCensusPlanes; ++p)
      for (int x = shift; x < width; ++x)
        right_[p * plane + columns - 1 - static_cast<std::size_t>(x - shift)] =
            left_[p * plane + static_cast<std::size_t>(x)];
    for (auto* path : {&from_left_, &from_right_}) path->resize((columns + 1) * bytes_);
    for (auto* least : {&from_left_least_, &from_right_least_}) least->resize(columns + 1);
    for (auto* room : {&costs_, &sums_}) room->resize(columns * bytes_);
    for (std::size_t i = 0; i < near_.size(); ++i) near_[i] = static_cast<std::uint8_t>(i + i / 20);
    best.resize(columns);
    best_right.resize(columns);
    row_ = {width,
            disparities,
            7,
            32,
            left_.data(),
            right_.data(),
            static_cast<int>(plane),
            from_left_.data(),
            from_left_least_.data(),
            from_right_.data(),
            from_right_least_.data(),
            costs_.data(),
            sums_.data(),
            near_.data(),
            best.data(),
            best_right.data()};
  }

  const Row& row() const { return row_; }
  /// Returns all that a row leaves.
  std::vector<int> left_behind() const {
    std::vector<int> all(best.begin(), best.end());
    for (const auto* bytes : {&best_right, &from_left_, &from_right_, &from_left_least_, &from_right_least_, &sums_})
      all.insert(all.end(), bytes->begin(), bytes->end());
    return all;
  }

  std::vector<std::int16_t> best;
  std::vector<std::uint8_t> best_right;

 private:
  std::size_t bytes_;
  std::vector<std::uint8_t> left_, right_, from_left_, from_right_, from_left_least_, from_right_least_, costs_,
      sums_, near_;
  Row row_;
};

TEST(SemiGlobal, BothBuildsGiveTheSameNumbers) {
  if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "this machine can run one of them only";
  for (const int disparities : {16, 32, 48, 64, 80, 96, 128}) {
    RandomRow one(173, disparities, 9, 5);
    RandomRow other(173, disparities, 9, 5);
    for (int rows = 0; rows < 3; ++rows) {  // each goes on from what the one above has left
      plain::match_row(one.row());
      avx2::match_row(other.row());
      ASSERT_EQ(one.left_behind(), other.left_behind()) << disparities << " disparities, row " << rows;
    }
  }
}

TEST(SemiGlobal, FindsHowFarARowIsMoved) {
  for (const int shift : {1, 12, 30}) {
    RandomRow row(200, 48, shift, 8);
    plain::match_row(row.row());
    for (int x = shift + 2; x < 200; ++x) {
      EXPECT_NEAR(row.best[static_cast<std::size_t>(x)], 16 * shift, 8) << "column " << x;
      EXPECT_EQ(row.best_right[static_cast<std::size_t>(x - shift)], shift) << "column " << x;
    }
  }
}

TEST(SemiGlobal, TellsNothingOfWhatIsNearerThanItSearches) {
  RandomRow row(200, 16, 15, 8);  // 15 is the last one: what is beyond was not looked at
  plain::match_row(row.row());
  for (int x = 40; x < 200; ++x) EXPECT_EQ(row.best[static_cast<std::size_t>(x)], kAmbiguous) << "column " << x;
}

TEST(SemiGlobal, ARowWithoutTextureIsAmbiguous) {
  RandomRow row(120, 32, 0, 8);
  std::vector<std::uint8_t> blank(kCensusPlanes * static_cast<std::size_t>(row.row().plane_bytes), 5);
  Row plain_row = row.row();
  plain_row.left = plain_row.right_reversed = blank.data();
  plain::match_row(plain_row);
  for (int x = 3; x < 120; ++x) EXPECT_EQ(row.best[static_cast<std::size_t>(x)], kAmbiguous) << "column " << x;
}

}  // namespace
}  // namespace weft::agents::semi_global
