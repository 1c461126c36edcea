#pragma once
#include <string>

#include "core/camera/camera_file.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Reads a camera's calibration. not_found: no such file; else as parse_camera_file.
Result<CameraFile> read_camera_file(const std::string& file, const std::string& camera);

}  // namespace weft::agents
