#pragma once
#include <gtest/gtest.h>

#include <optional>

#include "tests/server/arranged_site.hpp"

namespace weft::server::test {

/// Arranges a straight run, and a bypass that leaves it at place 10 and joins it again at place 20.
struct RunWithBypass : testing::Test {
  RunWithBypass() {
    site.arrive(r1, std::nullopt);
    site.hand_in(r1, run.next(40));
    Handed aside = bypass.next(6);
    aside.batch.edges.push_back(stitch(run.place(10), bypass.place(0), 0.0, 1.5));
    aside.batch.edges.push_back(stitch(run.place(20), bypass.place(5), 0.0, 1.5));
    site.hand_in(r1, aside);
    site.label("dock", run.place(39));
    site.hush();
  }

  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  TaughtRun run{r1, 10};
  TaughtRun bypass{r1, 11};
};

}  // namespace weft::server::test
