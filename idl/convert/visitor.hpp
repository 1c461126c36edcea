#pragma once
#include <type_traits>

#include "idl/convert/reading.hpp"
#include "idl/convert/writing.hpp"

/// Converts between core and IDL. Each structure of the wire has one visitor,
///
///     template <class Io>
///     void describe(Io& io, Value<Io, msg::ClockProbe>& value, Wire<Io, idl::ClockProbe>& wire);
///
/// which lists its fields with their bounds, once for both ways: Io is Writing or Reading. Fields are checked in the
/// order in which the visitor lists them; a check of several fields (`io.require`) stands behind the last of them.
namespace weft::convert {

/// Is a structure as the inside of a process knows it: written to when a message is read.
template <class Io, class T>
using Value = std::conditional_t<Io::kReads, T, const T>;
/// Is the same structure as idl/messages declares it: written to when a message is written.
template <class Io, class T>
using Wire = std::conditional_t<Io::kReads, const T, T>;

template <class WireType, class T>
WireType to_idl(const T& value) {
  Writing io;
  WireType wire;
  describe(io, value, wire);
  return wire;
}

/// Converts and validates a message. invalid: names the message, the first field out of its bound, and the bound.
template <class T, class WireType>
Result<T> from_idl(const WireType& wire, std::string_view name) {
  Reading io(name);
  T value;
  describe(io, value, wire);
  return io.finish(std::move(value));
}

}  // namespace weft::convert
