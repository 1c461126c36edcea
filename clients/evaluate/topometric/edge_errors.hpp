#pragma once
#include <vector>

#include "clients/evaluate/topometric/taught.hpp"

/// Judges the edges of a taught map. All pure.
namespace weft::evaluate::topometric {

/// Holds how far edges between places kept one after the other lie off the truth, after their contents were compared
/// and before; of those that this has changed. Metres.
struct EdgeErrors {
  std::vector<double> along_m, along_before_m;  ///< in the direction of travel
  std::vector<double> across_m, across_before_m;
  double grew = 0.0;  ///< edges whose error is larger by more than 1 cm
  double edges = 0.0;
};
EdgeErrors chain_errors(const Taught& taught);

/// Returns how far the stitches between runs are off.
struct StitchErrors {
  std::vector<double> metres;
  std::vector<double> radians;
  double wrong = 0.0;  ///< of these and of those within a run: by more than 0.15 m or 4 degrees
};
StitchErrors stitch_errors(const Taught& taught);

/// Counts edges over ways on which nothing was seen for 0.1 m or more that do not say so.
double unmarked_blind_edges(const Taught& taught);

}  // namespace weft::evaluate::topometric
