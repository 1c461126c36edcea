#pragma once
#include "core/result.hpp"

namespace weft {

inline constexpr int kFailed = 1;  ///< exit code of a program that cannot work now; starting it again may help
inline constexpr int kWrong = 2;   ///< of one that was told something wrong: no service manager starts it again

/// Returns the exit code of a program that could not begin its work: kWrong where a setting, or a file that one
/// names, breaks its bounds or is not there, since that stays so; kFailed for all other errors.
constexpr int exit_code_of(ErrorCode code) {
  return code == ErrorCode::invalid || code == ErrorCode::not_found ? kWrong : kFailed;
}

}  // namespace weft
