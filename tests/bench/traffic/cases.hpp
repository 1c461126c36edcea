#pragma once
#include <ostream>

namespace weft::bench {

/// Plays each case in which robots come to stand, and tells what became of it. Returns the program's exit code: 1
/// when one stands that driving can end, or when one that it cannot is not named.
int tell_cases(std::ostream& out, bool json);

}  // namespace weft::bench
