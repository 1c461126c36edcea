#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "idl/bus/addresses.hpp"
#include "idl/bus/inbox.hpp"
#include "idl/bus/topics.hpp"

namespace weft::bus {

/// Is one vendor's member of a DDS domain, at fixed addresses. Puts what comes into the inbox that it was given,
/// from the vendor's threads; is called by one thread at a time. Destruction leaves the domain and says so to the
/// others.
class Participant {
 public:
  virtual ~Participant() = default;
  /// Sends a message that check_publish let through. unavailable: the vendor's queue stayed full.
  virtual Result<void> write(const Topic& topic, const PeerId& to, ByteView cdr) = 0;
  /// Drops the means to write to the peer, and what waits for it.
  virtual void forget(const PeerId& peer) = 0;
  /// Does the same for each peer that has had no reader for `kReaderless`: what is kept for clients that are gone
  /// would make every later one dearer.
  virtual void forget_readerless(SteadyTime now) = 0;
  /// Returns whether it can be reached. Not where the interface failed while it was made, which it does not mend.
  virtual bool is_bound() const = 0;
  /// Returns how many peers it has the means to write to.
  virtual std::size_t peers() const = 0;
};

/// Bounds how long a peer may be without a reader; longer than any addressed message waits for its reader.
inline constexpr Duration kReaderless = std::chrono::seconds(10);

/// Remembers since when a peer has had no reader.
class Readers {
 public:
  bool are_gone(SteadyTime now, bool is_read) {
    if (is_read)
      gone_since_.reset();
    else if (!gone_since_)
      gone_since_ = now;
    return gone_since_ && now - *gone_since_ >= kReaderless;
  }

 private:
  std::optional<SteadyTime> gone_since_;
};

using JoinDomain = std::function<Result<std::unique_ptr<Participant>>(const Addresses&, Inbox&)>;

}  // namespace weft::bus
