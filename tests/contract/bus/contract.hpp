#pragma once
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/contract/bus/fleet.hpp"

namespace weft::contract {

/// Runs each test once for each pairing of buses.
struct BusContract : testing::TestWithParam<Pairing> {
  Fleet fleet{GetParam()};
};

#define WEFT_ON_EACH_PAIRING(suite) \
  INSTANTIATE_TEST_SUITE_P(Each, suite, testing::ValuesIn(pairings()), [](const auto& of) { return of.param.name; })

}  // namespace weft::contract
