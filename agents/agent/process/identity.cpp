#include "agents/agent/process/identity.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <random>
#include <string>
#include <system_error>
#include <utility>

namespace weft::agents {

Random random_from_machine() {
  std::random_device device;
  return Random((static_cast<std::uint64_t>(device()) << 32U) | device());
}

StateDirectory::StateDirectory(std::filesystem::path directory, int lock)
    : directory_(std::move(directory)), lock_(lock) {}

StateDirectory::StateDirectory(StateDirectory&& other) noexcept
    : directory_(std::move(other.directory_)), lock_(std::exchange(other.lock_, -1)) {}

StateDirectory::~StateDirectory() {
  if (lock_ >= 0) close(lock_);
}

Result<StateDirectory> StateDirectory::open(const std::filesystem::path& directory) {
  std::error_code problem;
  std::filesystem::create_directories(directory, problem);
  const std::string name = "state directory " + directory.string();
  if (problem) return fail(ErrorCode::unavailable, name + ": " + problem.message() + "; give another --state");
  const int lock = ::open((directory / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (lock < 0) return fail(ErrorCode::unavailable, name + ": " + std::strerror(errno) + "; give another --state");
  if (flock(lock, LOCK_EX | LOCK_NB) != 0) {
    close(lock);
    return fail(ErrorCode::unavailable, name + ": another agent works in it; stop that one, or give another --state");
  }
  return StateDirectory(directory, lock);
}

Result<RobotId> StateDirectory::identity() const {
  const std::filesystem::path file = directory_ / "identity";
  RobotId id;
  if (std::ifstream in(file); in) {
    std::string text;
    in >> text;
    if (!parse_hex(text, id.bytes.data(), id.bytes.size()) || !id) {
      return fail(ErrorCode::corrupt, file.string() +
                                          ": holds no identity (32 hex digits); restore it, or remove it and "
                                          "the robot is a new one");
    }
    return id;
  }
  Random random = random_from_machine();
  for (std::uint8_t& byte : id.bytes) byte = static_cast<std::uint8_t>(random.next() >> 8U);
  const std::filesystem::path draft = directory_ / "identity.new";
  std::ofstream out(draft, std::ios::trunc);
  out << to_string(id) << '\n';
  out.close();
  std::error_code problem;
  if (out) std::filesystem::rename(draft, file, problem);
  if (!out || problem) return fail(ErrorCode::unavailable, file.string() + ": cannot be written; is the disk full?");
  return id;
}

}  // namespace weft::agents
