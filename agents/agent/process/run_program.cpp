#include "agents/agent/process/run_program.hpp"

#include <chrono>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string_view>
#include <variant>

#include "agents/agent/process/calibrate/jobs.hpp"
#include "agents/agent/process/options.hpp"
#include "agents/agent/process/run.hpp"
#include "core/exit_code.hpp"
#include "process/health_file.hpp"
#include "process/log.hpp"

namespace weft::agents {
namespace {

int left(const Leave& leave) {
  std::fputs(leave.text.c_str(), leave.exit_code == 0 ? stdout : stderr);
  return leave.exit_code;
}

double steady_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int ended(const Program& program, const Result<void>& ran) {
  if (ran) return 0;
  process::print_failure(program.name, process::LogFormat::text, ran.error().message);
  return kFailed;
}

int drive(const Program& program, const Options& options) {
  const Result<void> ran = run(program, options);
  if (ran) return 0;
  process::print_failure(program.name, options.log_format, ran.error().message);
  return exit_code_of(ran.error().code);
}

int calibrate(const Program& program, int argc, const char* const* argv) {
  const auto parsed = parse_calibrate(argc, argv);
  if (const auto* const leave = std::get_if<Leave>(&parsed)) return left(*leave);
  const JobOutput output{std::cout, std::cerr, steady_s};
  if (const auto* const mount = std::get_if<MountJob>(&parsed))
    return ended(program, calibrate_mount(program, *mount, output));
  return ended(program, calibrate_camera(std::get<CameraJob>(parsed), output));
}

}  // namespace

int run_program(const Program& program, int argc, const char* const* argv) noexcept {
  try {
    if (argc > 1 && std::string_view(argv[1]) == "calibrate") return calibrate(program, argc - 1, argv + 1);
    const auto parsed = parse_options(program, argc, argv);
    if (const auto* const leave = std::get_if<Leave>(&parsed)) return left(*leave);
    const auto& options = std::get<Options>(parsed);
    if (options.asks_health) return process::report_health(program.name, options.state);
    return drive(program, options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: ended by a defect: %s\n", program.name, error.what());
  }
  return kFailed;
}

}  // namespace weft::agents
