#include "server/contents/content_sizes.hpp"

#include <gtest/gtest.h>

namespace weft::server {
namespace {

ContentHash content(std::uint8_t number) {
  ContentHash hash;
  hash.bytes[31] = number;
  return hash;
}

TEST(ContentSizes, AreThoseFromTheStartAndThoseThatCame) {
  ContentSizes sizes({{content(3), 30}, {content(1), 10}, {content(3), 30}, {content(2), 20}});
  EXPECT_EQ(sizes.find(content(1)), 10U);
  EXPECT_EQ(sizes.find(content(3)), 30U);
  EXPECT_FALSE(sizes.find(content(4)));
  sizes.add(content(4), 40);
  sizes.add(content(1), 10);
  EXPECT_EQ(sizes.find(content(4)), 40U);
  EXPECT_EQ(sizes.find(content(1)), 10U);
}

TEST(ContentSizes, GoAndMayComeBack) {
  ContentSizes sizes({{content(1), 10}, {content(2), 20}});
  sizes.add(content(3), 30);
  for (const ContentHash& hash : {content(1), content(3), content(9)}) sizes.erase(hash);
  EXPECT_FALSE(sizes.find(content(1)));
  EXPECT_FALSE(sizes.find(content(3)));
  EXPECT_EQ(sizes.find(content(2)), 20U);
  sizes.add(content(1), 11);
  EXPECT_EQ(sizes.find(content(1)), 11U);
}

}  // namespace
}  // namespace weft::server
