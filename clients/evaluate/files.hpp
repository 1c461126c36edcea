#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/result.hpp"

/// What studies read and write.
namespace weft::evaluate {

/// not_found: "FILE: no such WHAT".
Result<std::string> read_text(const std::filesystem::path& file, const std::string& what);

/// Whole or not at all: written beside and renamed. unavailable: names the file.
Result<void> write_text(const std::filesystem::path& file, const std::string& text);

/// With all above it; no harm where it is there. unavailable: names it.
Result<void> make_folder(const std::filesystem::path& folder);

/// Of the text's bytes, in hex.
std::string sha256_of(const std::string& text);

/// The keys in which what a folder was measured of differs from what is to be measured, for the one who has to choose
/// another folder; empty: none.
std::string difference(const nlohmann::json& theirs, const nlohmann::json& ours);

}  // namespace weft::evaluate
