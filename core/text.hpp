#pragma once
#include <string>
#include <string_view>

namespace weft {

/// Puts a text on one line, for messages that end a program: line breaks at the end go, those in between become "; ".
std::string one_line(std::string text);

/// The text without the UTF-8 byte order mark that some editors put before it. Every reader of text begins with this.
std::string_view without_byte_order_mark(std::string_view text);

}  // namespace weft
