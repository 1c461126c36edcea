#include "tests/contract/bus/frames.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <string_view>

namespace weft::contract {
namespace {

struct Head {
  std::uint8_t op, number;
  std::uint8_t peer[16];
  std::uint32_t size;
};

/// Bounds a frame: more is no frame but something else that was written to the pipe.
constexpr std::uint32_t kMostBytes = 256U << 20;

bool write_all(int fd, const void* data, std::size_t size) {
  const auto* at = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = write(fd, at, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    at += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

bool read_all(int fd, void* data, std::size_t size) {
  auto* at = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t got = read(fd, at, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

}  // namespace

bool write_frame(int fd, const Frame& frame) {
  Head head{static_cast<std::uint8_t>(frame.op), frame.number, {}, static_cast<std::uint32_t>(frame.bytes.size())};
  std::memcpy(head.peer, frame.peer.bytes.data(), sizeof head.peer);
  return write_all(fd, &head, sizeof head) && write_all(fd, frame.bytes.data(), frame.bytes.size());
}

std::optional<Frame> read_frame(int fd) {
  Head head{};
  if (!read_all(fd, &head, sizeof head) || head.size > kMostBytes) return std::nullopt;
  Frame frame{static_cast<Op>(head.op), head.number, {}, Bytes(head.size)};
  std::memcpy(frame.peer.bytes.data(), head.peer, sizeof head.peer);
  if (!read_all(fd, frame.bytes.data(), frame.bytes.size())) return std::nullopt;
  return frame;
}

Bytes bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}

std::string text_of(const Bytes& bytes) {
  return {bytes.begin(), bytes.end()};
}

}  // namespace weft::contract
