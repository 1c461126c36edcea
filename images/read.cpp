#include "images/read.hpp"

#include <fstream>
#include <string>
#include <system_error>

#include "images/decode.hpp"

namespace weft::images {

Result<Picture> read(const std::filesystem::path& file, Shades shades) {
  constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 30U;
  std::error_code problem;
  const std::uintmax_t size = std::filesystem::file_size(file, problem);
  if (problem) {
    const bool is_missing = problem == std::errc::no_such_file_or_directory;
    return fail(is_missing ? ErrorCode::not_found : ErrorCode::unavailable, file.string() + ": " + problem.message());
  }
  if (size > kMostBytes) {
    return fail(ErrorCode::exhausted, file.string() + ": has " + std::to_string(size) + " bytes, at most " +
                                          std::to_string(kMostBytes) + " are read; make it smaller");
  }
  Bytes bytes(size);
  std::ifstream in(file, std::ios::binary);
  if (!in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size))) {
    return fail(ErrorCode::unavailable, file.string() + ": cannot be read; are its rights as they should be?");
  }
  return decode(bytes, file.string(), shades);
}

}  // namespace weft::images
