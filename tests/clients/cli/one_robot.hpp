#pragma once
#include <chrono>

#include "tests/clients/cli/fleet.hpp"

namespace weft::cli::test {

/// Arranges a robot on the first loop that knows where it is.
struct OneRobot : Fleet {
  OneRobot() : r1(add_robot("r1")) {
    r1.state.localised = true;
    r1.state.place = {first, 4};
    run(std::chrono::seconds(1));
  }
  Puppet& r1;
};

}  // namespace weft::cli::test
