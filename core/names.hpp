#pragma once
#include <string_view>

#include "core/result.hpp"

namespace weft {

inline constexpr std::size_t kLongestName = 64;  ///< bytes of a name, a label or a method

/// States the rule for labels and for the names of robots and of what is taught, in words for help and errors.
inline constexpr std::string_view kNameRule =
    "1 to 64 bytes of letters and digits of any script, '_', '.' and '-', beginning with a letter or a digit";

/// Returns nothing for a name that keeps the rule. invalid: says which `kind` of name ("label", "robot") breaks it
/// and by what.
Result<void> check_name(std::string_view kind, std::string_view name);

}  // namespace weft
