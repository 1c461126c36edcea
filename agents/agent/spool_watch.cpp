#include "agents/agent/spool_watch.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace weft::agents {
namespace {

constexpr Duration kBetweenTrials = std::chrono::seconds(5);
constexpr std::uint64_t kRecord = 4096;  ///< bytes of a batch without its contents, about, and of any small file

std::uint64_t bytes_of(const std::vector<Bytes>& contents) {
  std::uint64_t bytes = kRecord;
  for (const Bytes& content : contents) bytes += content.size();
  return bytes;
}

/// Returns whether the disk is at fault, not what it was given.
bool is_of_the_disk(const Error& error) {
  return error.code == ErrorCode::exhausted || error.code == ErrorCode::unavailable;
}

}  // namespace

void SpoolWatch::tick(SteadyTime now) {
  if (refuses_.empty()) return;
  if (try_at_ && now < *try_at_) return;
  const bool is_time = try_at_.has_value();
  try_at_ = now + kBetweenTrials;
  if (is_time) std::ignore = try_room(needs_);
}

Result<void> SpoolWatch::append(const Batch& batch, const std::vector<Bytes>& contents) {
  return noted(spool_.append(batch, contents), bytes_of(contents));
}

Result<void> SpoolWatch::replace(ExperienceId experience, const std::vector<Batch>& batches,
                                 const std::vector<Bytes>& contents) {
  return noted(spool_.replace(experience, batches, contents), batches.size() * kRecord + bytes_of(contents));
}

Result<void> SpoolWatch::acknowledged(ExperienceId experience, std::uint64_t through) {
  return noted(spool_.acknowledged(experience, through), kRecord);
}

Result<void> SpoolWatch::keep(const storage::Stops& stops) {
  return noted(spool_.keep(stops), kRecord);
}

Result<void> SpoolWatch::noted(Result<void> done, std::uint64_t bytes) {
  if (!done && is_of_the_disk(done.error())) {
    if (refuses_.empty()) refuses_ = done.error().message;  // trials name a file that nobody knows
    needs_ = std::max(needs_, bytes);
  } else if (done && bytes >= needs_) {
    refuses_.clear();
    needs_ = 0;
    try_at_.reset();
  }
  return done;
}

}  // namespace weft::agents
