#pragma once
#include <filesystem>

#include "core/bytes.hpp"
#include "core/result.hpp"

namespace weft::storage {

/// Writes a file that is there as a whole and for good when this returns, and not at all otherwise: temporary name
/// (`file` + ".tmp"), fsync, rename, fsync of the directory. exhausted: the disk is full. unavailable: other errors.
Result<void> write_durably(const std::filesystem::path& file, ByteView bytes);

/// Reads the whole file. unavailable: it cannot be read.
Result<Bytes> read_whole(const std::filesystem::path& file);

/// Renames the file for good; one that is not there is fine.
Result<void> rename_if_there(const std::filesystem::path& from, const std::filesystem::path& to);

/// Removes the file for good; a file that is not there is fine.
Result<void> remove_durably(const std::filesystem::path& file);

}  // namespace weft::storage
