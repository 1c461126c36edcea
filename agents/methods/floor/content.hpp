#pragma once
#include <Eigen/Core>
#include <vector>

#include "agents/perception/attitude.hpp"
#include "agents/perception/birds_eye.hpp"
#include "agents/perception/camera_model.hpp"
#include "core/bytes.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Holds what `floor` stores of a place (docs/formats/floor-content.md): features rectified to the floor plane of the
/// mount, with the calibration of the camera that saw them, so that another robot's camera can be compared with them.
struct FloorContent {
  CameraModel camera;  ///< the view's; attitude has not been applied to the features
  Attitude attitude;   ///< estimated at the view
  Eigen::Vector3d attitude_sigma = Eigen::Vector3d::Zero();  ///< rad, rad, m; of the estimate against the truth
  std::vector<PlaneFeature> features;
  PlanePatch patch;
};

inline constexpr std::uint32_t floor_content_format = 1;
inline constexpr std::size_t most_floor_features = 4096;
inline constexpr int widest_floor_patch_px = 512;

Bytes encode_floor_content(const FloorContent& content);
/// Reads a content. corrupt: short, trailing or impossible values, naming field and offset; newer: a later format.
Result<FloorContent> decode_floor_content(ByteView bytes);

}  // namespace weft::agents
