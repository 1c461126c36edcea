#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/time.hpp"

namespace weft::process {

enum class LogFormat : std::uint8_t { text, json };

/// Names something that a line is about: {"goal", "4f2c..."}. One without a value is left out.
struct LogField {
  std::string_view name;
  std::string value;
};

/// Holds one line of a program's log.
struct LogLine {
  WallTime at{};
  std::string_view level;
  std::string_view program;
  std::string_view event;  ///< dotted kind, as events have it; empty: none
  std::string_view message;
  std::vector<LogField> fields;
};

/// Returns the line without its line break, on one line whatever the message holds. Text is
/// `TIME LEVEL PROGRAM: [EVENT: ]MESSAGE[ (NAME VALUE, ...)]`; json an object with `time`, `level`, `program`,
/// `event`, `message` and the fields, all strings; what is no UTF-8 is replaced.
std::string to_text(const LogLine& line);
std::string to_json(const LogLine& line);

}  // namespace weft::process
