#include "storage/sqlite/files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "core/bytes.hpp"

namespace weft::storage::sqlite {
namespace {

constexpr std::size_t kCopied = 1U << 20U;
constexpr std::uint64_t kSynced = 64U << 20U;

class OpenFile {
 public:
  OpenFile(const std::filesystem::path& path, int flags) : file_(::open(path.c_str(), flags | O_CLOEXEC, 0644)) {}
  ~OpenFile() {
    if (file_ >= 0) ::close(file_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int number() const { return file_; }

 private:
  int file_;
};

Result<void> sync_path(const std::string& what, const std::filesystem::path& path, int flags) {
  const OpenFile file(path, flags);
  if (file.number() < 0) return fail(file_error(what, path, "open"));
  if (::fsync(file.number()) != 0) return fail(file_error(what, path, "synchronise"));
  return {};
}

bool write_all(int file, ByteView bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

Error file_error(const std::string& what, const std::filesystem::path& file, const char* doing) {
  const int number = errno;
  const bool is_full = number == ENOSPC || number == EDQUOT;
  return {is_full ? ErrorCode::exhausted : ErrorCode::unavailable,
          what + ": cannot " + doing + " " + file.string() + ": " + std::generic_category().message(number) +
              (is_full ? "; free space on its disk" : "")};
}

Result<void> sync_file(const std::string& what, const std::filesystem::path& file) {
  return sync_path(what, file, O_RDWR);
}

Result<void> sync_directory(const std::string& what, const std::filesystem::path& directory) {
  return sync_path(what, directory, O_RDONLY | O_DIRECTORY);
}

Result<void> make_file(const std::string& what, const std::filesystem::path& file) {
  const OpenFile made(file, O_WRONLY | O_CREAT | O_EXCL);
  if (made.number() >= 0) return {};
  Error error = file_error(what, file, "make");
  if (error.code == ErrorCode::exhausted) return fail(std::move(error));
  return fail(error.code, error.message + "; name a folder that is there and that the server may write to");
}

Result<void> copy_file(const std::string& what, const std::filesystem::path& from, const std::filesystem::path& to,
                       const std::function<bool(std::uint64_t, std::uint64_t)>& progress) {
  const OpenFile in(from, O_RDONLY);
  struct stat status {};
  if (in.number() < 0 || ::fstat(in.number(), &status) != 0) return fail(file_error(what, from, "open"));
  const OpenFile out(to, O_WRONLY | O_CREAT | O_TRUNC);
  if (out.number() < 0) return fail(file_error(what, to, "make"));
  const auto total = static_cast<std::uint64_t>(status.st_size);
  Bytes piece(kCopied);
  for (std::uint64_t done = 0;;) {
    if (!progress(done, std::max(done, total))) return fail(ErrorCode::unavailable, what + ": it was stopped");
    const ssize_t got = ::read(in.number(), piece.data(), piece.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return fail(file_error(what, from, "read"));
    if (got == 0) break;
    const auto size = static_cast<std::size_t>(got);
    if (!write_all(out.number(), ByteView(piece).first(size))) return fail(file_error(what, to, "write"));
    done += size;
    if (done % kSynced < size && ::fdatasync(out.number()) != 0) return fail(file_error(what, to, "synchronise"));
  }
  if (::fsync(out.number()) != 0) return fail(file_error(what, to, "synchronise"));
  return {};
}

void remove_database(const std::filesystem::path& file) {
  for (const char* const suffix : {"", "-wal", "-shm", "-journal"}) ::unlink((file.string() + suffix).c_str());
}

}  // namespace weft::storage::sqlite
