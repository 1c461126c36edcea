#include "agents/methods/recognition/code.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/random.hpp"

namespace weft::agents {
namespace {

Signature random_signature(Random& random, std::size_t numbers) {
  Signature signature(numbers);
  for (float& number : signature) number = static_cast<float>(0.2 + 0.05 * random.normal());
  return signature;
}

/// Returns `signature` as another view shows it: with as much noise as there is to see.
Signature seen_again(const Signature& signature, Random& random) {
  Signature again = signature;
  for (float& number : again) number += static_cast<float>(0.05 * random.normal());
  return again;
}

std::int32_t likeness(const CodeQuery& query, const std::vector<std::uint8_t>& code) {
  std::array<std::int32_t, 1> one{};
  query.compare(code, one);
  return one[0];
}

TEST(Code, TakesFourBitsANumber) {
  EXPECT_EQ(code_bytes(512), 256U);
  EXPECT_EQ(code_bytes(1024), 512U);
  EXPECT_EQ(code_bytes(16), 16U);  // no less than one block
  EXPECT_EQ(code_bytes(513), 272U);
}

TEST(Code, LevelsRiseWithTheNumber) {
  Signature rising(512);
  std::iota(rising.begin(), rising.end(), 0.0F);
  std::vector<std::uint8_t> code(code_bytes(rising.size()));
  write_code(rising, code);
  const auto level = [&](std::size_t i) { return code[i % 256] >> 4 * (i / 256) & 15; };
  EXPECT_EQ(level(0), 4);
  EXPECT_EQ(level(200), 7);
  EXPECT_EQ(level(300), 8);
  EXPECT_EQ(level(511), 11);
  for (std::size_t i = 1; i < rising.size(); ++i) EXPECT_GE(level(i), level(i - 1)) << i;
}

TEST(Code, IsTheSameWhateverTheScaleAndOffset) {
  Random random(1);
  const Signature signature = random_signature(random, 512);
  Signature louder = signature;
  for (float& number : louder) number = 4.0F * number + 3.0F;
  std::vector<std::uint8_t> code(256);
  std::vector<std::uint8_t> other(256);
  write_code(signature, code);
  write_code(louder, other);
  EXPECT_EQ(code, other);
}

TEST(Code, ASignatureOfEqualNumbersIsOneToo) {
  std::vector<std::uint8_t> code(256);
  write_code(Signature(512, 0.25F), code);
  const CodeQuery query(Signature(512, 0.5F), {});
  EXPECT_EQ(likeness(query, code), 0);
}

// The sums of a block must not overflow for the longest signature, however far its numbers lie.
TEST(Code, TheLongestSignatureWithTheFarthestNumbersIsMostAlikeItself) {
  Signature far(longest_signature, -1.0F);
  for (std::size_t i = 0; i < far.size(); i += 2) far[i] = 1.0F;
  Signature against = far;
  for (float& number : against) number = -number;
  std::vector<std::uint8_t> code(code_bytes(far.size()));
  const CodeQuery query(far, {});
  write_code(far, code);
  const std::int32_t same = likeness(query, code);
  write_code(against, code);
  EXPECT_GT(same, 0);
  EXPECT_EQ(likeness(query, code), -same);
}

TEST(Code, FindsWhatWasSeenAgainAmongMany) {
  for (const std::size_t numbers : {std::size_t{512}, std::size_t{100}}) {
    Random random(2);
    std::vector<Signature> signatures;
    std::vector<std::uint8_t> codes(300 * code_bytes(numbers));
    for (std::size_t i = 0; i < 300; ++i) {
      signatures.push_back(random_signature(random, numbers));
      write_code(signatures[i], std::span(codes).subspan(i * code_bytes(numbers), code_bytes(numbers)));
    }
    std::vector<std::int32_t> likeness(300);
    for (const std::size_t which : {0U, 17U, 299U}) {
      CodeQuery(seen_again(signatures[which], random), {}).compare(codes, likeness);
      const auto best = std::max_element(likeness.begin(), likeness.end()) - likeness.begin();
      EXPECT_EQ(static_cast<std::size_t>(best), which) << numbers;
    }
  }
}

// Half of the numbers are large in all: places differ by as little as a tenth of that.
TEST(Code, WhatIsUsualTellsNothingApart) {
  constexpr std::size_t kPlaces = 300;
  Random random(3);
  std::vector<Signature> signatures;
  std::vector<std::uint8_t> codes(kPlaces * code_bytes(512));
  UsualLevels usual;
  const auto vary = [&](Signature signature) {
    for (float& number : signature) number += static_cast<float>(0.05 * random.normal());
    return signature;
  };
  Signature common(512, 0.0F);
  std::fill_n(common.begin(), 256, 1.0F);
  for (std::size_t i = 0; i < kPlaces; ++i) {
    signatures.push_back(vary(common));
    const auto code = std::span(codes).subspan(i * code_bytes(512), code_bytes(512));
    write_code(signatures[i], code);
    usual.count(code, 1);
  }
  std::vector<std::int32_t> likeness(kPlaces);
  const auto found = [&](const UsualLevels& known) {
    std::size_t right = 0;
    for (std::size_t which = 0; which < kPlaces; which += 10) {
      CodeQuery(vary(signatures[which]), known).compare(codes, likeness);
      if (std::max_element(likeness.begin(), likeness.end()) - likeness.begin() == static_cast<long>(which)) ++right;
    }
    return right;
  };
  EXPECT_GE(found(usual), 24U) << "of 30";
  EXPECT_LE(found({}), 15U) << "else there was nothing to show";
}

TEST(UsualLevels, AreTheMeanOfWhatIsCounted) {
  const std::vector<std::uint8_t> one(16, 0x31);
  const std::vector<std::uint8_t> other(16, 0x52);
  UsualLevels usual;
  EXPECT_DOUBLE_EQ(usual.of(0), 7.5);
  usual.count(one, 1);
  usual.count(other, 1);
  EXPECT_DOUBLE_EQ(usual.of(0), 1.5);
  EXPECT_DOUBLE_EQ(usual.of(31), 4.0);
  usual.count(one, -1);
  EXPECT_DOUBLE_EQ(usual.of(15), 2.0);
  EXPECT_DOUBLE_EQ(usual.of(16), 5.0);
}

}  // namespace
}  // namespace weft::agents
