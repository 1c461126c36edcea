#include "process/health_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>

#include "core/text.hpp"
#include "process/clocks.hpp"

namespace weft::process {
namespace {

constexpr int kReads = 10;  ///< until two are alike: one can fall into a write

std::string reason(int number) {
  return std::generic_category().message(number);
}

/// Describes a lock of the open file, not of the process, on all of it.
struct flock whole_file(short type) {
  struct flock lock {};
  lock.l_type = type;
  lock.l_whence = SEEK_SET;
  return lock;
}

/// Closes a file at the end of its block.
class Opened {
 public:
  explicit Opened(int file) : file_(file) {}
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;
  ~Opened() {
    if (file_ >= 0) ::close(file_);
  }
  int get() const { return file_; }

 private:
  int file_;
};

std::string read_once(int file) {
  std::array<char, kHealthBytes> bytes{};
  const ssize_t got = ::pread(file, bytes.data(), bytes.size(), 0);
  return got > 0 ? std::string(bytes.data(), static_cast<std::size_t>(got)) : std::string();
}

std::string read_whole(int file) {
  std::string before = read_once(file);
  for (int i = 0; i < kReads; ++i) {
    std::string again = read_once(file);
    if (again == before) break;
    before = std::move(again);
  }
  return before;
}

bool is_full(const std::filesystem::path& directory) {
  struct statvfs disk {};
  return ::statvfs(directory.c_str(), &disk) == 0 && disk.f_bavail == 0;
}

/// Returns whether a process holds the file's lock.
Result<bool> is_held(int file) {
  struct flock lock = whole_file(F_RDLCK);
  if (::fcntl(file, F_OFD_GETLK, &lock) != 0) {
    return fail(ErrorCode::unavailable, "cannot be asked whose it is: " + reason(errno));
  }
  return lock.l_type != F_UNLCK;
}

}  // namespace

Result<HealthFile> HealthFile::open(const std::filesystem::path& directory) {
  const std::filesystem::path path = directory / "health";
  HealthFile file(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0644));
  if (file.file_ < 0) return fail(ErrorCode::unavailable, path.string() + ": cannot be written: " + reason(errno));
  struct flock lock = whole_file(F_WRLCK);
  if (::fcntl(file.file_, F_OFD_SETLK, &lock) != 0) {
    return fail(ErrorCode::unavailable, path.string() + ": cannot be locked: " + reason(errno));
  }
  return file;
}

HealthFile::HealthFile(HealthFile&& other) noexcept : file_(std::exchange(other.file_, -1)) {}

HealthFile& HealthFile::operator=(HealthFile&& other) noexcept {
  std::swap(file_, other.file_);
  return *this;
}

HealthFile::~HealthFile() {
  if (file_ >= 0) ::close(file_);
}

Result<void> HealthFile::write(const Health& health) {
  struct stat found {};
  if (::fstat(file_, &found) == 0 && found.st_nlink == 0) {
    return fail(ErrorCode::unavailable, "the health file was removed");
  }
  const std::string text = health_text(health);
  const ssize_t put = ::pwrite(file_, text.data(), text.size(), 0);
  if (put == static_cast<ssize_t>(text.size())) return {};
  const int number = put < 0 ? errno : ENOSPC;
  return fail(number == ENOSPC ? ErrorCode::exhausted : ErrorCode::unavailable,
              "the health file cannot be written: " + reason(number));
}

Verdict look_at_health(const std::filesystem::path& directory, SteadyTime now) {
  const std::filesystem::path path = directory / "health";
  const Opened file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.get() < 0 && errno == ENOENT) return {false, "not running: there is no " + path.string()};
  if (file.get() < 0) return {false, path.string() + ": cannot be read: " + reason(errno)};
  struct stat found {};
  if (::fstat(file.get(), &found) != 0 || !S_ISREG(found.st_mode)) {
    return {false, path.string() + ": is no file: remove it, and start the process anew"};
  }
  const Result<bool> held = is_held(file.get());
  if (!held) return {false, path.string() + ": " + held.error().message};
  if (!*held) return {false, "not running: no process holds " + path.string()};
  const std::string full = is_full(directory) ? "; the disk is full, this may be old for that" : "";
  const Result<Health> health = parse_health(read_whole(file.get()));
  if (!health) return {false, path.string() + ": " + health.error().message + full};
  Verdict verdict = judge(*health, now);
  if (!verdict.healthy) verdict.why += full;
  return verdict;
}

int report_health(std::string_view program, const std::filesystem::path& directory) {
  const Verdict verdict = look_at_health(directory, steady_now());
  const std::string line =
      std::string(program) + (verdict.healthy ? ": healthy: " : ": not healthy: ") + one_line(verdict.why) + "\n";
  std::fputs(line.c_str(), verdict.healthy ? stdout : stderr);
  return verdict.healthy ? 0 : 1;
}

}  // namespace weft::process
