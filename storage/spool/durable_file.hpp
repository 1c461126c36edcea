#pragma once
#include <filesystem>
#include <vector>

#include "core/bytes.hpp"
#include "core/result.hpp"

namespace weft::storage {

/// Writes a file that is there as a whole and for good when this returns, and not at all otherwise: temporary name
/// (`file` + ".tmp"), fsync, rename, fsync of the directory. exhausted: the disk is full. unavailable: other errors.
Result<void> write_durably(const std::filesystem::path& file, ByteView bytes);

/// Reads the whole file. unavailable: it cannot be read.
Result<Bytes> read_whole(const std::filesystem::path& file);

/// Removes the file for good; a file that is not there is fine.
Result<void> remove_durably(const std::filesystem::path& file);

// For many files of one directory: what these three do holds for good only when `make_durable` has returned, which
// then waits for the disk about as long as one file takes.

/// Writes the file; a part of it may be left after an error. Errors as `write_durably`.
Result<void> write_for_now(const std::filesystem::path& file, ByteView bytes);

/// Renames the file; one that is not there is fine.
Result<void> rename_if_there(const std::filesystem::path& from, const std::filesystem::path& to);

/// Removes the file; one that is not there is fine.
Result<void> remove_if_there(const std::filesystem::path& file);

/// Waits until the files, and the names in their directory, are on the disk.
Result<void> make_durable(const std::filesystem::path& directory, const std::vector<std::filesystem::path>& files);

}  // namespace weft::storage
