#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "core/byte_reader.hpp"
#include "core/byte_writer.hpp"
#include "core/bytes.hpp"
#include "core/result.hpp"

namespace weft::clouds {

inline constexpr unsigned kAxisBits = 21;                              ///< of a code; three axes fill 63 bits
inline constexpr std::int32_t kLatticeBound = std::int32_t{1} << 23U;  ///< coordinates lie strictly within, quanta

using Magic = std::array<std::uint8_t, 7>;
inline constexpr Magic kCanonicalMagic{'W', 'E', 'F', 'T', 'C', 'L', 'D'};
inline constexpr Magic kCompressedMagic{'W', 'E', 'F', 'T', 'C', 'L', 'Z'};
inline constexpr std::size_t kMagicBytes = 8;  ///< with the format's number
inline constexpr std::size_t kHeadBytes = 25;

/// Holds the head that both forms have: what they say of the points before they list them.
struct Head {
  std::uint32_t quantum_um = 1;
  std::array<std::int32_t, 3> origin{};  ///< quanta
  std::uint8_t value_bytes = 0;
  std::uint32_t count = 0;
  std::uint32_t attached = 0;  ///< bytes

  std::uint64_t canonical_size() const {
    return kMagicBytes + kHeadBytes + std::uint64_t{count} * (sizeof(std::uint64_t) + value_bytes) + attached;
  }
};

/// Returns a failure. corrupt: `what` of the bytes of a cloud breaks docs/formats/cloud.md.
tl::unexpected<Error> corrupt_cloud(const std::string& what);

/// Returns a failure. corrupt: canonical bytes of another size than their head asks for.
tl::unexpected<Error> wrong_size(const Head& head, std::size_t size);

void write_magic(ByteWriter& out, const Magic& magic);
/// Checks what a cloud's bytes start with. corrupt: another magic, or a format that never was; newer: a later format.
Result<void> check_magic(ByteView bytes, const Magic& magic);

void write_head(ByteWriter& out, const Head& head);
/// Reads a head; the reader keeps as wrong what is out of range.
Head read_head(ByteReader& in);

/// Returns canonical bytes up to the codes; the room of what follows is there, zero.
Bytes with_head(const Head& head);

}  // namespace weft::clouds
