#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "agents/perception/view.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Describes a flat board of black and white squares with `columns` x `rows` inner corners.
struct ChessBoard {
  int columns = 9;  ///< [3, 50], and not equal to rows: which way is up would be unknown
  int rows = 6;     ///< [3, 50]
  double square_m = 0.025;
};

/// Describes a flat grid of AprilTags of the family 36h11, numbered from 0 along the rows; the first row may be the
/// upper or the lower one, the border one bit wide (AprilTag) or two (Kalibr's AprilGrid).
struct TagBoard {
  int columns = 6;  ///< [1, 30]
  int rows = 6;     ///< [1, 30], 4 to 587 tags
  double tag_m = 0.088;
  double gap_m = 0.0264;  ///< between two tags
};
using Board = std::variant<ChessBoard, TagBoard>;

/// Rejects a board with a number that breaks its bound (invalid); sizes are [0.001, 2] m.
Result<void> check(const Board& board);

/// Holds the points of a board and where one image shows them.
struct Sighting {
  std::vector<Eigen::Vector2d> on_board;  ///< metres, in the board's plane
  std::vector<Eigen::Vector2d> pixels;    ///< the centre of the first pixel at (0, 0)
};

/// Finds the board. None: the image does not show the whole chessboard, or fewer than 4 tags that lie as the board
/// has them. Whole images only (`is_whole`).
std::optional<Sighting> find_board(const Image& image, const Board& board);

}  // namespace weft::agents
