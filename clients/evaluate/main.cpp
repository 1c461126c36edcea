#include <chrono>
#include <csignal>
#include <exception>
#include <iostream>

#include "clients/evaluate/invocation.hpp"
#include "core/text.hpp"

namespace {

using namespace weft;

volatile std::sig_atomic_t asked_to_stop = 0;

void ask_to_stop(int /*signal*/) {
  asked_to_stop = 1;
}

int run(const evaluate::DisturbancesOptions& options) {
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  const evaluate::Surroundings around{
      std::cout, std::cerr,
      [] { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); },
      [] { return asked_to_stop != 0; }};
  const Result<evaluate::Ended> ended = evaluate::study_disturbances(options, around);
  if (!ended) {
    std::cerr << "weft-evaluate: " << one_line(ended.error().message) << '\n';
    return 1;
  }
  if (*ended == evaluate::Ended::complete) return 0;
  std::cerr << "weft-evaluate: stopped; what was measured is in " << options.out.string()
            << ", the same command goes on from there\n";
  return 130;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const auto parsed = evaluate::parse(argc, argv);
    if (const auto* const not_run = std::get_if<evaluate::NotRun>(&parsed)) {
      (not_run->exit_code == 0 ? std::cout : std::cerr) << not_run->text;
      return not_run->exit_code;
    }
    return run(std::get<evaluate::DisturbancesOptions>(parsed));
  } catch (const std::exception& error) {
    std::cerr << "weft-evaluate: ended by a defect: " << one_line(error.what()) << '\n';
    return 1;
  }
}
