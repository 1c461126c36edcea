#pragma once
#include <ostream>

namespace weft::bench {

/// Plays each case in which robots come to stand, and tells what became of it. Returns the program's exit code: what
/// cannot be resolved today is told, and no failure.
int tell_cases(std::ostream& out, bool json);

}  // namespace weft::bench
