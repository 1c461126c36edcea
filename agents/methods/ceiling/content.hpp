#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "agents/perception/attitude.hpp"
#include "agents/perception/birds_eye.hpp"
#include "agents/perception/camera_model.hpp"
#include "core/bytes.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Holds what `ceiling` stores of a place (docs/formats/ceiling-content.md): features of the view, each on the level
/// plane at its own height as the mount has it, with the calibration of the camera that saw them and the ceiling's
/// height, which is the scale.
struct CeilingContent {
  CameraModel camera;  ///< the view's; attitude has not been applied to the features
  Attitude attitude;   ///< estimated at the view
  Eigen::Vector3d attitude_sigma = Eigen::Vector3d::Zero();  ///< rad, rad, m; of the estimate against the truth
  double ceiling_m = 0.0;                                    ///< above the floor: where most features are
  double ceiling_sigma_m = 0.0;  ///< as stated or as wheels have told: how well the scale is known
  std::vector<PlaneFeature> features;
  PlanePatch patch;
};

inline constexpr std::uint32_t ceiling_content_format = 1;
inline constexpr std::size_t most_ceiling_features = 300;
inline constexpr int widest_ceiling_patch_px = 60;  ///< so that no content exceeds `largest_ceiling_content`
inline constexpr std::size_t largest_ceiling_content = 16384;  ///< bytes

/// Writes a content. It has at most `most_ceiling_features` features and a patch of at most
/// `widest_ceiling_patch_px`.
Bytes encode_ceiling_content(const CeilingContent& content);
/// Reads a content. corrupt: short, trailing, oversize or impossible values, naming field and offset; newer: a later
/// format.
Result<CeilingContent> decode_ceiling_content(ByteView bytes);

}  // namespace weft::agents
