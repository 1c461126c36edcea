#include "storage/sqlite/directory_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>
#include <system_error>

namespace weft::storage::sqlite {
namespace {

std::string reason(int number) {
  return std::generic_category().message(number);
}

std::string holder(int file) {
  std::array<char, 16> text{};
  const ssize_t got = ::pread(file, text.data(), text.size(), 0);
  return got > 0 ? std::string(text.data(), static_cast<std::size_t>(got)) : "unknown";
}

}  // namespace

Result<DirectoryLock> DirectoryLock::take(const std::filesystem::path& directory) {
  const std::string name = "map store " + directory.string();
  std::error_code failed;
  std::filesystem::create_directories(directory, failed);
  if (failed) return fail(ErrorCode::unavailable, name + ": cannot make the directory: " + failed.message());

  const int file = ::open((directory / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (file < 0) return fail(ErrorCode::unavailable, name + ": cannot write there: " + reason(errno));
  DirectoryLock lock(file);
  if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK) return fail(ErrorCode::unavailable, name + ": cannot lock it: " + reason(errno));
    return fail(ErrorCode::unavailable,
                name + " is in use by process " + holder(file) + "; stop that server, or name another directory");
  }
  // For the message above only, so a full disk is no reason to stay out.
  const std::string self = std::to_string(::getpid());
  if (::ftruncate(file, 0) == 0) (void)!::pwrite(file, self.data(), self.size(), 0);
  return lock;
}

DirectoryLock::~DirectoryLock() {
  if (file_ >= 0) ::close(file_);
}

}  // namespace weft::storage::sqlite
