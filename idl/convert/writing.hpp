#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace weft::convert {

/// Puts a message onto the wire, field by field, as it is: bounds are the reader's business. Its functions are those
/// of Reading, with the names of fields and their bounds left unread.
class Writing {
 public:
  static constexpr bool kReads = false;

  template <class Value, class Wire>
  void any(const Value& value, Wire& wire) {
    if constexpr (requires { value.bytes; })
      wire = value.bytes;
    else if constexpr (requires { value.value; })
      wire = value.value;
    else if constexpr (requires { value.time_since_epoch(); })
      wire = value.time_since_epoch().count();
    else if constexpr (std::is_same_v<Value, Wire>)
      wire = value;
    else
      describe(*this, value, wire);
  }
  template <class Id, class Wire>
  void some(std::string_view, const Id& id, Wire& wire) {
    any(id, wire);
  }
  template <class Value, class Wire>
  void again(std::string_view, const Value& value, Wire& wire, std::string_view) {
    any(value, wire);
  }
  void finite(std::string_view, double value, double& wire) { wire = value; }
  void not_negative(std::string_view, double value, double& wire) { wire = value; }
  template <class Number>
  void share(std::string_view, Number value, Number& wire) {
    wire = value;
  }
  template <class Number>
  void at_most(std::string_view, Number value, Number& wire, std::uint64_t) {
    wire = value;
  }
  template <class Number>
  void between(std::string_view, Number value, Number& wire, std::uint64_t, std::uint64_t) {
    wire = value;
  }
  template <class E>
  void choice(std::string_view, E value, std::uint8_t& wire, E, E) {
    wire = static_cast<std::uint8_t>(value);
  }
  void text(std::string_view, const std::string& value, std::string& wire, std::size_t) { wire = value; }
  template <class List>
  void list(std::string_view, const List& values, List& wire, std::size_t) {
    wire = values;
  }
  void texts(std::string_view, const std::vector<std::string>& values, std::vector<std::string>& wire, std::size_t,
             std::size_t) {
    wire = values;
  }
  template <class Id, class Wire>
  void maybe(std::string_view, const std::optional<Id>& id, bool& has, Wire& wire) {
    has = id.has_value();
    any(id.value_or(Id{}), wire);
  }
  /// Says whether what follows is there, and returns true: what is not there travels empty.
  bool is_there(bool is, bool& has) {
    has = is;
    return true;
  }
  template <class Value, class Wire>
  void in(std::string_view, const Value& value, Wire& wire) {
    describe(*this, value, wire);
  }
  template <class Value, class Wire>
  void each(std::string_view field, const std::vector<Value>& values, std::vector<Wire>& wire, std::size_t most) {
    const std::size_t size = entries(field, values, wire, most);
    for (std::size_t i = 0; i < size; ++i) describe(*this, values[i], wire[i]);
  }
  template <class Value, class Wire>
  std::size_t entries(std::string_view, const std::vector<Value>& values, std::vector<Wire>& wire, std::size_t) {
    wire.resize(values.size());
    return wire.size();
  }
  void require(bool, std::string_view, std::string_view) {}
  void require_at_most(std::uint64_t, std::uint64_t, std::string_view, std::string_view = {}) {}
};

}  // namespace weft::convert
