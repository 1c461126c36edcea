#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "core/bytes.hpp"

namespace weft::agents {

/// Writes a content as bytes: little-endian, in order, without padding.
class ContentWriter {
 public:
  template <class T>
  void number(T value) {
    static_assert(std::endian::native == std::endian::little);
    for (const std::uint8_t byte : std::bit_cast<std::array<std::uint8_t, sizeof(T)>>(value)) bytes_.push_back(byte);
  }
  void raw(ByteView view) { bytes_.insert(bytes_.end(), view.begin(), view.end()); }
  Bytes take() { return std::move(bytes_); }

 private:
  Bytes bytes_;
};

/// Reads in order; after the first fault every further read gives zero and the fault stays.
class ContentReader {
 public:
  /// Begins to read `bytes`; `kind` names the content in messages: "floor content".
  ContentReader(ByteView bytes, std::string_view kind) : bytes_(bytes), kind_(kind) {}

  template <class T>
  T number(std::string_view field) {
    T value{};
    if (const ByteView view = raw(field, sizeof(T)); !view.empty()) std::memcpy(&value, view.data(), sizeof(T));
    return value;
  }
  /// Reads a number; it is a fault if it is not finite and in [low, high].
  double real(std::string_view field, double low, double high) {
    const auto value = number<double>(field);
    if (!(value >= low && value <= high)) fault(field, "is out of bounds");
    return value;
  }
  ByteView raw(std::string_view field, std::size_t size) {
    if (faulty() || bytes_.size() - at_ < size) {
      fault(field, "is cut short");
      return {};
    }
    field_at_ = at_;
    at_ += size;
    return bytes_.subspan(at_ - size, size);
  }
  void fault(std::string_view field, std::string_view what) {
    if (faulty()) return;
    message_ = std::string(kind_) + ": " + std::string(field) + " at offset " + std::to_string(field_at_) + " " +
               std::string(what) + "; fetch the content again";
  }
  bool faulty() const { return !message_.empty(); }
  bool at_end() const { return at_ == bytes_.size(); }
  const std::string& message() const { return message_; }

 private:
  ByteView bytes_;
  std::string_view kind_;
  std::size_t at_ = 0;
  std::size_t field_at_ = 0;
  std::string message_;
};

}  // namespace weft::agents
