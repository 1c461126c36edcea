#pragma once
#include <string>

namespace weft {

/// For messages that end a program: line breaks at the end go, those in between become "; ".
std::string one_line(std::string text);

}  // namespace weft
