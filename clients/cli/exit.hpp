#pragma once
#include "core/protocol/messages.hpp"
#include "core/result.hpp"

namespace weft::cli {

/// The meaning of the command's exit code; frozen, scripts rely on it.
enum class Exit : int { done = 0, failed = 1, usage = 2, unreached = 3, refused = 4, timed_out = 5 };

/// unavailable: the server was not reached; timed_out: it was, and did not answer.
Exit exit_of(const Error& error);
Exit exit_of(msg::Outcome outcome);

}  // namespace weft::cli
