#pragma once
#include "agents/perception/calibration/board.hpp"
#include "agents/perception/camera_model.hpp"
#include "tests/agents/agent/process/folder.hpp"

/// Makes image files for what calibrates cameras. Apart, because messages and OpenCV both have an `Event`.
namespace weft::agents::test {

/// Writes `count` images of the board, tilted up to `tilt_rad`, one that shows none, and a file that is no image.
void take_images(const Folder& folder, const ChessBoard& board, const CameraModel& camera, int count,
                 double tilt_rad);

/// Returns the picture's width in pixels; 0: no picture.
int width_of(const std::string& picture);

}  // namespace weft::agents::test
