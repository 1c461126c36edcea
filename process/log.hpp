#pragma once
#include <spdlog/logger.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "process/log_line.hpp"

namespace weft::process {

/// Writes a program's log, one event a line, each at once. Any thread may write.
class Log {
 public:
  Log(std::string program, LogFormat format, spdlog::sink_ptr sink);
  /// Returns a log to standard error.
  static Log to_standard_error(std::string program, LogFormat format);

  /// Sets fields that every line of json has from now on. To be called before other threads write.
  void always_about(std::vector<LogField> fields) { always_ = std::move(fields); }

  void info(std::string_view message, std::vector<LogField> about = {}) {
    write(spdlog::level::info, {}, message, std::move(about));
  }
  void warn(std::string_view message, std::vector<LogField> about = {}) {
    write(spdlog::level::warn, {}, message, std::move(about));
  }
  void error(std::string_view message, std::vector<LogField> about = {}) {
    write(spdlog::level::err, {}, message, std::move(about));
  }
  /// Writes an event, of a dotted kind.
  void event(std::string_view kind, std::string_view cause, std::vector<LogField> about) {
    write(spdlog::level::info, kind, cause, std::move(about));
  }

 private:
  void write(spdlog::level::level_enum level, std::string_view event, std::string_view message,
             std::vector<LogField> about);

  std::string program_;
  LogFormat format_;
  std::vector<LogField> always_;
  spdlog::logger logger_;  // puts lines out whole, whichever thread they come from
};

/// Prints why a program ends to standard error: in one line, as people or as readers of its log take it.
void print_failure(std::string_view program, LogFormat format, std::string_view why);

}  // namespace weft::process
