#pragma once
#include <string>

#include "clients/cli/json.hpp"
#include "clients/cli/session.hpp"
#include "core/ids.hpp"

namespace weft::cli {

/// Returns the names of the runs that the map has now. Errors as of `Session::query`.
Result<RunNames> query_run_names(Session& session, Duration at_most);

/// Returns the run's name, with the beginning of its id if another run shares the name; without a name that
/// beginning.
std::string shown_run(ExperienceId run, const RunNames& names);

}  // namespace weft::cli
