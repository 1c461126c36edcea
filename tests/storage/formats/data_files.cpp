#include "tests/storage/formats/data_files.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "storage/formats/gzip.hpp"

namespace weft::formats::test {

namespace fs = std::filesystem;

std::optional<fs::path> data_folder() {
  const char* const named = std::getenv("WEFT_DATA");
  const fs::path folder = named != nullptr ? named : WEFT_DATA_BESIDE;
  return fs::is_directory(folder) ? std::optional(folder) : std::nullopt;
}

std::string no_data(std::string_view what) {
  return "NOT TESTED: no " + std::string(what) + "; set WEFT_DATA to the folder that holds them";
}

std::vector<fs::path> files_that_end(const fs::path& folder, std::string_view ending) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().string().ends_with(ending)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Bytes read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  Bytes bytes{std::istreambuf_iterator<char>(in), {}};
  if (!is_gzip(bytes)) return bytes;
  constexpr std::size_t kMost = 256U << 20U;
  Result<Bytes> unpacked = gunzip(bytes, kMost);
  if (!unpacked) throw std::runtime_error(file.string() + ": " + unpacked.error().message);
  return *std::move(unpacked);
}

std::string read_text(const fs::path& file) {
  const Bytes bytes = read(file);
  return {bytes.begin(), bytes.end()};
}

std::size_t lines_with(const std::string& text, std::string_view first_word) {
  std::istringstream in(text);
  std::size_t count = 0;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string first;
    count += (words >> first) && first == first_word ? 1 : 0;
  }
  return count;
}

}  // namespace weft::formats::test
