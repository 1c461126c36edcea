#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace weft {

/// Takes the first character off `text` and returns its code point; none, and nothing taken, where `text` does not
/// begin with UTF-8 (RFC 3629: no surrogates, nothing longer than it needs to be) or is empty.
std::optional<char32_t> take_code_point(std::string_view& text);

bool is_utf8(std::string_view text);

/// Returns `text` with U+FFFD in place of each byte that is no UTF-8, cut before the first character that would make
/// it longer than `most` bytes.
std::string as_utf8(std::string_view text, std::size_t most = std::string_view::npos);

}  // namespace weft
