#include <chrono>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string_view>
#include <variant>

#include "agents/agent/process/calibrate/jobs.hpp"
#include "agents/agent/process/options.hpp"
#include "agents/agent/process/run.hpp"
#include "process/health_file.hpp"
#include "process/log.hpp"

namespace {

using namespace weft;

int left(const agents::Leave& leave) {
  std::fputs(leave.text.c_str(), leave.exit_code == 0 ? stdout : stderr);
  return leave.exit_code;
}

double steady_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int ended(const Result<void>& ran, process::LogFormat format = process::LogFormat::text) {
  if (ran) return 0;
  process::print_failure("weft-agent", format, ran.error().message);
  return 1;
}

int calibrate(int argc, const char* const* argv) {
  const auto parsed = agents::parse_calibrate(argc, argv);
  if (const auto* const leave = std::get_if<agents::Leave>(&parsed)) return left(*leave);
  const agents::JobOutput output{std::cout, std::cerr, steady_s};
  if (const auto* const mount = std::get_if<agents::MountJob>(&parsed))
    return ended(agents::calibrate_mount(*mount, output));
  return ended(agents::calibrate_camera(std::get<agents::CameraJob>(parsed), output));
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc > 1 && std::string_view(argv[1]) == "calibrate") return calibrate(argc - 1, argv + 1);
    const auto parsed = agents::parse_options(argc, argv);
    if (const auto* const leave = std::get_if<agents::Leave>(&parsed)) return left(*leave);
    const auto& options = std::get<agents::Options>(parsed);
    if (options.asks_health) return process::report_health("weft-agent", options.state);
    return ended(agents::run(options), options.log_format);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "weft-agent: ended by a defect: %s\n", error.what());
  }
  return 1;
}
