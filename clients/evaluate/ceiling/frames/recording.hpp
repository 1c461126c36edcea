#pragma once
#include <filesystem>
#include <vector>

#include "agents/perception/camera_model.hpp"
#include "agents/perception/view.hpp"
#include "core/geometry/pose2.hpp"
#include "core/result.hpp"

/// Studies how well the method `ceiling` sees recordings of a real ceiling.
namespace weft::evaluate::ceiling {

/// Bounds the frames of a recording: each is kept in memory.
inline constexpr std::size_t kMostFrames = 2000;

/// Holds a recording of a camera that looks up.
struct Recording {
  agents::CameraModel camera;  ///< looks straight up: how it leans is not stated
  double away_m = 0.0;         ///< from the camera up to the ceiling
  std::vector<agents::Image> frames;
  /// Holds where another tracker says that the camera was at each frame: metres, in a frame of its own. It is not the
  /// truth.
  std::vector<Pose2> golden_from_camera;
};

/// Returns a camera that looks straight up, its image's bottom ahead, `kRecordedMountM` above the floor.
agents::CameraModel straight_up(agents::CameraModel camera);
inline constexpr double kRecordedMountM = 0.1;

/// Reads DIR/ceiling.toml, DIR/frames_*.raw.gz and DIR/golden_*.txt, one of each. not_found: one of them is missing;
/// invalid: there are several, or a key, a row or a number of rows breaks its bound; corrupt: the frames are no gzip
/// file, or end within a frame. Each names file, what and bound.
Result<Recording> read_recording(const std::filesystem::path& folder);

}  // namespace weft::evaluate::ceiling
