#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "agents/agent/process/options.hpp"
#include "agents/bodies/body.hpp"
#include "agents/navigation/navigator.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// The body that the options name. Errors are the body's own: no such file, site, recording or robot in it.
Result<std::unique_ptr<Body>> make_body(const Options& options, const std::function<void(const std::string&)>& warn);

/// Pairs a camera of the body with the method that looks through it.
struct Equipped {
  std::string method;
  CameraModel camera;
};

/// The methods that the options name, each with its camera: of a body that has several, the one that looks where the
/// method wants to. The calibration file of the options is the first one's; its mount is the body's when the file has
/// none. not_found, invalid: of the file; its images would be of another size; no camera looks there.
Result<std::vector<Equipped>> make_cameras(const Options& options, const Body& body,
                                           const std::function<void(const std::string&)>& warn);

/// One navigator for all of that. invalid: a calibration or a setting of a method breaks its bound.
Result<std::unique_ptr<Navigator>> make_navigator(const Options& options, const std::vector<Equipped>& equipped);

}  // namespace weft::agents
