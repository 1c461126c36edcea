#pragma once
#include "agents/agent/process/program.hpp"

namespace weft::agents {

/// Makes the body of a robot of a simulated site.
Result<std::unique_ptr<Body>> make_simulated_body(const Options& options, const Warn& warn);

inline constexpr BodyKind kSimulatedBody = {kSimulated, make_simulated_body};

}  // namespace weft::agents
