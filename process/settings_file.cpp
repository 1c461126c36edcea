#include "process/settings_file.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace weft::process {

Result<std::string> read_settings(const std::string& file) {
  if (file.empty()) return std::string();
  std::error_code unknown;
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file, unknown)) {
    return fail(ErrorCode::invalid, file + ": cannot be read; is --config right?");
  }
  return std::string(std::istreambuf_iterator<char>(in), {});
}

}  // namespace weft::process
