#pragma once
#include "agents/methods/content_bytes.hpp"
#include "agents/perception/birds_eye.hpp"
#include "agents/perception/camera_model.hpp"

namespace weft::agents {

/// Write what contents of several methods have in common: the camera that saw them, and a rectified patch.
void write_camera(ContentWriter& out, const CameraModel& camera);
void write_patch(ContentWriter& out, const PlanePatch& patch);

/// Read the same; the reader collects the first fault. A patch has at most `widest_px` on each side.
CameraModel read_camera(ContentReader& in);
PlanePatch read_patch(ContentReader& in, int widest_px);

}  // namespace weft::agents
