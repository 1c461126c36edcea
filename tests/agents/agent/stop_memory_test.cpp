#include "agents/agent/stop_memory.hpp"

#include <gtest/gtest.h>

#include "storage/spool/memory_spool.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

TEST(StopMemory, WhatADiskRefusesIsSaidOnceAndTriedAgain) {
  const auto disk = std::make_shared<storage::SpoolDisk>();
  const auto spool = storage::make_memory_spool(disk);
  StopMemory memory(*spool);
  const storage::Stops stops{.by_operator = true, .by_emergency_stop = false};
  const SteadyTime now{10s};
  disk->faults.full = true;
  EXPECT_NE(memory.keep(stops, now).find("goes on by itself"), std::string::npos);
  EXPECT_EQ(memory.keep(stops, now + 1s), "");
  disk->faults.full = false;
  EXPECT_EQ(memory.keep(stops, now + 1500ms), "");
  EXPECT_EQ(memory.kept(), storage::Stops{}) << "not each time that something happens";
  EXPECT_EQ(memory.keep(stops, now + 2s), "");
  EXPECT_EQ(memory.kept(), stops);
  EXPECT_EQ(StopMemory(*storage::make_memory_spool(disk)).kept(), stops);
  disk->faults.full = true;
  EXPECT_NE(memory.keep({}, now + 3s).find("resumed once more"), std::string::npos);
}

}  // namespace
}  // namespace weft::agents::test
