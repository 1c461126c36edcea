#include "clients/evaluate/files.hpp"

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>

#include "core/network/codec.hpp"

namespace weft::evaluate {

Result<std::string> read_text(const std::filesystem::path& file, const std::string& what) {
  std::ifstream in(file, std::ios::binary);
  if (!in || !std::filesystem::is_regular_file(file)) {
    return fail(ErrorCode::not_found, file.string() + ": no such " + what);
  }
  return std::string{std::istreambuf_iterator<char>(in), {}};
}

Result<void> write_text(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path beside = file.string() + ".new";
  std::ofstream out(beside, std::ios::binary);
  out << text;
  out.close();
  std::error_code problem;
  if (out) std::filesystem::rename(beside, file, problem);
  if (!out || problem) {
    return fail(ErrorCode::unavailable, file.string() + ": cannot be written; is the disk full, the folder there?");
  }
  return {};
}

Result<void> make_folder(const std::filesystem::path& folder) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) return fail(ErrorCode::unavailable, folder.string() + ": " + problem.message());
  return {};
}

std::string sha256_of(const std::string& text) {
  return to_string(hash_bytes({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
}

std::string difference(const nlohmann::json& theirs, const nlohmann::json& ours) {
  std::string keys;
  for (const auto& [key, value] : ours.items()) {
    if (!theirs.contains(key) || theirs[key] != value) keys += (keys.empty() ? "" : ", ") + key;
  }
  return keys;
}

}  // namespace weft::evaluate
