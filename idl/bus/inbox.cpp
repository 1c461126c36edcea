#include "idl/bus/inbox.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <ctime>
#include <system_error>

#include "idl/bus/padding.hpp"

namespace weft::bus {

Inbox::Inbox(std::size_t messages) : messages_(messages), event_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
  if (event_ < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
}

Inbox::~Inbox() {
  close(event_);
}

void Inbox::put(const Topic& topic, ByteView padded) {
  {
    const std::lock_guard lock(mutex_);
    if (padded.size() > topic.max_bytes + kMostPadding) {
      ++counters_.refused_size;
      return;
    }
    Bytes cdr = without_padding(padded);
    if (cdr.size() > topic.max_bytes) {
      ++counters_.refused_size;
      return;
    }
    ++counters_.received;
    if (topic.bulk) bulk_bytes_ += cdr.size();
    (topic.bulk ? bulk_ : small_).push_back({arrived_++, {topic.id, std::move(cdr)}});
    for (; bulk_bytes_ > kInboxBulkBytes; bulk_.pop_front(), ++counters_.dropped_inbox) {
      bulk_bytes_ -= bulk_.front().delivery.cdr.size();
    }
    for (; small_.size() > messages_; small_.pop_front()) ++counters_.dropped_inbox;
  }
  wake();
}

void Inbox::count_refused_by_vendor() {
  const std::lock_guard lock(mutex_);
  ++counters_.refused_vendor;
}

std::optional<Delivery> Inbox::take() {
  const std::lock_guard lock(mutex_);
  const bool bulk_first = !bulk_.empty() && (small_.empty() || bulk_.front().number < small_.front().number);
  std::deque<Waiting>& from = bulk_first ? bulk_ : small_;
  if (from.empty()) return std::nullopt;
  Delivery first = std::move(from.front().delivery);
  from.pop_front();
  if (bulk_first) bulk_bytes_ -= first.cdr.size();
  return first;
}

bool Inbox::wait(Duration at_most) {
  {
    const std::lock_guard lock(mutex_);
    if (!small_.empty() || !bulk_.empty()) return true;
  }
  constexpr Duration::rep kSecond = 1'000'000'000;
  const Duration::rep left = std::max<Duration::rep>(at_most.count(), 0);
  const timespec limit{left / kSecond, left % kSecond};
  pollfd waited{event_, POLLIN, 0};
  if (ppoll(&waited, 1, &limit, nullptr) <= 0) return false;
  std::uint64_t count = 0;
  return read(event_, &count, sizeof count) == sizeof count;
}

void Inbox::wake() const {
  const std::uint64_t one = 1;
  // Fails only when the counter is full, and then the event is readable anyway.
  [[maybe_unused]] const ssize_t written = write(event_, &one, sizeof one);
}

void Inbox::count_publish(const Result<void>& published, bool oversized) {
  const std::lock_guard lock(mutex_);
  ++(published ? counters_.sent : oversized ? counters_.refused_size : counters_.publish_failed);
}

BusCounters Inbox::counters() const {
  const std::lock_guard lock(mutex_);
  BusCounters counters = counters_;
  counters.waiting = small_.size() + bulk_.size();
  return counters;
}

}  // namespace weft::bus
