#include "clients/cli/files.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "storage/formats/gzip.hpp"

namespace weft::cli {
namespace {
constexpr std::size_t kLargest = 1ULL << 30U;

/// Returns what to do about a file that cannot be unpacked.
std::string advice_on(const Error& error) {
  if (error.code == ErrorCode::exhausted) return " (at most 1 GiB is read); split what it holds";
  return "; copy the file again, or name it without .gz if it is not packed";
}
}  // namespace

Result<Bytes> read_file(const std::string& file) {
  std::error_code unreadable;
  if (std::filesystem::is_directory(file, unreadable))
    return fail(ErrorCode::invalid, file + ": is a folder; name a file in it");
  std::ifstream in(file, std::ios::binary);
  if (!in) return fail(ErrorCode::invalid, file + ": cannot be opened; is it there, and readable?");
  const std::uintmax_t size = std::filesystem::file_size(file, unreadable);
  if (!unreadable && size > kLargest)
    return fail(ErrorCode::exhausted, file + ": has more than 1 GiB; split what it holds");
  Bytes bytes{std::istreambuf_iterator<char>(in), {}};
  if (!file.ends_with(".gz")) return bytes;
  Result<Bytes> unpacked = formats::gunzip(bytes, kLargest);
  if (!unpacked)
    return fail(unpacked.error().code, file + ": " + unpacked.error().message + advice_on(unpacked.error()));
  return unpacked;
}

Result<std::string> read_text(const std::string& file) {
  const Result<Bytes> bytes = read_file(file);
  if (!bytes) return fail(bytes.error());
  return std::string(bytes->begin(), bytes->end());
}

Result<void> write_file(ByteView bytes, const std::string& file) {
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) return fail(ErrorCode::exhausted, file + ": cannot be written; is the folder there?");
  return {};
}

Result<void> write_file(const std::string& text, const std::string& file) {
  return write_file(ByteView{reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, file);
}

std::string ending_of(const std::string& file) {
  std::string name = std::filesystem::path(file).filename().string();
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  if (name.ends_with(".gz")) name.resize(name.size() - 3);
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? std::string{} : name.substr(dot);
}

}  // namespace weft::cli
