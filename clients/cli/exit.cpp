#include "clients/cli/exit.hpp"

namespace weft::cli {

Exit exit_of(const Error& error) {
  switch (error.code) {
    case ErrorCode::unavailable:
      return Exit::unreached;
    case ErrorCode::timed_out:
      return Exit::timed_out;
    case ErrorCode::refused:
    case ErrorCode::not_found:
      return Exit::refused;
    case ErrorCode::invalid:
      return Exit::usage;
    case ErrorCode::conflict:
    case ErrorCode::corrupt:
    case ErrorCode::exhausted:
    case ErrorCode::newer:
    case ErrorCode::stale:
    case ErrorCode::internal:
      break;
  }
  return Exit::failed;
}

Exit exit_of(msg::Outcome outcome) {
  switch (outcome) {
    case msg::Outcome::done:
    case msg::Outcome::accepted:
      return Exit::done;
    case msg::Outcome::refused:
      return Exit::refused;
    case msg::Outcome::failed:
    case msg::Outcome::under_way:  // never the last word
      break;
  }
  return Exit::failed;
}

}  // namespace weft::cli
