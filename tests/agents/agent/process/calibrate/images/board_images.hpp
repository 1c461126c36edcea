#pragma once
#include "agents/perception/calibration/board.hpp"
#include "agents/perception/camera_model.hpp"
#include "tests/agents/agent/process/folder.hpp"

/// Image files for what calibrates cameras. Apart, because messages and OpenCV both have an `Event`.
namespace weft::agents::test {

/// `count` images of the board, tilted up to `tilt_rad`; one that shows none; one that is none.
void take_images(const Folder& folder, const ChessBoard& board, const CameraModel& camera, int count,
                 double tilt_rad);

/// Pixels across; 0: no picture.
int width_of(const std::string& picture);

}  // namespace weft::agents::test
