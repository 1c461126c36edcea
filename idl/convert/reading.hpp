#pragma once
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/ids.hpp"
#include "core/result.hpp"
#include "core/time.hpp"

namespace weft::convert {

/// Where from_idl is in a message, and the first thing that it found wrong there. Values are handed back as they
/// are, right or wrong: after a complaint the caller's result is thrown away by `finish`.
class Reading {
 public:
  explicit Reading(std::string_view message) : name_(message) {}
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;

  /// A field inside: complaints in it name the way there and count for the whole message.
  Reading here() { return {*this, {}, std::nullopt}; }
  Reading in(std::string_view field) { return {*this, field, std::nullopt}; }
  Reading in(std::string_view field, std::size_t index) { return {*this, field, index}; }

  void require(bool holds, std::string_view field, std::string_view bound) {
    if (!holds) complain(field, bound);
  }
  void complain(std::string_view field, std::string_view bound);

  double finite(std::string_view field, double value) {
    require(std::isfinite(value), field, "must be finite");
    return value;
  }
  double not_negative(std::string_view field, double value) {
    require(std::isfinite(value) && value >= 0.0, field, "must be finite and not negative");
    return value;
  }
  std::string text(std::string_view field, const std::string& value, std::size_t most);
  template <class List>
  const List& list(std::string_view field, const List& value, std::size_t most) {
    if (value.size() > most) complain(field, "has more than " + std::to_string(most) + " entries");
    return value;
  }
  /// An enumeration whose values run from `first` to `last` without gaps.
  template <class E>
  E choice(std::string_view field, std::uint8_t value, E first, E last) {
    if (value < static_cast<std::uint8_t>(first) || value > static_cast<std::uint8_t>(last)) {
      complain(field, "must be from " + std::to_string(static_cast<unsigned>(first)) + " to " +
                          std::to_string(static_cast<unsigned>(last)));
    }
    return static_cast<E>(value);
  }
  template <class Id>
  Id some(std::string_view field, Id id) {
    require(bool(id), field, "must not be none");
    return id;
  }

  bool ok() const { return !root().error_; }
  template <class T>
  Result<T> finish(T value) const {
    if (root().error_) return fail(ErrorCode::invalid, *root().error_);
    return value;
  }

 private:
  Reading(Reading& parent, std::string_view name, std::optional<std::size_t> index)
      : parent_(&parent), name_(name), index_(index) {}
  const Reading& root() const { return parent_ == nullptr ? *this : parent_->root(); }
  Reading& root() { return parent_ == nullptr ? *this : parent_->root(); }
  std::string path() const;

  Reading* parent_ = nullptr;
  std::string_view name_;
  std::optional<std::size_t> index_;
  std::optional<std::string> error_;  ///< root only
};

template <class Id, class Array>
Id id_from(const Array& bytes) {
  Id id;
  static_assert(sizeof(id.bytes) == sizeof(bytes));
  id.bytes = bytes;
  return id;
}
inline std::int64_t nanoseconds(WallTime at) {
  return at.time_since_epoch().count();
}
inline WallTime wall_from(std::int64_t nanoseconds) {
  return WallTime(Duration(nanoseconds));
}

}  // namespace weft::convert
