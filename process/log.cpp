#include "process/log.hpp"

#include <spdlog/sinks/stdout_sinks.h>

#include <cstdio>
#include <memory>
#include <utility>

#include "core/text.hpp"
#include "process/clocks.hpp"

namespace weft::process {

Log::Log(std::string program, LogFormat format, spdlog::sink_ptr sink)
    : program_(std::move(program)), format_(format), logger_(program_, std::move(sink)) {
  logger_.set_pattern("%v");
  logger_.flush_on(spdlog::level::info);
}

Log Log::to_standard_error(std::string program, LogFormat format) {
  return {std::move(program), format, std::make_shared<spdlog::sinks::stderr_sink_mt>()};
}

void Log::write(spdlog::level::level_enum level, std::string_view event, std::string_view message,
                std::vector<LogField> about) {
  if (format_ == LogFormat::json) about.insert(about.begin(), always_.begin(), always_.end());
  const spdlog::string_view_t name = spdlog::level::to_string_view(level);
  const LogLine line{.at = wall_now(),
                     .level = {name.data(), name.size()},
                     .program = program_,
                     .event = event,
                     .message = message,
                     .fields = std::move(about)};
  const std::string text = format_ == LogFormat::json ? to_json(line) : to_text(line);
  logger_.log(level, spdlog::string_view_t(text.data(), text.size()));
}

void print_failure(std::string_view program, LogFormat format, std::string_view why) {
  const std::string text = one_line(std::string(why));
  const LogLine line{
      .at = wall_now(), .level = "error", .program = program, .event = {}, .message = text, .fields = {}};
  const std::string put = format == LogFormat::json ? to_json(line) : std::string(program) + ": " + text;
  std::fprintf(stderr, "%s\n", put.c_str());
}

}  // namespace weft::process
