#pragma once
#include "core/protocol/messages.hpp"
#include "core/result.hpp"

namespace weft::server {

/// Returns refused for an error that the asker can mend, failed for ours: a store that takes nothing has failed.
inline msg::Outcome outcome_of(const Error& error) {
  switch (error.code) {
    case ErrorCode::invalid:
    case ErrorCode::not_found:
    case ErrorCode::refused:
    case ErrorCode::conflict:
      return msg::Outcome::refused;
    default:
      return msg::Outcome::failed;
  }
}

}  // namespace weft::server
