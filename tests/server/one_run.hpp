#pragma once
#include <gtest/gtest.h>

#include <optional>

#include "tests/server/arranged_site.hpp"

namespace weft::server::test {

/// Arranges one run of 60 places, half a metre apart, that r1 has taught; r2 has not arrived yet.
struct OneRun : testing::Test {
  OneRun() {
    site.arrive(r1, std::nullopt);
    site.hand_in(r1, run.next(60));
  }

  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  Peer r2{.id = robot_id(2), .name = "r2"};
  TaughtRun run{r1, 10};
};

}  // namespace weft::server::test
