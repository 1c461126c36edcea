#include <cstdio>
#include <exception>
#include <variant>

#include "process/health_file.hpp"
#include "process/log.hpp"
#include "server/process/options.hpp"
#include "server/process/run.hpp"

int main(int argc, char** argv) {
  try {
    const std::variant<weft::server::Options, weft::server::Leave> parsed = weft::server::parse_options(argc, argv);
    if (const auto* const leave = std::get_if<weft::server::Leave>(&parsed)) {
      std::fputs(leave->text.c_str(), leave->exit_code == 0 ? stdout : stderr);
      return leave->exit_code;
    }
    const auto& options = std::get<weft::server::Options>(parsed);
    if (options.asks_health) return weft::process::report_health("weft-server", options.store);
    const weft::Result<void> ran = weft::server::run(options);
    if (ran) return 0;
    weft::process::print_failure("weft-server", options.log_format, ran.error().message);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "weft-server: ended by a defect: %s\n", error.what());
  }
  return 1;
}
