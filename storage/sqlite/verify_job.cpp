#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "storage/sqlite/jobs.hpp"
#include "storage/sqlite/verification.hpp"

namespace weft::storage::sqlite {
namespace {
using namespace std::chrono_literals;

constexpr auto kAtMostAStep = 5ms;

/// Verifies on a thread of its own, because SQLite's look at all pages is one statement; a step waits a little for
/// news of it. The thread has its own files and a map that nobody changes, and ends with the job.
class VerifyJob final : public StoreJob {
 public:
  VerifyJob(std::filesystem::path file, Snapshot live)
      : file_(std::move(file)), live_(std::move(live)), thread_([this] { work(); }) {}
  ~VerifyJob() override {
    is_dropped_ = true;
    thread_.join();
  }
  VerifyJob(const VerifyJob&) = delete;
  VerifyJob& operator=(const VerifyJob&) = delete;

  Result<JobProgress> step() override {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, kAtMostAStep, [this] { return ended_.has_value(); });
    if (ended_) return *ended_;
    return progress_;
  }

 private:
  void work() {
    RestoreOptions options;
    options.stops = [this] { return is_dropped_.load(); };
    options.progress = [this](const RestoreProgress& now) {
      const std::scoped_lock lock(mutex_);
      progress_.done = now.done;
      progress_.total = now.total;
      progress_.unit = now.unit + " (" + now.stage + ")";
    };
    Result<JobProgress> ended = ended_with(verify_snapshot(file_, live_, options));
    {
      const std::scoped_lock lock(mutex_);
      ended_ = std::move(ended);
    }
    changed_.notify_one();
  }

  Result<JobProgress> ended_with(Result<Verified> verified) const {
    const bool is_no_store =
        !verified && (verified.error().code == ErrorCode::corrupt || verified.error().code == ErrorCode::newer);
    if (!verified && !is_no_store) return fail(verified.error());
    JobProgress last;
    last.done = last.total = 1;
    last.unit = "map";
    last.finished = true;
    last.findings = is_no_store ? std::vector{verified.error().message} : std::move(verified->findings);
    last.summary =
        last.findings.empty()
            ? "it was restored beside it, checked, and is the map: " + to_text(verified->restored)
            : "it does not restore to the map, so do not rely on it: take another snapshot; weft map check "
              "says whether the store itself is damaged";
    return last;
  }

  const std::filesystem::path file_;
  const Snapshot live_;
  std::atomic<bool> is_dropped_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  JobProgress progress_;                      // guarded
  std::optional<Result<JobProgress>> ended_;  // guarded
  std::thread thread_;                        // last: it begins when all the others are there
};

}  // namespace

Result<std::unique_ptr<StoreJob>> make_verification(const std::filesystem::path& file, const Snapshot& live) {
  return std::make_unique<VerifyJob>(std::filesystem::absolute(file), live);
}

}  // namespace weft::storage::sqlite
