#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "agents/methods/method.hpp"

namespace weft::agents {

inline constexpr std::size_t longest_signature = 1024;  ///< numbers

/// Returns the size in bytes of a signature's code; it is the same of equally long signatures. A code has four bits a
/// number: how far each lies from the mean of all, in 16 steps of half their own standard deviation. 512 numbers take
/// 256 bytes, so that those of a million places fit in memory.
std::size_t code_bytes(std::size_t numbers);
/// Writes a signature's code into `code`, which has code_bytes(signature.size()).
void write_code(const Signature& signature, std::span<std::uint8_t> code);

/// Keeps the mean of all codes of a network. Words that are frequent are so in all places: what tells places apart is
/// how far they lie from this mean.
class UsualLevels {
 public:
  /// Adds one more code or, with `times` = -1, takes one away. All are of the same length.
  void count(std::span<const std::uint8_t> code, int times);
  /// Returns the mean level of a number of the signature, [0, 15]; the middle while there is no code.
  double of(std::size_t number) const;

 private:
  std::int64_t codes_ = 0;
  std::vector<std::int64_t> sums_;
};

/// Holds the signature that is looked for as differences from the usual levels, in finer steps than a code has:
/// stored codes are compared with these, not with a code of the signature.
class CodeQuery {
 public:
  /// Takes a signature of at most `longest_signature` finite numbers.
  CodeQuery(const Signature& seen, const UsualLevels& usual);

  /// Finds the likeness of each of `likeness.size()` codes that stand one behind the other; larger is more alike. It
  /// is the correlation, but for a factor that is the same for all.
  void compare(std::span<const std::uint8_t> codes, std::span<std::int32_t> likeness) const;
  std::size_t bytes() const { return bytes_; }

 private:
  std::size_t bytes_;
  std::vector<std::int16_t> weights_;  ///< two rows, one for each half of a byte, padded as codes are
};

}  // namespace weft::agents
