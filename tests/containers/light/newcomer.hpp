#pragma once
#include <functional>

#include "core/result.hpp"
#include "tests/containers/light/options.hpp"

namespace weft::light {

/// Greets the server twice a second as an agent that speaks protocol `options.protocol` alone, until `stop` holds.
/// Errors are those of opening the link.
Result<void> run_newcomer(const Options& options, const std::function<bool()>& stop);

}  // namespace weft::light
