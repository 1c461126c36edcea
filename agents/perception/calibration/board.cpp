#include "agents/perception/calibration/board.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/aruco.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "agents/perception/opencv_view.hpp"

namespace weft::agents {
namespace {

constexpr std::size_t kFewestTags = 4;
constexpr int kTagsOfFamily = 587;

struct Tag {
  int id = 0;
  std::array<Eigen::Vector2d, 4> corners;  ///< clockwise in the image, from any of them
};

std::optional<Sighting> find_chessboard(const cv::Mat& grey, const ChessBoard& board) {
  std::vector<cv::Point2f> corners;
  const int flags = cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_ACCURACY;
  if (!cv::findChessboardCornersSB(grey, {board.columns, board.rows}, corners, flags)) return std::nullopt;
  Sighting out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const int row = static_cast<int>(i) / board.columns;
    const int column = static_cast<int>(i) % board.columns;
    out.on_board.emplace_back(column * board.square_m, row * board.square_m);
    out.pixels.emplace_back(corners[i].x, corners[i].y);
  }
  return out;
}

/// Refines a tag's corners, which the detector finds to a pixel or two. The window holds no bit but the tag's border:
/// on rendered boards errors were 0.1 px (Kalibr's, whose corners touch squares) and 0.3 px (plain tags); the
/// detector's own refinements by contours and by AprilTag's quads left 0.7 px and more.
void refine(const cv::Mat& grey, int bits_across, std::vector<cv::Point2f>& corners) {
  const double bit_px = cv::norm(corners[0] - corners[1]) / bits_across;
  const int half_window = std::max(3, static_cast<int>(std::lround(0.8 * bit_px)));
  cv::cornerSubPix(grey, corners, {half_window, half_window}, {-1, -1},
                   {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 50, 1e-3});
}

std::vector<Tag> find_tags(const cv::Mat& grey, int border_bits, int count) {
  const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_APRILTAG_36h11);
  const auto parameters = cv::aruco::DetectorParameters::create();
  parameters->markerBorderBits = border_bits;
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  cv::aruco::detectMarkers(grey, dictionary, corners, ids, parameters);
  std::vector<Tag> tags;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (ids[i] >= count || std::ranges::count(ids, ids[i]) > 1) continue;  // not of this board, or seen double
    Tag tag{ids[i], {}};
    refine(grey, 6 + 2 * border_bits, corners[i]);
    for (std::size_t k = 0; k < 4; ++k) tag.corners[k] = {corners[i][k].x, corners[i][k].y};
    tags.push_back(tag);
  }
  return tags;
}

/// Lays tags out as one way of printing a board has them: which of a tag's corners comes first, and whether the first
/// row is the upper one.
Sighting arranged(const std::vector<Tag>& tags, const TagBoard& board, std::size_t first_corner, bool first_row_up) {
  const double pitch = board.tag_m + board.gap_m;
  const std::array<Eigen::Vector2d, 4> square = {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(board.tag_m, 0.0),
                                                 Eigen::Vector2d(board.tag_m, board.tag_m),
                                                 Eigen::Vector2d(0.0, board.tag_m)};
  Sighting out;
  for (const Tag& tag : tags) {
    const int row = tag.id / board.columns;
    const Eigen::Vector2d at(pitch * (tag.id % board.columns), pitch * (first_row_up ? row : board.rows - 1 - row));
    for (std::size_t k = 0; k < 4; ++k) {
      out.on_board.push_back(at + square[(k + first_corner) % 4]);
      out.pixels.push_back(tag.corners[k]);
    }
  }
  return out;
}

