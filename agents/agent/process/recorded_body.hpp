#pragma once
#include "agents/agent/process/program.hpp"

namespace weft::agents {

/// Makes the body that plays a recording, mounted as a --calibration or the options say.
Result<std::unique_ptr<Body>> make_recorded_body(const Options& options, const Warn& warn);

inline constexpr BodyKind kRecordedBody = {"replay", make_recorded_body};

}  // namespace weft::agents
