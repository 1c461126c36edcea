#pragma once
#include "agents/agent/process/program.hpp"

namespace weft::agents {

/// Does what the command line says, and returns the exit code. Throws nothing.
int run_program(const Program& program, int argc, const char* const* argv) noexcept;

}  // namespace weft::agents
