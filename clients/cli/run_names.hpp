#pragma once
#include <map>
#include <string>

#include "clients/cli/session.hpp"
#include "core/ids.hpp"

namespace weft::cli {

/// Names of runs (experiences); runs that have none are missing.
using RunNames = std::map<ExperienceId, std::string>;

/// Returns the names of the runs that the map has now. Errors as of `Session::query`.
Result<RunNames> query_run_names(Session& session, Duration at_most);

/// Returns the run's name, with the beginning of its id if another run shares the name; without a name that
/// beginning.
std::string shown_run(ExperienceId run, const RunNames& names);

}  // namespace weft::cli
