#pragma once
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace weft::test {

/// Holds a DDS domain in 100 to 149 that no other process of the tests has while this lives: tests run side by side,
/// and a server's port is its domain's. The lock goes with the process, however it ends.
class OwnDomain {
 public:
  OwnDomain() {
    for (unsigned tries = 0; tries < kDomains; ++tries) {
      number_ = kFirst + (static_cast<unsigned>(getpid()) + tries) % kDomains;
      const auto path = std::filesystem::temp_directory_path() / ("weft-test-domain-" + std::to_string(number_));
      // Made by whoever came first, and locked by any user after: a lock needs no right to write.
      lock_ = open(path.c_str(), O_RDONLY | O_CLOEXEC);
      if (lock_ < 0) lock_ = open(path.c_str(), O_RDONLY | O_CREAT | O_CLOEXEC, 0644);
      if (lock_ >= 0 && flock(lock_, LOCK_EX | LOCK_NB) == 0) return;
      if (lock_ >= 0) close(lock_);
    }
    throw std::runtime_error("every DDS domain of the tests is taken");
  }
  OwnDomain(const OwnDomain&) = delete;
  OwnDomain& operator=(const OwnDomain&) = delete;
  ~OwnDomain() { close(lock_); }

  unsigned number() const { return number_; }

 private:
  static constexpr unsigned kFirst = 100;
  static constexpr unsigned kDomains = 50;
  unsigned number_ = 0;
  int lock_ = -1;
};

}  // namespace weft::test
