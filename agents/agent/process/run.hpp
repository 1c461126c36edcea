#pragma once
#include "agents/agent/process/options.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Runs one robot until SIGINT or SIGTERM. Errors are of the start only; a body that fails later stands, and says so.
Result<void> run(const Options& options);

}  // namespace weft::agents
