#pragma once
#include <cstdint>
#include <vector>

#include "agents/perception/stereo/census.hpp"

namespace weft::agents {

/// Tells where an image has texture along its rows, which is what a pair is matched by: the root mean square over
/// 11x11 pixels of Sobel's horizontal gradient of the image blurred over 3x3 is at least a bound. A plain wall has
/// none there; a dense matcher invents 30 % of its disparities. Rows are taken from the top on, and told of five
/// later.
class TextureGate {
 public:
  /// `least_rms`: in what Sobel's kernel gives, eight times the grey levels a pixel.
  TextureGate(int width, int height, double least_rms);

  /// Takes the next row.
  void take(const FiveRows& rows);
  /// Returns the next row that is known: 1 where there is texture, else 0; null: not yet. To be asked after each row,
  /// and five times after the last.
  const std::uint8_t* told();

 private:
  static constexpr int kWindow = 11;

  void close_row();

  int width_;
  int height_;
  double least_;   // mean square in a window, in units of the squares
  int taken_ = 0;  // rows
  int told_ = 0;
  std::vector<std::int32_t> vertical_;     // of the row that is taken: the blur and Sobel's weights down the columns
  std::vector<std::uint32_t> squares_;     // of the last kWindow rows
  std::vector<std::uint32_t> columns_;     // their sums
  std::vector<std::uint32_t> sums_;        // of columns_, from the left
  std::vector<std::uint8_t> is_textured_;  // the row that is told
};

}  // namespace weft::agents
