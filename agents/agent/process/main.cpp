#include <cstdio>
#include <exception>
#include <variant>

#include "agents/agent/process/options.hpp"
#include "agents/agent/process/run.hpp"
#include "core/text.hpp"

int main(int argc, char** argv) {
  try {
    const auto parsed = weft::agents::parse_options(argc, argv);
    if (const auto* const leave = std::get_if<weft::agents::Leave>(&parsed)) {
      std::fputs(leave->text.c_str(), leave->exit_code == 0 ? stdout : stderr);
      return leave->exit_code;
    }
    const weft::Result<void> ran = weft::agents::run(std::get<weft::agents::Options>(parsed));
    if (ran) return 0;
    std::fprintf(stderr, "weft-agent: %s\n", weft::one_line(ran.error().message).c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "weft-agent: ended by a defect: %s\n", error.what());
  }
  return 1;
}
