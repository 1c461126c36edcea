#pragma once
#include <cstdint>
#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace weft {

/// Tells the kind of a failure, for code that decides; the message is for people.
enum class ErrorCode : std::uint8_t {
  invalid,      ///< input breaks a stated bound
  not_found,    ///< named thing does not exist
  refused,      ///< understood, and not done for a named reason
  conflict,     ///< contradicts what is already stored
  corrupt,      ///< bytes do not match their checksum or format
  unavailable,  ///< peer, port, device or file cannot be reached now; retry may help
  exhausted,    ///< disk, memory or budget is full
  newer,        ///< written by a newer version than this one
  stale,        ///< from an older epoch or revision
  timed_out,
  internal,  ///< a defect of ours
};
const char* to_string(ErrorCode code);

/// Describes a failure: `message` names what, where, which bound, and what to do.
struct Error {
  ErrorCode code = ErrorCode::internal;
  std::string message;
};

/// Holds a value or an Error. Expected failure is in the signature; a caller's bug is an assert.
template <class T>
class [[nodiscard]] Result : public tl::expected<T, Error> {
 public:
  using tl::expected<T, Error>::expected;
};

inline tl::unexpected<Error> fail(ErrorCode code, std::string message) {
  return tl::unexpected<Error>(Error{code, std::move(message)});
}
inline tl::unexpected<Error> fail(Error error) {
  return tl::unexpected<Error>(std::move(error));
}

}  // namespace weft
