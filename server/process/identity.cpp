#include "server/process/identity.hpp"

#include <cstring>
#include <fstream>
#include <random>
#include <string>
#include <system_error>

namespace weft::server {

Random random_from_machine() {
  std::random_device device;
  return Random((std::uint64_t{device()} << 32U) | device());
}

Result<PeerId> load_identity(const std::filesystem::path& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) {
    return fail(ErrorCode::unavailable, "cannot make the store's directory " + directory.string() + ": " +
                                            error.message() + "; name another with --store");
  }
  const std::filesystem::path file = directory / "identity";
  PeerId id;
  if (std::ifstream in(file); in) {
    std::string text;
    in >> text;
    if (parse_hex(text, id.bytes.data(), id.bytes.size()) && id) return id;
    return fail(ErrorCode::corrupt, file.string() + " holds no id of 32 hex digits: put it back, or delete it");
  }
  Random random = random_from_machine();
  for (std::uint8_t& byte : id.bytes) byte = static_cast<std::uint8_t>(random.next());
  const std::filesystem::path fresh = directory / "identity.new";
  {
    std::ofstream out(fresh);
    out << to_string(id) << "\n";
    out.flush();
    if (!out) {
      return fail(ErrorCode::unavailable,
                  "cannot write in " + directory.string() + ": " + std::strerror(errno) + "; give it to this user");
    }
  }
  std::filesystem::rename(fresh, file, error);
  if (error) return fail(ErrorCode::unavailable, "cannot write " + file.string() + ": " + error.message());
  return id;
}

}  // namespace weft::server
