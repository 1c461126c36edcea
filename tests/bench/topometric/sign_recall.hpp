#pragma once
#include "tests/bench/topometric/place_runs.hpp"

namespace weft::bench {

/// Prints how often the right place is among the likeliest by signature, of all sites' places together: signatures as
/// numbers, and as the codes of four bits that the server compares. Beside it what chance would find.
void print_sign_recall(const PlaceRuns& runs);

}  // namespace weft::bench