/// Returns the RMS distance of pixels from where a plane's homography puts them, pixels; infinite when none is found.
/// A lens bends some pixels; a wrong arrangement is off by whole tags.
double bend_px(const Sighting& sighting) {
  std::vector<cv::Point2d> from;
  std::vector<cv::Point2d> to;
  for (std::size_t i = 0; i < sighting.pixels.size(); ++i) {
    from.emplace_back(sighting.on_board[i].x(), sighting.on_board[i].y());
    to.emplace_back(sighting.pixels[i].x(), sighting.pixels[i].y());
  }
  const cv::Mat found = cv::findHomography(from, to, 0);
  if (found.empty()) return std::numeric_limits<double>::infinity();
  const Eigen::Matrix3d homography = as_eigen(cv::Matx33d(found));
  double sum = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i)
    sum += ((homography * sighting.on_board[i].homogeneous()).hnormalized() - sighting.pixels[i]).squaredNorm();
  return std::sqrt(sum / static_cast<double>(from.size()));
}

double mean_side_px(const std::vector<Tag>& tags) {
  double sum = 0.0;
  for (const Tag& tag : tags) sum += (tag.corners[1] - tag.corners[0]).norm();
  return sum / static_cast<double>(tags.size());
}

std::optional<Sighting> find_tag_board(const cv::Mat& grey, const TagBoard& board) {
  const int count = board.columns * board.rows;
  std::vector<Tag> tags = find_tags(grey, 1, count);
  if (std::vector<Tag> kalibrs = find_tags(grey, 2, count); kalibrs.size() > tags.size()) tags = std::move(kalibrs);
  if (tags.size() < kFewestTags) return std::nullopt;
  std::optional<Sighting> best;
  double least_px = 0.25 * mean_side_px(tags);
  for (const bool first_row_up : {true, false}) {
    for (std::size_t first_corner = 0; first_corner < 4; ++first_corner) {
      Sighting candidate = arranged(tags, board, first_corner, first_row_up);
      const double px = bend_px(candidate);
      if (px >= least_px) continue;
      least_px = px;
      best = std::move(candidate);
    }
  }
  return best;
}

Result<void> size_within(double metres, const char* what) {
  if (metres >= 0.001 && metres <= 2.0) return {};
  return fail(ErrorCode::invalid, std::string("the board's ") + what + ", " + std::to_string(metres) +
                                      " m, is not within 0.001..2 m; give what is measured on the print");
}

Result<void> check_chess(const ChessBoard& board) {
  const auto inside = [](int n) { return n >= 3 && n <= 50; };
  if (!inside(board.columns) || !inside(board.rows))
    return fail(ErrorCode::invalid, "a chessboard has 3..50 inner corners a side; count where four squares meet");
  if (board.columns == board.rows)
    return fail(ErrorCode::invalid,
                "a chessboard with as many columns as rows looks the same when it is turned; take "
                "another one");
  return size_within(board.square_m, "square");
}

Result<void> check_tags(const TagBoard& board) {
  const auto inside = [](int n) { return n >= 1 && n <= 30; };
  const int count = board.columns * board.rows;
  if (!inside(board.columns) || !inside(board.rows) || count < static_cast<int>(kFewestTags) || count > kTagsOfFamily)
    return fail(ErrorCode::invalid, "a tag board has 1..30 columns and rows, and 4..587 tags in all");
  if (const Result<void> gap = size_within(board.gap_m, "gap between tags"); !gap) return gap;
  return size_within(board.tag_m, "tag");
}

}  // namespace

Result<void> check(const Board& board) {
  if (const auto* chess = std::get_if<ChessBoard>(&board)) return check_chess(*chess);
  return check_tags(std::get<TagBoard>(board));
}

std::optional<Sighting> find_board(const Image& image, const Board& board) {
  const cv::Mat grey = as_mat(image);
  try {
    if (const auto* chess = std::get_if<ChessBoard>(&board)) return find_chessboard(grey, *chess);
    return find_tag_board(grey, std::get<TagBoard>(board));
  } catch (const cv::Exception&) {
    return std::nullopt;  // images too small for the detectors' pyramids make them throw
  }
}

}  // namespace weft::agents
