#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/bytes.hpp"

namespace weft::formats::test {

/// Returns the folder of recordings: WEFT_DATA, or ../shared/data beside the repository. None: it is absent.
std::optional<std::filesystem::path> data_folder();
/// Returns what a skipped test says.
std::string no_data(std::string_view what);
/// Returns all files below `folder` whose names end so, sorted.
std::vector<std::filesystem::path> files_that_end(const std::filesystem::path& folder, std::string_view ending);
/// Return a file's bytes, unpacked if it is gzip.
Bytes read(const std::filesystem::path& file);
std::string read_text(const std::filesystem::path& file);
/// Returns how many lines of a text begin with a word.
std::size_t lines_with(const std::string& text, std::string_view first_word);

}  // namespace weft::formats::test
