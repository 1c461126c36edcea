#include "storage/clouds/gaps.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "core/random.hpp"

namespace weft::clouds {
namespace {

Bytes bytes_of(const std::vector<std::uint64_t>& codes) {
  Bytes bytes(codes.size() * 8);
  if (!codes.empty()) std::memcpy(bytes.data(), codes.data(), bytes.size());
  return bytes;
}

void expect_back(const std::vector<std::uint64_t>& codes) {
  const Bytes bytes = bytes_of(codes);
  const auto gaps = gaps_from_codes(bytes);
  ASSERT_TRUE(gaps);
  Bytes back(bytes.size());
  ASSERT_TRUE(codes_from_gaps(gaps->tokens, gaps->tails, back.data()));
  EXPECT_EQ(back, bytes);
}

TEST(Gaps, TokensAreThoseOfTheDocument) {
  const auto gaps = gaps_from_codes(bytes_of({0, 3, 3 + 4, 7 + 7, 14 + 8, 22 + 15, (1ULL << 63U) - 1}));
  ASSERT_TRUE(gaps);
  // 4 = 2^2, 7 = 2^2 + 3, 8 = 2^3, 15 = 2^3 + 3 * 2 + 1; 2^63 - 38 = 2^62 + 3 * 2^60 + tail
  EXPECT_EQ(gaps->tokens, (Bytes{0, 3, 4, 7, 8, 11, 247}));
  EXPECT_EQ(gaps->tails.size(), 16U);  // 1 + 1 + 60 bits
  EXPECT_EQ(gaps->tails[0] & 3U, 2U);  // 0 of the 8, 1 of the 15
}

TEST(Gaps, AllLengthsComeBack) {
  expect_back({});
  expect_back({0});
  expect_back({5, 5, 5, 5});
  std::vector<std::uint64_t> powers;
  for (unsigned k = 0; k < 63; ++k) {
    for (const std::uint64_t offset : {0ULL, 1ULL, (1ULL << k) / 2, (1ULL << k) - 1}) {
      expect_back({(1ULL << k) + offset});
    }
    powers.push_back(1ULL << k);
  }
  expect_back(powers);
}

TEST(Gaps, TailsThatEndWithAWordAreReadWithinTheWords) {
  for (std::size_t pairs = 1; pairs <= 64; ++pairs) {  // tails of 32 bits: every second one ends a word
    std::vector<std::uint64_t> codes;
    for (std::size_t at = 1; at <= pairs; ++at) codes.push_back(at << 34U);
    codes.push_back(codes.back());  // and one without a tail behind it
    expect_back(codes);
  }
}

TEST(Gaps, RandomCodesComeBack) {
  Random random(11);
  for (int round = 0; round < 200; ++round) {
    std::vector<std::uint64_t> codes;
    std::uint64_t code = 0;
    while (codes.size() < 300) {
      code += random.next() >> (8 + random.below(56));
      if (code >> 63U != 0) break;
      codes.push_back(code);
    }
    expect_back(codes);
  }
}

TEST(Gaps, CodesThatFallAreRefused) {
  EXPECT_FALSE(gaps_from_codes(bytes_of({5, 4})));
  EXPECT_FALSE(gaps_from_codes(bytes_of({1ULL << 63U})));
}

TEST(Gaps, WhatDoesNotFitIsRefused) {
  const auto gaps = gaps_from_codes(bytes_of({1ULL << 40U, 1ULL << 62U})).value();
  Bytes out(16);
  Bytes no_token = gaps.tokens;
  no_token[1] = 248;
  EXPECT_FALSE(codes_from_gaps(no_token, gaps.tails, out.data()));
  const ByteView tails(gaps.tails);
  EXPECT_FALSE(codes_from_gaps(gaps.tokens, tails.first(tails.size() - 8), out.data()));
  EXPECT_FALSE(codes_from_gaps(gaps.tokens, tails.first(tails.size() - 1), out.data()));
  Bytes more = gaps.tails;
  more.resize(more.size() + 8);
  EXPECT_FALSE(codes_from_gaps(gaps.tokens, more, out.data()));
  const Bytes largest{247, 247};  // twice at least 2^62 + 3 * 2^60
  EXPECT_FALSE(codes_from_gaps(largest, Bytes(24), out.data()));
}

}  // namespace
}  // namespace weft::clouds
