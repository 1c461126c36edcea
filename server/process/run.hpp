#pragma once
#include "core/result.hpp"
#include "server/process/options.hpp"

namespace weft::server {

/// Runs the process after its options are read: opens store and bus, serves until SIGINT or SIGTERM. An error is the
/// reason for which it could not start or had to end.
Result<void> run(const Options& options);

}  // namespace weft::server
