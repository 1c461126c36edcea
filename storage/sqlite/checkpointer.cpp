#include "storage/sqlite/checkpointer.hpp"

#include <tuple>
#include <utility>

namespace weft::storage::sqlite {
namespace {

constexpr std::uint64_t kPagesWorthIt = 1000;  // SQLite's own figure
constexpr std::uint64_t kPagesAtMost = 16'000;

}  // namespace

Result<std::unique_ptr<Checkpointer>> Checkpointer::start(const std::filesystem::path& file, const std::string& vfs) {
  auto database = Database::open(file, vfs);
  if (!database) return fail(database.error());
  if (auto done = database->run("PRAGMA synchronous = FULL"); !done) return fail(done.error());
  return std::unique_ptr<Checkpointer>(new Checkpointer(std::move(*database)));
}

Checkpointer::Checkpointer(Database database) : database_(std::move(database)), thread_([this] { work(); }) {}

Checkpointer::~Checkpointer() {
  {
    const std::scoped_lock lock(mutex_);
    is_over_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

bool Checkpointer::log_has(std::uint64_t pages) {
  if (pages < kPagesWorthIt) return false;
  {
    const std::scoped_lock lock(mutex_);
    is_wanted_ = true;
  }
  changed_.notify_one();
  return pages >= kPagesAtMost;
}

void Checkpointer::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return is_wanted_ || is_over_; });
    if (is_over_) return;
    is_wanted_ = false;
    lock.unlock();
    // What failed now is tried again after a next commit. Nothing is lost: it stays in the log.
    std::ignore = database_.empty_log();
    lock.lock();
  }
}

}  // namespace weft::storage::sqlite
