// Bytes that nobody wrote give an error or a cloud, never more memory than a content, never undefined behaviour (what
// the last means is judged by the sanitisers' builds).
#include <gtest/gtest.h>

#include <algorithm>

#include "core/network/change.hpp"
#include "core/network/codec.hpp"
#include "storage/clouds/cloud.hpp"
#include "tests/storage/clouds/sample_clouds.hpp"

namespace weft::clouds {
namespace {

constexpr std::size_t kChecksumAt = 8;
constexpr std::size_t kPayloadAt = 40;

/// Returns the bytes with some changed, a piece cut out or doubled, or the end cut off.
Bytes damaged(Bytes bytes, std::size_t from, Random& random) {
  const auto at = [&] { return from + random.below(std::max<std::size_t>(1, bytes.size() - from)); };
  switch (random.below(4)) {
    case 0:
      bytes.resize(at());
      break;
    case 1:
      bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(at()));
      break;
    case 2:
      bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at()), static_cast<std::uint8_t>(random.next()));
      break;
    default:
      for (std::uint64_t left = 1 + random.below(4); left > 0; --left)
        bytes[at()] = static_cast<std::uint8_t>(random.next());
  }
  return bytes;
}

/// Writes the checksum anew, so that damage gets past it.
void vouch(Bytes& compressed) {
  if (compressed.size() < kPayloadAt) return;
  const ContentHash hash = hash_bytes(ByteView(compressed).subspan(kPayloadAt));
  std::copy(hash.bytes.begin(), hash.bytes.end(), compressed.begin() + kChecksumAt);
}

/// Picks where to damage the bytes: half of the damage goes to the head and the lengths, where it hurts most.
std::size_t place_to_damage(std::size_t begin, const Bytes& bytes, Random& random) {
  if (random.chance(0.5)) return begin;
  return begin + random.below(std::max<std::size_t>(1, bytes.size() - begin));
}

/// Returns a cloud of fewer than `most` points, with values or without, with something attached or without.
Cloud any_cloud(Random& random, std::uint64_t most) {
  Cloud cloud = sample::room(random.next(), random.below(most), random.below(2) * 300);
  return random.chance(0.5) ? cloud : sample::with_attachment(std::move(cloud), random.next(), 1 + random.below(60));
}

TEST(HostileCloud, DamagedCanonicalBytesAreRefusedOrSayACloud) {
  Random random(21);
  std::size_t accepted = 0;
  std::size_t refused = 0;
  for (int round = 0; round < 4000; ++round) {
    const Bytes bytes = canonical_bytes(any_cloud(random, 40), 1000).value();
    const Bytes hostile = damaged(bytes, place_to_damage(0, bytes, random), random);
    const auto decoded = decode_cloud(hostile);
    if (!decoded) {
      EXPECT_FALSE(decoded.error().message.empty());
      ++refused;
      continue;
    }
    ++accepted;
    EXPECT_EQ(canonical_bytes(decoded->cloud, decoded->quantum_um).value(), hostile);  // nothing else is accepted
  }
  EXPECT_GT(accepted, 50U);
  EXPECT_GT(refused, 1000U);
}

TEST(HostileCloud, DamagedCompressedBytesAreAlwaysSeen) {
  Random random(22);
  const Bytes bytes = compress_cloud(canonical_bytes(sample::room(1, 200, 300), 1000).value()).value();
  for (int round = 0; round < 2000; ++round) {
    const Bytes hostile = damaged(bytes, place_to_damage(0, bytes, random), random);
    if (hostile != bytes) {
      EXPECT_FALSE(expand_cloud(hostile));
    }
  }
}

TEST(HostileCloud, DamageThatIsVouchedForIsRefusedOrSaysSomething) {
  Random random(23);
  std::size_t accepted = 0;
  std::size_t refused = 0;
  for (int round = 0; round < 4000; ++round) {
    const Bytes bytes = compress_cloud(canonical_bytes(any_cloud(random, 300), 1000).value()).value();
    Bytes hostile = damaged(bytes, place_to_damage(kPayloadAt, bytes, random), random);
    vouch(hostile);
    const auto expanded = expand_cloud(hostile);
    if (!expanded) {
      EXPECT_FALSE(expanded.error().message.empty());
      ++refused;
      continue;
    }
    ++accepted;
    EXPECT_LE(expanded->size(), kLargestContent);
    EXPECT_EQ(expanded_size(hostile).value(), expanded->size());
    const auto decoded = decode_cloud(*expanded);
    EXPECT_TRUE(decoded || !decoded.error().message.empty());
  }
  EXPECT_GT(accepted, 50U);
  EXPECT_GT(refused, 1000U);
}

TEST(HostileCloud, EveryTruncationIsRefused) {
  const Bytes canonical = canonical_bytes(sample::with_attachment(sample::room(2, 30, 300), 1, 50), 1000).value();
  const Bytes compressed = compress_cloud(canonical).value();
  for (std::size_t size = 0; size < canonical.size(); ++size) {
    EXPECT_FALSE(decode_cloud(ByteView(canonical).first(size)));
    EXPECT_FALSE(compress_cloud(ByteView(canonical).first(size)));
  }
  for (std::size_t size = 0; size < compressed.size(); ++size) {
    Bytes hostile(compressed.begin(), compressed.begin() + static_cast<std::ptrdiff_t>(size));
    vouch(hostile);
    EXPECT_FALSE(expand_cloud(hostile));
    EXPECT_EQ(expanded_size(hostile).has_value(), size >= kPayloadAt + 25) << "the head is all that it reads";
  }
}

TEST(HostileCloud, LengthsBeyondTheLargestContentAreRefusedBeforeTheyAreBelieved) {
  const Bytes canonical = canonical_bytes(sample::room(2, 30, 0), 1000).value();
  for (const int field : {17, 21}) {  // of the head: how many points, how many bytes attached
    Bytes hostile = canonical;
    std::fill_n(hostile.begin() + 8 + field, 4, std::uint8_t{0xff});
    EXPECT_FALSE(decode_cloud(hostile));
    Bytes compressed = compress_cloud(canonical).value();
    std::fill_n(compressed.begin() + kPayloadAt + field, 4, std::uint8_t{0xff});
    vouch(compressed);
    EXPECT_FALSE(expand_cloud(compressed));
    EXPECT_FALSE(expanded_size(compressed));
  }
}

}  // namespace
}  // namespace weft::clouds
