#pragma once
#include <optional>
#include <vector>

#include "agents/perception/camera_model.hpp"
#include "agents/perception/planar_motion.hpp"
#include "agents/perception/view.hpp"

namespace weft::agents {

struct DirectConfig {
  int coarsest = 3;  ///< level that is begun with; halvings
  int finest = 1;    ///< and ended with
  int columns = 44;  ///< of the grid over a level; each cell gives its strongest pixel
  int rows = 28;
  double least_grey = 1.5;     ///< change of grey level over two pixels below which a pixel says nothing
  double above_floor_m = 0.0;  ///< of the plane that is seen
};

struct DirectFit {
  PlanarFit fit;           ///< of grey levels; residual_px is empty
  double correlation = 0;  ///< of both views' grey values at the points, finest level, [-1, 1]
  std::size_t points = 0;  ///< of a that lie in b, finest level
};

/// Finds the motion under which two views of a plane have the same grey values, without corners: Gauss-Newton from
/// coarse to fine over pixels with a gradient, linearised in a (Baker & Matthews 2004, inverse compositional), Huber
/// weights, all six degrees of freedom under the prior. Brightness that changes slowly over the image (vignetting,
/// lamps) is taken out of both first. The start must be right to some pixels of the coarsest level. Works on blurred
/// and pale floors that leave no corners. Both images are whole and of the camera's size.
DirectFit align_directly(const CameraModel& camera, const Image& a, const Image& b, const AttitudePrior& prior,
                         const PlanarState& start, const DirectConfig& config);

/// Returns the same where both views agree so well that it is the motion; none: they do not correlate.
std::optional<DirectFit> agreed_directly(const CameraModel& camera, const Image& a, const Image& b,
                                         const AttitudePrior& prior, const PlanarState& start,
                                         const DirectConfig& config);

}  // namespace weft::agents
