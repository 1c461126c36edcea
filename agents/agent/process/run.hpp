#pragma once
#include "agents/agent/process/options.hpp"
#include "agents/agent/process/program.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Runs one robot until SIGINT or SIGTERM; a body that fails later stands, and says so. Errors are those of the start
/// (invalid, not_found: a setting, or the file that one names, is wrong) and, at the end, corrupt: the body gave
/// damaged data, exhausted: records could not be written.
Result<void> run(const Program& program, const Options& options);

}  // namespace weft::agents
