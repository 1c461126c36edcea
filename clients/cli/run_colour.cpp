#include "clients/cli/run_colour.hpp"

namespace weft::cli {

const Colour& run_colour(ExperienceId run) {
  // The finaliser of splitmix64: ids that differ in one bit look different.
  std::uint64_t bits = run.value;
  bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EBULL;
  bits ^= bits >> 31U;
  return kRunColours[bits % kRunColours.size()];
}

}  // namespace weft::cli
