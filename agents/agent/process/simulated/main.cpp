#include <array>

#include "agents/agent/process/recorded_body.hpp"
#include "agents/agent/process/run_program.hpp"
#include "agents/agent/process/simulated/simulated_body.hpp"

int main(int argc, char** argv) {
  static constexpr std::array kBodies = {weft::agents::kSimulatedBody, weft::agents::kRecordedBody};
  return weft::agents::run_program({"weft-agent-sim", kBodies}, argc, argv);
}
