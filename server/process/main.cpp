#include <cstdio>
#include <exception>
#include <variant>

#include "core/text.hpp"
#include "server/process/options.hpp"
#include "server/process/run.hpp"

int main(int argc, char** argv) {
  try {
    const std::variant<weft::server::Options, weft::server::Leave> parsed = weft::server::parse_options(argc, argv);
    if (const auto* const leave = std::get_if<weft::server::Leave>(&parsed)) {
      std::fputs(leave->text.c_str(), leave->exit_code == 0 ? stdout : stderr);
      return leave->exit_code;
    }
    const weft::Result<void> ran = weft::server::run(std::get<weft::server::Options>(parsed));
    if (ran) return 0;
    std::fprintf(stderr, "weft-server: %s\n", weft::one_line(ran.error().message).c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "weft-server: ended by a defect: %s\n", error.what());
  }
  return 1;
}
