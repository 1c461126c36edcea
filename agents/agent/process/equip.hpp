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

/// Holds a method, and the sensors of the body that it looks through.
struct Equipped {
  std::string method;
  Rig rig;
};

/// Returns the methods that the options name, each with the first sensors that are what it needs and that no method
/// before it took. The calibration file of the options is that of the first method's sensor or, where --camera names
/// several sensors, has all of them by these names; a mount is the body's when the file has none. not_found, invalid:
/// of the file; its images would be of another size; the body lacks a sensor.
Result<std::vector<Equipped>> equip(const Options& options, const Body& body,
                                    const std::function<void(const std::string&)>& warn);

/// Returns one navigator for all of that. `rig`: all that the body has. invalid: a calibration or a setting of a
/// method breaks its bound.
Result<std::unique_ptr<Navigator>> make_navigator(const Options& options, const std::vector<Equipped>& equipped,
                                                  const Rig& rig);

}  // namespace weft::agents
