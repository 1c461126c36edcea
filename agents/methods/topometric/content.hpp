#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "agents/perception/clouds/cloud_window.hpp"
#include "agents/perception/hamming.hpp"
#include "agents/perception/scan.hpp"
#include "agents/perception/stereo/stereo_rig.hpp"
#include "core/bytes.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Holds a corner that both images of a pair show, in the frame of the place.
struct SpaceFeature {
  Eigen::Vector3f in_place = Eigen::Vector3f::Zero();
  float depth_sigma_m = 0.0F;  ///< along its ray
  Descriptor descriptor{};
};

/// Holds the floor that a place stands on, as its cloud shows it. The frame of a place is level and its z is 0 on
/// that floor, so this says how the odometry's frame leaned.
struct FloorSeen {
  Pose3 level_from_odometry;  ///< of the robot's frame as odometry had it: roll, pitch, height
  std::uint32_t points = 0;   ///< that lie on it; 0: no floor was seen, the frame is odometry's
};

/// Holds what `topometric` stores of a place (docs/formats/topometric-content.md): the cloud of the last frames with
/// the frame that saw each point, and up to `most_space_features` features. All in the frame of the place: level, z
/// above the floor, x ahead.
struct TopometricContent {
  PlaceCloud cloud;
  StereoRig rig;  ///< that saw it, rectified: focal length, baseline and where the camera was
  std::vector<SpaceFeature> features;
  FloorSeen floor;
  float clear_m = 0.0F;  ///< as far as bearings of frames are clear that are marked so
  /// Shows the newest view alone, for who looks for the place; not stored.
  std::optional<Scan> scan = {};
};

inline constexpr std::uint32_t topometric_content_format = 1;
inline constexpr std::size_t most_space_features = 300;
inline constexpr std::uint32_t cloud_quantum_um = 5000;

/// Returns a cloud (docs/formats/cloud.md) with all else attached. Points are kept within half of cloud_quantum_um.
Bytes encode_topometric_content(const TopometricContent& content);
/// corrupt: short, trailing or impossible values, naming field and offset; newer: a later format.
Result<TopometricContent> decode_topometric_content(ByteView bytes);

}  // namespace weft::agents
