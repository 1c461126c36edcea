#pragma once
#include <string>

#include "agents/methods/all.hpp"

namespace weft::agents::test {

/// Returns the name of the first method that navigates by one camera which looks there; empty: there is none.
inline std::string method_that_looks(Gaze gaze) {
  std::string found;
  AllMethods::for_each([&]<class M>() {
    const SensorNeed need = M::needs;
    const bool is_one_camera = need.kind == SensorKind::camera && need.count == 1;
    if (found.empty() && is_one_camera && need.gaze == gaze) found = M::name;
  });
  return found;
}

}  // namespace weft::agents::test
