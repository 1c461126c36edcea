#pragma once
#include <functional>
#include <memory>
#include <string>

#include "agents/agent/process/options.hpp"
#include "agents/bodies/body.hpp"
#include "agents/navigation/navigator.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// The body that the options name. Errors are the body's own: no such file, site, recording or robot in it.
Result<std::unique_ptr<Body>> make_body(const Options& options, const std::function<void(const std::string&)>& warn);

/// What is known of the body's camera: the calibration file of the options, where there is one; its mount is the
/// body's when the file has none. not_found, invalid: of the file; its images would be of another size. `known`, if
/// not null: how well, as the file says.
Result<CameraModel> make_camera(const Options& options, const Body& body,
                                const std::function<void(const std::string&)>& warn,
                                CalibrationSigma* known = nullptr);

/// The navigator of the method that the options name, for that camera.
/// invalid: the calibration or a setting of the method breaks its bound.
Result<std::unique_ptr<Navigator>> make_navigator(const Options& options, const CameraModel& camera);

}  // namespace weft::agents
