#pragma once
#include <functional>
#include <optional>
#include <string>

#include "core/ids.hpp"
#include "core/result.hpp"
#include "idl/bus/link.hpp"
#include "tests/containers/light/options.hpp"

namespace weft::light {

/// Opens the bus of an agent and waits until its link is there, asking `stop` now and then; no link: `stop` held
/// first.
Result<std::optional<bus::Link>> open_link(const Options& options, const RobotId& self,
                                           const std::function<bool()>& stop,
                                           const std::function<void(const std::string&)>& warn);

}  // namespace weft::light
