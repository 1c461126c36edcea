#include "storage/clouds/gaps.hpp"

#include <array>
#include <bit>
#include <cstring>
#include <string>

#include "storage/clouds/head.hpp"

namespace weft::clouds {
namespace {

static_assert(std::endian::native == std::endian::little);  // words are copied as they stand in memory

constexpr std::size_t kWord = sizeof(std::uint64_t);
constexpr unsigned kTokens = 248;

std::uint64_t load(const std::uint8_t* bytes) {
  std::uint64_t word = 0;
  std::memcpy(&word, bytes, kWord);
  return word;
}

void store(std::uint8_t* bytes, std::uint64_t word) {
  std::memcpy(bytes, &word, kWord);
}

struct Split {
  std::uint8_t token = 0;
  unsigned tail_bits = 0;
};

Split split_gap(std::uint64_t gap) {
  if (gap < 4) return {static_cast<std::uint8_t>(gap), 0};
  const unsigned k = static_cast<unsigned>(std::bit_width(gap)) - 1;
  return {static_cast<std::uint8_t>(4 * (k - 1) + ((gap >> (k - 2)) & 3U)), k - 2};
}

/// Says which gap a token stands for: `base` plus the next `tail_bits` bits of the tails.
struct Meaning {
  std::uint64_t base = 0;
  std::uint64_t tail_mask = 0;
  std::uint8_t tail_bits = 0;
};

/// Returns the meanings of all tokens. Entries from kTokens on mean nothing.
constexpr std::array<Meaning, 256> meanings() {
  std::array<Meaning, 256> table{};
  for (unsigned token = 0; token < kTokens; ++token) {
    if (token < 4) {
      table[token].base = token;
      continue;
    }
    const unsigned bits = token / 4 - 1;
    table[token] = {(4ULL + token % 4) << bits, (1ULL << bits) - 1, static_cast<std::uint8_t>(bits)};
  }
  return table;
}

constexpr std::array<Meaning, 256> kMeanings = meanings();

/// Packs bits into words from the lowest on. `out` has room for all of them.
class BitWriter {
 public:
  explicit BitWriter(std::uint8_t* out) : out_(out) {}
  /// Appends the lowest `bits` (< 64) bits of `value`, which has no others.
  void write(std::uint64_t value, unsigned bits) {
    word_ |= value << used_;
    if (used_ + bits < 64) {
      used_ += bits;
      return;
    }
    store(out_, word_);
    out_ += kWord;
    word_ = value >> (64 - used_);  // used_ > 0 here
    used_ = used_ + bits - 64;
  }
  /// Stores the word begun, and one of zeros. Returns where the words end.
  std::uint8_t* finish() {
    store(out_, word_);
    store(out_ + kWord, 0);
    return out_ + 2 * kWord;
  }

 private:
  std::uint8_t* out_;
  std::uint64_t word_ = 0;
  unsigned used_ = 0;
};

/// Returns how many words the tails of these tokens take, so that reading two at any bit stays within them. corrupt:
/// a token without meaning.
Result<std::size_t> words_of(ByteView tokens) {
  std::uint64_t bits = 0;
  std::uint8_t most = 0;
  for (const std::uint8_t token : tokens) {
    bits += kMeanings[token].tail_bits;
    most = token > most ? token : most;
  }
  if (most >= kTokens) return corrupt_cloud("token " + std::to_string(most) + " means nothing");
  return bits / 64 + 2;
}

}  // namespace

Result<Gaps> gaps_from_codes(ByteView codes) {
  const std::size_t count = codes.size() / kWord;
  Gaps gaps{Bytes(count), Bytes((count + 2) * kWord)};  // a tail has less than a word
  BitWriter tails(gaps.tails.data());
  std::uint64_t before = 0;
  for (std::size_t at = 0; at < count; ++at) {
    const std::uint64_t code = load(codes.data() + at * kWord);
    if (code < before || code >> 63U != 0) {
      return corrupt_cloud("code " + std::to_string(at) + " is less than the one before, or 2^63 and more");
    }
    const std::uint64_t gap = code - before;
    const Split parts = split_gap(gap);
    gaps.tokens[at] = parts.token;
    tails.write(gap & kMeanings[parts.token].tail_mask, parts.tail_bits);
    before = code;
  }
  gaps.tails.resize(static_cast<std::size_t>(tails.finish() - gaps.tails.data()));
  return gaps;
}

Result<void> codes_from_gaps(ByteView tokens, ByteView tails, std::uint8_t* out) {
  const auto words = words_of(tokens);
  if (!words) return fail(words.error());
  if (tails.size() != *words * kWord) {
    return corrupt_cloud("its tokens ask for " + std::to_string(*words) + " words of tails, " +
                         std::to_string(tails.size() / kWord) + " are there");
  }
  std::uint64_t code = 0;
  std::uint64_t all_codes = 0;
  std::size_t bit = 0;
  for (const std::uint8_t token : tokens) {
    const Meaning& meaning = kMeanings[token];
    const std::uint8_t* word = tails.data() + bit / 64 * kWord;
    // Shifted in two steps: by 64 at once, when the tail begins a word, would be undefined.
    const std::uint64_t tail = load(word) >> (bit % 64) | (load(word + kWord) << 1U) << (63 - bit % 64);
    code += meaning.base + (tail & meaning.tail_mask);
    all_codes |= code;
    bit += meaning.tail_bits;
    store(out, code);
    out += kWord;
  }
  // The first code of 2^63 or more is seen before the sum can wrap: a gap is less than 2^63.
  if (all_codes >> 63U != 0) return corrupt_cloud("its gaps add up to 2^63 or more");
  return {};
}

}  // namespace weft::clouds
