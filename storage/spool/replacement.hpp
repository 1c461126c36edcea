#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/bytes.hpp"
#include "core/result.hpp"
#include "storage/spool/file_names.hpp"

namespace weft::storage {

/// Says which of a spool's files take the place of which, by the numbers in their names.
struct Replacement {
  std::vector<std::uint64_t> removed;
  std::vector<std::uint64_t> added;
};

/// Writes and reads the file that decides (docs/formats/spool.md). corrupt: no such file, or damaged; newer: of a
/// later format.
Bytes encode(const Replacement& replacement);
Result<Replacement> decode_replacement(ByteView bytes);

/// Gives staged files their names, removes those that they replace, then the file that decided; goes on where it was
/// interrupted. unavailable: the directory cannot be written.
Result<void> carry_out(const std::filesystem::path& directory, const Replacement& replacement);

}  // namespace weft::storage
