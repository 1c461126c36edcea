#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/bytes.hpp"
#include "core/ids.hpp"

namespace weft::contract {

/// Names what a test and its peer processes tell each other over pipes.
enum class Op : std::uint8_t { opened = 1, failed, publish, result, forget, delivery, ask_counters, counters };

struct Frame {
  Op op{};
  std::uint8_t number = 0;  ///< topic; of a result the error's code, 255 for none
  PeerId peer;
  Bytes bytes;
};
inline constexpr std::uint8_t kNoError = 255;

/// Writes a frame. Returns false when the other end is gone.
bool write_frame(int fd, const Frame& frame);
/// Reads a frame, blocking until it is there; none when the other end is gone.
std::optional<Frame> read_frame(int fd);

Bytes bytes_of(std::string_view text);
std::string text_of(const Bytes& bytes);

}  // namespace weft::contract
