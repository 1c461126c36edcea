#pragma once
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>

#include "idl/bus/bus.hpp"
#include "idl/bus/topics.hpp"

namespace weft::bus {

/// Queues messages that the vendors' threads put and the owner's thread takes. To put one takes no longer than to
/// copy it.
class Inbox {
 public:
  explicit Inbox(std::size_t messages);
  ~Inbox();
  Inbox(const Inbox&) = delete;
  Inbox& operator=(const Inbox&) = delete;

  /// Takes the vendors' padding off and queues; refuses and counts what exceeds its topic's bound. From any thread.
  void put(const Topic& topic, ByteView padded);
  /// Counts a message that the vendor refused on its own. From any thread.
  void count_refused_by_vendor();

  std::optional<Delivery> take();
  bool wait(Duration at_most);
  /// Ends a wait(). From any thread or signal handler.
  void wake() const;

  void count_publish(const Result<void>& published, bool oversized);
  BusCounters counters() const;

 private:
  struct Waiting {
    std::uint64_t number = 0;  ///< order of arrival over both queues
    Delivery delivery;
  };

  const std::size_t messages_;
  int event_ = -1;  ///< eventfd: readable when something came or someone woke us
  mutable std::mutex mutex_;
  // Guarded by mutex_:
  std::uint64_t arrived_ = 0;
  std::deque<Waiting> small_;
  std::deque<Waiting> bulk_;
  std::size_t bulk_bytes_ = 0;
  BusCounters counters_;
};

}  // namespace weft::bus
