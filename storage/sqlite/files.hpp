#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "core/result.hpp"

/// Handles files as a whole, for snapshots and restoring. Errors begin with `what`: exhausted for a full disk, else
/// unavailable.
namespace weft::storage::sqlite {

/// Returns the error of the system call that has just set errno.
Error file_error(const std::string& what, const std::filesystem::path& file, const char* doing);

/// Write a file's bytes, or a directory's names, through to the disk: they are there when it returns.
Result<void> sync_file(const std::string& what, const std::filesystem::path& file);
Result<void> sync_directory(const std::string& what, const std::filesystem::path& directory);

/// Makes an empty file that was not there. Says why it cannot be made: the folder, its permissions, the disk.
Result<void> make_file(const std::string& what, const std::filesystem::path& file);

/// Copies and synchronises; `to` is made anew. `progress(done, total)` in bytes; unavailable when it says false.
Result<void> copy_file(const std::string& what, const std::filesystem::path& from, const std::filesystem::path& to,
                       const std::function<bool(std::uint64_t, std::uint64_t)>& progress);

/// Removes a database with what SQLite keeps beside it; what is not there is fine.
void remove_database(const std::filesystem::path& file);

}  // namespace weft::storage::sqlite
