#include "core/protocol/assembly.hpp"

#include <gtest/gtest.h>

#include "core/network/codec.hpp"

namespace weft {
namespace {

Bytes some_bytes(std::size_t size) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(7 * i + i / 256);
  return bytes;
}

msg::Chunk piece(const Bytes& bytes, std::uint64_t offset, std::uint64_t size) {
  msg::Chunk chunk;
  chunk.hash = hash_bytes(bytes);
  chunk.total = bytes.size();
  chunk.offset = offset;
  const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(offset);
  chunk.data.assign(begin, begin + static_cast<std::ptrdiff_t>(size));
  return chunk;
}

TEST(Assembly, AnyOrderOverlapAndRepeatsGiveTheBytes) {
  const Bytes bytes = some_bytes(1000);
  Assembly assembly(1000);
  ASSERT_TRUE(assembly.add(piece(bytes, 600, 400)).has_value());
  EXPECT_EQ(assembly.contiguous(), 0U);
  ASSERT_TRUE(assembly.add(piece(bytes, 0, 300)).has_value());
  ASSERT_TRUE(assembly.add(piece(bytes, 0, 300)).has_value());
  EXPECT_EQ(assembly.contiguous(), 300U);
  EXPECT_FALSE(assembly.is_complete());
  ASSERT_TRUE(assembly.add(piece(bytes, 200, 500)).has_value());
  ASSERT_TRUE(assembly.is_complete());
  EXPECT_EQ(assembly.bytes(), bytes);
  const Result<Bytes> taken = std::move(assembly).take(hash_bytes(bytes));
  ASSERT_TRUE(taken.has_value());
  EXPECT_EQ(*taken, bytes);
}

TEST(Assembly, RangesThatTouchBecomeOne) {
  const Bytes bytes = some_bytes(30);
  Assembly assembly(30);
  for (const std::uint64_t offset : {20U, 10U, 0U}) ASSERT_TRUE(assembly.add(piece(bytes, offset, 10)).has_value());
  EXPECT_EQ(assembly.contiguous(), 30U);
  EXPECT_EQ(assembly.bytes(), bytes);
}

TEST(Assembly, NothingIsCompleteAtOnce) {
  Assembly assembly(0);
  EXPECT_TRUE(assembly.is_complete());
  EXPECT_TRUE(assembly.add(piece({}, 0, 0)).has_value());
}

TEST(Assembly, ChunkBeyondTheContentIsRefused) {
  const Bytes bytes = some_bytes(1000);
  Assembly assembly(900);
  EXPECT_EQ(assembly.add(piece(bytes, 0, 100)).error().code, ErrorCode::invalid);
  msg::Chunk beyond = piece(bytes, 900, 100);
  beyond.total = 900;
  EXPECT_FALSE(assembly.add(beyond).has_value());
  beyond.offset = ~std::uint64_t{0};
  EXPECT_FALSE(assembly.add(beyond).has_value());
  EXPECT_EQ(assembly.contiguous(), 0U);
}

TEST(Assembly, ChunkOfAnotherFormIsRefused) {
  const Bytes bytes = some_bytes(100);
  Assembly assembly(100, msg::Coding::zstd);
  msg::Chunk chunk = piece(bytes, 0, 100);
  EXPECT_FALSE(assembly.is_of(chunk));
  EXPECT_EQ(assembly.add(chunk).error().code, ErrorCode::invalid);
  chunk.coding = msg::Coding::zstd;
  EXPECT_TRUE(assembly.is_of(chunk));
  EXPECT_TRUE(assembly.add(chunk));
}

TEST(Assembly, WhatIsNotWhatWasPromisedIsCorrupt) {
  const Bytes bytes = some_bytes(100);
  Assembly assembly(100);
  ASSERT_TRUE(assembly.add(piece(bytes, 0, 100)).has_value());
  const Result<Bytes> taken = std::move(assembly).take(hash_bytes(some_bytes(99)));
  ASSERT_FALSE(taken.has_value());
  EXPECT_EQ(taken.error().code, ErrorCode::corrupt);
}

}  // namespace
}  // namespace weft
