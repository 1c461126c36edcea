#pragma once
#include <filesystem>
#include <memory>

#include "storage/spool.hpp"

namespace weft::storage {

/// Opens the spool in `directory` (made if need be), a file a batch; its format is docs/formats/spool.md. Torn or
/// damaged files are skipped, named and left where they are. One process at a time: the agent's state directory sees
/// to that. unavailable: the directory cannot be read or written. newer: a file of a newer format, which must not be
/// skipped.
Result<std::unique_ptr<Spool>> open_file_spool(const std::filesystem::path& directory);

}  // namespace weft::storage
