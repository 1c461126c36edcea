#pragma once
#include <functional>
#include <memory>

#include "core/result.hpp"
#include "tests/containers/light/options.hpp"
#include "tests/simulation/site.hpp"

namespace weft::light {

/// Runs one light robot until `stop` holds: the product's agent, spool, loop and link, a body that sees marks. Errors
/// are those of the start and, at the end, exhausted: records could not be written.
Result<void> run_robot(const Options& options, const std::shared_ptr<const simulation::Site>& site,
                       std::size_t number, const std::function<bool()>& stop);

/// Makes the site that all processes of a fleet share.
std::shared_ptr<const simulation::Site> site_of(const Options& options);

/// Writes a line for each robot of the process, as `weft teach --along` takes it, with "# label station-K" after the
/// point at a station. Two robots that are taught theirs make the whole map. unavailable: a file cannot be written.
Result<void> write_lines(const Options& options);

}  // namespace weft::light
