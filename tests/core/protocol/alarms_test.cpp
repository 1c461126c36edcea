#include "core/protocol/alarms.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

namespace weft::msg {
namespace {

TEST(Alarms, EachKindHasItsTexts) {
  std::set<std::string> names;
  for (const AlarmText& text : alarm_texts()) {
    EXPECT_EQ(&text_of(text.kind), &text);
    EXPECT_TRUE(names.insert(text.name).second) << text.name;
    EXPECT_FALSE(std::string(text.cause).empty() || std::string(text.cure).empty()) << text.name;
  }
  EXPECT_EQ(alarm_texts().size(), static_cast<std::size_t>(AlarmKind::deaf)) << "the last one";
}

TEST(Alarms, OperatingRepeatsEachOfThem) {
  std::ifstream file(WEFT_OPERATING_DOCUMENT);
  const std::string document{std::istreambuf_iterator<char>(file), {}};
  ASSERT_FALSE(document.empty()) << WEFT_OPERATING_DOCUMENT;
  for (const AlarmText& text : alarm_texts()) {
    const std::string row = std::string("| `") + text.name + "` | " + text.cause + " | " + text.cure + " |";
    EXPECT_NE(document.find(row), std::string::npos) << "docs/operating.md has no row\n" << row;
  }
}

}  // namespace
}  // namespace weft::msg
