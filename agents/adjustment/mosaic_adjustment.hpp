#pragma once
#include <cstddef>
#include <vector>

#include "agents/adjustment/mosaic.hpp"
#include "agents/adjustment/window.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Bounds the pieces of an adjustment.
struct MosaicAdjustmentConfig {
  std::uint32_t window_places = 16;    ///< >= 4, even; windows overlap by half
  std::uint32_t graph_iterations = 3;  ///< >= 1, of the pose graph in one piece
  std::uint32_t graph_pieces = 10;     ///< >= 1, at most
  std::uint32_t points_each = 500;     ///< >= 1
};

/// Adjusts a mosaic in bounded pieces, in the place of Lucas et al.'s chain of homographies (II.D): windows of places
/// by what they sight, then all poses by windows and stitches, then each point by the poses. The first place stays
/// where it is. The result depends on the mosaic alone.
class MosaicAdjustment {
 public:
  /// Begins an adjustment. invalid: what `problem_of` names, neighbours that no link joins, or a bound of the
  /// configuration.
  static Result<MosaicAdjustment> make(Mosaic mosaic, const MosaicAdjustmentConfig& config = {});

  /// Does one piece; returns whether there are more.
  bool step();
  std::size_t done() const { return done_; }
  /// Returns how many pieces there are at most.
  std::size_t pieces() const { return most_pieces(mosaic_.places.size(), mosaic_.points.size(), config_); }
  /// Returns the same of any mosaic with so many places and points.
  static std::size_t most_pieces(std::size_t places, std::size_t points, const MosaicAdjustmentConfig& config = {});
  /// Returns the mosaic, as far as it is adjusted.
  const Mosaic& mosaic() const { return mosaic_; }

 private:
  MosaicAdjustment(Mosaic mosaic, const MosaicAdjustmentConfig& config);

  std::uint32_t window_begin(std::size_t window) const;
  void fit_next_window();
  void adjust_all_poses();
  void place_points();

  MosaicAdjustmentConfig config_;
  Mosaic mosaic_;
  MosaicIndex index_;
  std::vector<MosaicLink> stitches_;
  std::vector<WindowFit> windows_;
  std::size_t graph_pieces_ = 0;
  bool is_graph_done_ = false;
  std::uint32_t points_ = 0;  ///< placed
  std::size_t done_ = 0;
};

}  // namespace weft::agents
