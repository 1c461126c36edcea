#pragma once
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/ids.hpp"
#include "core/result.hpp"
#include "core/time.hpp"

namespace weft::convert {

/// Takes a message from the wire, field by field, and notes the first field that is out of its bound. Each function
/// is named by what it demands of a field; Writing has the same ones, so that one visitor, `describe`, serves both
/// ways. Values are taken over right or wrong: after a complaint `finish` gives the error and no message.
class Reading {
 public:
  static constexpr bool kReads = true;

  explicit Reading(std::string_view message) : name_(message) {}
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;

  /// Takes a field of which every value is valid.
  template <class Value, class Wire>
  void any(Value& value, const Wire& wire) {
    if constexpr (requires { value.bytes; })
      value.bytes = wire;
    else if constexpr (requires { value.value; })
      value.value = wire;
    else if constexpr (requires { value.time_since_epoch(); })
      value = Value(Duration(wire));
    else if constexpr (std::is_same_v<Value, Wire>)
      value = wire;
    else
      describe(*this, value, wire);
  }
  /// Takes an id that must not be none.
  template <class Id, class Wire>
  void some(std::string_view field, Id& id, const Wire& wire) {
    any(id, wire);
    require(bool(id), field, "must not be none");
  }
  /// Demands that the wire says again what another field has said.
  template <class Value, class Wire>
  void again(std::string_view field, const Value& value, const Wire& wire, std::string_view bound) {
    require(value.bytes == wire, field, bound);
  }
  void finite(std::string_view field, double& value, double wire) {
    value = wire;
    require(std::isfinite(value), field, "must be finite");
  }
  void not_negative(std::string_view field, double& value, double wire) {
    value = wire;
    require(std::isfinite(value) && value >= 0.0, field, "must be finite and not negative");
  }
  /// Takes a share of a whole.
  template <class Number>
  void share(std::string_view field, Number& value, Number wire) {
    value = wire;
    require(value >= Number{0} && value <= Number{1}, field, "must be from 0 to 1");
  }
  template <class Number>
  void at_most(std::string_view field, Number& value, Number wire, std::uint64_t most) {
    value = wire;
    require_at_most(value, most, field);
  }
  template <class Number>
  void between(std::string_view field, Number& value, Number wire, std::uint64_t least, std::uint64_t most) {
    value = wire;
    if (value < least || value > most) complain_of_range(field, least, most);
  }
  /// Takes an enumeration whose values run from `first` to `last` without gaps.
  template <class E>
  void choice(std::string_view field, E& value, std::uint8_t wire, E first, E last) {
    value = static_cast<E>(wire);
    if (value < first || value > last) {
      complain_of_range(field, static_cast<std::uint64_t>(first), static_cast<std::uint64_t>(last));
    }
  }
  /// Takes text of at most so many bytes.
  void text(std::string_view field, std::string& value, const std::string& wire, std::size_t most);
  /// Takes a list of at most so many texts.
  void texts(std::string_view field, std::vector<std::string>& values, const std::vector<std::string>& wire,
             std::size_t most, std::size_t longest);
  /// Takes a list of numbers of which every value is valid.
  template <class List>
  void list(std::string_view field, List& values, const List& wire, std::size_t most) {
    if (has_at_most(field, wire.size(), most)) values = wire;
  }
  /// Takes an id that the sender may leave out.
  template <class Id, class Wire>
  void maybe(std::string_view field, std::optional<Id>& id, bool has, const Wire& wire) {
    if (has) some(field, id.emplace(), wire);
  }
  /// Returns whether the sender says that what follows is there.
  bool is_there(bool /*is*/, bool has) { return has; }

  /// Takes a structure; complaints in it name the way there.
  template <class Value, class Wire>
  void in(std::string_view field, Value& value, const Wire& wire) {
    Reading inside(*this, field, std::nullopt);
    describe(inside, value, wire);
  }
  /// Takes a list of structures.
  template <class Value, class Wire>
  void each(std::string_view field, std::vector<Value>& values, const std::vector<Wire>& wire, std::size_t most) {
    const std::size_t size = entries(field, values, wire, most);
    for (std::size_t i = 0; i < size && ok(); ++i) {
      Reading inside(*this, field, i);
      describe(inside, values[i], wire[i]);
    }
  }
  /// Gives `values` the length of the wire's list and returns it; 0 for a list that is too long.
  template <class Value, class Wire>
  std::size_t entries(std::string_view field, std::vector<Value>& values, const std::vector<Wire>& wire,
                      std::size_t most) {
    values.resize(has_at_most(field, wire.size(), most) ? wire.size() : 0);
    return values.size();
  }

  void require(bool holds, std::string_view field, std::string_view bound) {
    if (!holds) complain(field, bound);
  }
  /// Notes an error when the number is too large. `unit` ends its sentence, as in "must be at most 500 together".
  void require_at_most(std::uint64_t number, std::uint64_t most, std::string_view field, std::string_view unit = {});
  void complain(std::string_view field, std::string_view bound);

  bool ok() const { return !root().error_; }
  template <class T>
  Result<T> finish(T value) const {
    if (root().error_) return fail(ErrorCode::invalid, *root().error_);
    return value;
  }

 private:
  Reading(Reading& parent, std::string_view name, std::optional<std::size_t> index)
      : parent_(&parent), name_(name), index_(index) {}
  bool has_at_most(std::string_view field, std::size_t size, std::size_t most);
  void complain_of_range(std::string_view field, std::uint64_t least, std::uint64_t most);
  const Reading& root() const { return parent_ == nullptr ? *this : parent_->root(); }
  Reading& root() { return parent_ == nullptr ? *this : parent_->root(); }
  std::string path() const;

  Reading* parent_ = nullptr;
  std::string_view name_;
  std::optional<std::size_t> index_;
  std::optional<std::string> error_;  ///< root only
};

}  // namespace weft::convert
