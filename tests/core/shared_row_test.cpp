#include "core/shared_row.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <string>

namespace weft {
namespace {

using Numbers = SharedRow<std::string>;

std::vector<std::string> count(std::size_t from, std::size_t to) {
  std::vector<std::string> numbers;
  for (std::size_t i = from; i < to; ++i) numbers.push_back(std::to_string(i));
  return numbers;
}

std::vector<std::string> read(const Numbers& row) {
  return {row.begin(), row.end()};
}

TEST(SharedRow, IsWhatWasAppendedInWhateverPortions) {
  for (const std::size_t portion : {1U, 7U, 255U, 256U, 257U, 1000U}) {
    Numbers row;
    for (std::size_t at = 0; at < 1000; at += portion)
      row.append(count(at, std::min<std::size_t>(1000, at + portion)));
    ASSERT_EQ(row.size(), 1000U);
    EXPECT_EQ(read(row), count(0, 1000)) << portion;
    EXPECT_EQ(row.front(), "0");
    EXPECT_EQ(row.back(), "999");
    EXPECT_EQ(row, Numbers(count(0, 1000)));
  }
  EXPECT_TRUE(Numbers().empty());
  EXPECT_NE(Numbers(count(0, 3)), Numbers(count(0, 4)));
}

TEST(SharedRow, CopiesShareFullChunksAndLeaveEachOtherAlone) {
  const Numbers before(count(0, 600));
  Numbers after = before;
  after.append(count(600, 700));
  after.push_back("700");
  EXPECT_EQ(read(before), count(0, 600));
  EXPECT_EQ(read(after), count(0, 701));
  EXPECT_EQ(&before[0], &after[0]);
  EXPECT_EQ(&before[511], &after[511]);
  EXPECT_NE(&before[512], &after[512]) << "the chunk that was not full";
}

TEST(SharedRow, ReplacesWithoutTouchingItsCopies) {
  const Numbers before(count(0, 600));
  Numbers after = before;
  after.replace({{0, "a"}, {255, "b"}, {599, "c"}});
  std::vector<std::string> expected = count(0, 600);
  expected[0] = "a";
  expected[255] = "b";
  expected[599] = "c";
  EXPECT_EQ(read(after), expected);
  EXPECT_EQ(read(before), count(0, 600));
  EXPECT_EQ(&before[300], &after[300]) << "a chunk without any stays shared";
}

TEST(SharedRow, ErasesInTheMiddle) {
  const Numbers before(count(0, 1000));
  Numbers after = before;
  after.erase_if([](const std::string& number) { return number == "300" || number == "301" || number == "999"; });
  std::vector<std::string> expected = count(0, 999);
  expected.erase(expected.begin() + 300, expected.begin() + 302);
  EXPECT_EQ(read(after), expected);
  EXPECT_EQ(&before[255], &after[255]) << "what lies before is shared";
  EXPECT_EQ(read(before), count(0, 1000));
  after.erase_if([](const std::string&) { return true; });
  EXPECT_TRUE(after.empty());
  after.push_back("again");
  EXPECT_EQ(after.back(), "again");
}

TEST(SharedRow, IsSearchedLikeAnyOtherRow) {
  SharedRow<int> row;
  std::vector<int> numbers(1000);
  std::iota(numbers.begin(), numbers.end(), 0);
  row.append(numbers);
  const auto found = std::ranges::lower_bound(row, 700);
  EXPECT_EQ(*found, 700);
  EXPECT_EQ(found - row.begin(), 700);
  EXPECT_EQ(row.begin()[3], 3);
  EXPECT_EQ(*(row.end() - 1), 999);
  EXPECT_LT(row.begin(), row.end());
}

TEST(SharedItems, AreSortedThinnedAndSharedWithoutCopies) {
  SharedItems<std::string> row;
  for (const char* text : {"c", "a", "b"}) row.push_back(std::make_shared<const std::string>(text));
  SharedItems<std::string> sorted = row;
  sorted.sort(std::less<>());
  EXPECT_EQ(std::vector<std::string>(sorted.begin(), sorted.end()), (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(row[0], "c");
  EXPECT_EQ(&sorted[2], &row[0]);
  sorted.erase_if([](const std::string& text) { return text == "b"; });
  EXPECT_EQ(sorted.size(), 2U);
  EXPECT_EQ(row.size(), 3U);
}

}  // namespace
}  // namespace weft
