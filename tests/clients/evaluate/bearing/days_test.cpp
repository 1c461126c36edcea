#include "clients/evaluate/bearing/days.hpp"

#include <gtest/gtest.h>

#include <iostream>
#include <set>

#include "clients/evaluate/bearing/learning.hpp"

namespace weft::evaluate::bearing {
namespace {

agents::sim::Site on(const std::string& name, std::size_t day) {
  agents::sim::Site site;
  site.lamps.resize(4);
  for (const Days& days : all_days())
    if (days.name == name) days.days.at(day).as(site);
  return site;
}

TEST(BearingDays, AreNamedOnce) {
  std::set<std::string> names;
  for (const Days& days : all_days()) {
    EXPECT_TRUE(names.insert(days.name).second);
    EXPECT_FALSE(days.days.empty());
  }
}

TEST(BearingDays, StockChangesOnTopOfWhatHasChanged) {
  EXPECT_EQ(on("same", 3).change.stock, 0.0);
  for (int day = 0; day < 3; ++day) {
    const agents::sim::Site site = on("stock", static_cast<std::size_t>(day));
    EXPECT_EQ(site.change.stock, 0.3);
    EXPECT_EQ(site.change.stock_times, day + 1);
    EXPECT_EQ(site.lamps.size(), 4U);
  }
  EXPECT_EQ(on("stock-dark", 1).change.lamps_failed, 1.0);
  EXPECT_EQ(on("stock-dark", 1).change.stock_times, 2);
  EXPECT_EQ(on("day-dark", 0).change.lamps_failed, 1.0);
  EXPECT_EQ(on("day-dark", 1).change.lamps_failed, 0.0);
}

TEST(BearingDays, AWrongNameListsThem) {
  LearningOptions options;
  options.days = "sunday";
  const Surroundings around{std::cout, std::cerr, [] { return 0.0; }, [] { return false; }};
  const auto ended = study_learning(options, around);
  ASSERT_FALSE(ended);
  EXPECT_NE(ended.error().message.find("same, stock"), std::string::npos) << ended.error().message;
}

}  // namespace
}  // namespace weft::evaluate::bearing
