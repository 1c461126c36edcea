#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "agents/methods/method.hpp"

namespace weft::agents {

inline constexpr std::size_t longest_signature = 1024;  ///< numbers

/// A signature in two bits a number: how far each lies from the mean of all, in four steps of their own standard
/// deviation. 512 numbers take 128 bytes, so that those of a million places fit in memory.
/// In bytes; of equally long signatures the same.
std::size_t code_bytes(std::size_t numbers);
/// `code` has code_bytes(signature.size()).
void write_code(const Signature& signature, std::span<std::uint8_t> code);

/// What is looked for, in eight bits a number: codes are compared with it, not with a code of it.
class CodeQuery {
 public:
  /// At most `longest_signature` finite numbers.
  explicit CodeQuery(const Signature& seen);
  /// The likeness of each of `likeness.size()` codes that stand one behind the other; larger is more alike.
  /// Correlation, but for a factor that is the same for all.
  void compare(std::span<const std::uint8_t> codes, std::span<std::int32_t> likeness) const;
  std::size_t bytes() const { return bytes_; }

 private:
  std::size_t bytes_;
  std::vector<std::int16_t> weights_;  ///< four rows, one for each pair of bits of a byte, padded as codes are
};

}  // namespace weft::agents
