#pragma once
#include "core/protocol/messages.hpp"
#include "core/result.hpp"

namespace weft::cli {

/// Says what the command's exit code means. The numbers are frozen, as scripts rely on them.
enum class Exit : int { done = 0, failed = 1, usage = 2, unreached = 3, refused = 4, timed_out = 5 };

/// Return the exit code. Of the errors, unavailable: the server was not reached; timed_out: it did not answer.
Exit exit_of(const Error& error);
Exit exit_of(msg::Outcome outcome);

}  // namespace weft::cli
