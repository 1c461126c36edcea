#pragma once
#include <cstdint>
#include <string>

#include "tests/bench/traffic/load.hpp"

namespace weft::bench {

/// Prints the head of the table of loads.
void tell_load_head();
/// Prints what one load took: a table's rows, or a document of a line. `lanes` names them.
void tell_load(const LoadPlan& plan, const std::string& lanes, const Loaded& loaded, bool json);

}  // namespace weft::bench
