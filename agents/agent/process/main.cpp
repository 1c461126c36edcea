#include <array>

#include "agents/agent/process/recorded_body.hpp"
#include "agents/agent/process/run_program.hpp"

int main(int argc, char** argv) {
  static constexpr std::array kBodies = {weft::agents::kRecordedBody};
  return weft::agents::run_program({"weft-agent", kBodies}, argc, argv);
}
