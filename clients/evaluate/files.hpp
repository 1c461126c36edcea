#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/result.hpp"

/// Holds the evaluation; here: what studies read and write files with.
namespace weft::evaluate {

/// Returns a file's text. not_found: "FILE: no such WHAT".
Result<std::string> read_text(const std::filesystem::path& file, const std::string& what);

/// Writes a file, whole or not at all: beside, then renamed. unavailable: names the file.
Result<void> write_text(const std::filesystem::path& file, const std::string& text);

/// Makes a folder with all above it; no harm where it is there. unavailable: names it.
Result<void> make_folder(const std::filesystem::path& folder);

/// Returns the SHA-256 of the text's bytes, in hex.
std::string sha256_of(const std::string& text);

/// Returns the keys in which what a folder was measured of differs from what is to be measured, so that people can
/// choose another folder; empty: none.
std::string difference(const nlohmann::json& theirs, const nlohmann::json& ours);

}  // namespace weft::evaluate
