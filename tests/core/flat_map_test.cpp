#include "core/flat_map.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "core/random.hpp"

namespace weft {
namespace {

using Flat = FlatMap<int, std::string>;

std::vector<std::pair<int, std::string>> walked(const Flat& flat) {
  std::vector<std::pair<int, std::string>> all;
  for (const auto& [key, value] : flat) all.emplace_back(key, value);
  return all;
}

TEST(FlatMap, HoldsWhatAnOrdinaryMapHolds) {
  Random random(5);
  for (int round = 0; round < 50; ++round) {
    Flat flat;
    std::map<int, std::string> plain;
    for (int step = 0; step < 60; ++step) {
      const int key = static_cast<int>(random.below(30));
      const std::string value = std::to_string(random.below(1000));
      if (random.chance(0.4)) {
        EXPECT_EQ(flat.emplace(key, value), plain.emplace(key, value).second);
      } else if (random.chance(0.7)) {
        flat.insert_or_assign(key, value);
        plain.insert_or_assign(key, value);
      } else {
        const std::vector<int> gone{key + 3, key, key, 99};
        flat.erase_all(gone);
        for (const int one : gone) plain.erase(one);
      }
    }
    const std::vector<std::pair<int, std::string>> expected(plain.begin(), plain.end());
    EXPECT_EQ(walked(flat), expected);
    for (int key = -1; key < 31; ++key) {
      const auto found = plain.find(key);
      const std::string* const value = flat.value(key);
      ASSERT_EQ(value != nullptr, found != plain.end());
      EXPECT_EQ(flat.contains(key), value != nullptr);
      if (value != nullptr) {
        EXPECT_EQ(*value, found->second);
      }
    }
  }
}

TEST(FlatMap, IsEqualByKeysAndValues) {
  Flat a;
  a.emplace(1, "one");
  a.emplace(2, "two");
  Flat b;
  b.emplace(2, "two");
  EXPECT_NE(a, b);
  b.emplace(1, "one");
  EXPECT_EQ(a, b);
  b.insert_or_assign(1, "other");
  EXPECT_NE(a, b);
}

}  // namespace
}  // namespace weft
