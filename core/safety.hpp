#pragma once
#include <cstdint>

namespace weft {

/// Tells what a body's rated safety functions do with it. They work without Weft, which obeys them.
enum class Safety : std::uint8_t {
  ok = 1,
  protective_stop = 2,  ///< a scanner or bumper holds it; it goes on when its base allows
  emergency_stop = 3,   ///< goes on only after a person's `weft resume`
  speed_limited = 4,    ///< its base drives more slowly than asked
  blocked = 5           ///< no word of its base: it is asked to drive, and does not move
};
const char* to_string(Safety safety);

/// Returns whether the base does not drive, whatever it is asked.
bool is_stop(Safety safety);

}  // namespace weft
