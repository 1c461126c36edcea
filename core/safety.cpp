#include "core/safety.hpp"

namespace weft {

const char* to_string(Safety safety) {
  switch (safety) {
    case Safety::ok:
      return "ok";
    case Safety::protective_stop:
      return "protective_stop";
    case Safety::emergency_stop:
      return "emergency_stop";
    case Safety::speed_limited:
      return "speed_limited";
    case Safety::blocked:
      return "blocked";
  }
  return "unknown";
}

bool is_stop(Safety safety) {
  return safety == Safety::protective_stop || safety == Safety::emergency_stop;
}

}  // namespace weft
