#pragma once
#include <unistd.h>

#include <cstdint>

#include "core/bytes.hpp"
#include "tests/storage/sample_map.hpp"

/// Holds what goes between the processes of a round: producers and keeper over a socket each, all of them to whoever
/// watches over one pipe.
namespace weft::crashes {

/// Tells the watcher what happened; written at once, so that it is there as a whole or not at all.
struct Report {
  enum class Kind : std::uint32_t { acknowledged, edited, floored, snapshot };
  Kind kind = Kind::acknowledged;
  std::uint32_t producer = 0;
  std::uint64_t number = 0;    ///< the batch's sequence; of an edit: which (see Edit)
  std::uint64_t revision = 0;  ///< that it made
};

enum class Edit : std::uint64_t { out, back, rollback, label };

/// Carries the keeper's answer to a producer.
struct Answer {
  std::uint64_t sequence = 0;  ///< through which the experience is durable
  std::uint64_t revision = 0;
};

inline bool read_whole(int from, void* data, std::size_t size) {
  auto* at = static_cast<std::uint8_t*>(data);
  while (size > 0) {
    const ssize_t got = ::read(from, at, size);
    if (got <= 0) return false;
    at += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

inline bool write_whole(int to, const void* data, std::size_t size) {
  const auto* at = static_cast<const std::uint8_t*>(data);
  while (size > 0) {
    const ssize_t written = ::write(to, at, size);
    if (written <= 0) return false;
    at += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

template <class Message>
bool receive(int from, Message& message) {
  return read_whole(from, &message, sizeof message);
}
template <class Message>
bool send(int to, const Message& message) {
  return write_whole(to, &message, sizeof message);
}

/// Carry a batch with its contents from a producer to the keeper.
bool send_delivery(int to, const storage::sample::Delivery& delivery);
bool receive_delivery(int from, storage::sample::Delivery& delivery);

}  // namespace weft::crashes
