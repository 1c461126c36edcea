#include "storage/spool/durable_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

namespace weft::storage {
namespace {

/// Returns the failure of a system call that has just set errno.
Error system_error(const std::filesystem::path& file, const char* what) {
  const int number = errno;
  const bool is_full = number == ENOSPC || number == EDQUOT || number == EFBIG;
  return {is_full ? ErrorCode::exhausted : ErrorCode::unavailable, file.string() + ": cannot " + what + ": " +
                                                                       std::generic_category().message(number) +
                                                                       (is_full ? "; free space on its disk" : "")};
}

class File {
 public:
  File(const std::filesystem::path& path, int flags) : file_(::open(path.c_str(), flags | O_CLOEXEC, 0644)) {}
  ~File() {
    if (file_ >= 0) ::close(file_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  bool is_open() const { return file_ >= 0; }
  int number() const { return file_; }

  bool write_all(ByteView bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(file_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) return false;
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
  }

 private:
  int file_;
};

Result<void> sync_directory(const std::filesystem::path& directory) {
  const File file(directory, O_RDONLY | O_DIRECTORY);
  if (!file.is_open() || ::fsync(file.number()) != 0) return fail(system_error(directory, "synchronise"));
  return {};
}

Result<void> sync_file(const std::filesystem::path& path) {
  const File file(path, O_WRONLY);
  if (!file.is_open() || ::fsync(file.number()) != 0) return fail(system_error(path, "synchronise"));
  return {};
}

Result<void> write_synchronised(const std::filesystem::path& path, ByteView bytes) {
  if (auto done = write_for_now(path, bytes); !done) return done;
  return sync_file(path);
}

}  // namespace

Result<void> write_for_now(const std::filesystem::path& path, ByteView bytes) {
  const File file(path, O_WRONLY | O_CREAT | O_TRUNC);
  if (!file.is_open()) return fail(system_error(path, "create"));
  if (!file.write_all(bytes)) return fail(system_error(path, "write"));
  return {};
}

Result<void> make_durable(const std::filesystem::path& directory, const std::vector<std::filesystem::path>& files) {
  for (const std::filesystem::path& file : files)
    if (auto done = sync_file(file); !done) return done;
  return sync_directory(directory);
}

Result<void> write_durably(const std::filesystem::path& file, ByteView bytes) {
  std::filesystem::path temporary = file;
  temporary += ".tmp";
  Result<void> done = write_synchronised(temporary, bytes);
  if (done && ::rename(temporary.c_str(), file.c_str()) != 0) done = fail(system_error(file, "rename"));
  if (!done) {
    ::unlink(temporary.c_str());
    return done;
  }
  done = sync_directory(file.parent_path());
  if (!done) ::unlink(file.c_str());
  return done;
}

Result<Bytes> read_whole(const std::filesystem::path& path) {
  const File file(path, O_RDONLY);
  struct stat status {};
  if (!file.is_open() || ::fstat(file.number(), &status) != 0) return fail(system_error(path, "open"));
  Bytes bytes(static_cast<std::size_t>(status.st_size));
  std::size_t got = 0;
  while (got < bytes.size()) {
    const ssize_t count = ::read(file.number(), bytes.data() + got, bytes.size() - got);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return fail(system_error(path, "read"));
    if (count == 0) break;
    got += static_cast<std::size_t>(count);
  }
  bytes.resize(got);
  return bytes;
}

Result<void> rename_if_there(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (::rename(from.c_str(), to.c_str()) != 0 && errno != ENOENT) return fail(system_error(from, "rename"));
  return {};
}

Result<void> remove_if_there(const std::filesystem::path& file) {
  if (::unlink(file.c_str()) != 0 && errno != ENOENT) return fail(system_error(file, "remove"));
  return {};
}

Result<void> remove_durably(const std::filesystem::path& file) {
  if (auto done = remove_if_there(file); !done) return done;
  return sync_directory(file.parent_path());
}

}  // namespace weft::storage
