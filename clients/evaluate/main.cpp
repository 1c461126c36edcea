#include <chrono>
#include <csignal>
#include <ctime>
#include <exception>
#include <iostream>

#include "clients/evaluate/generate/generate.hpp"
#include "clients/evaluate/invocation.hpp"
#include "core/exit_code.hpp"
#include "core/text.hpp"
#include "storage/sqlite/sqlite_store.hpp"

namespace {

using namespace weft;

volatile std::sig_atomic_t asked_to_stop = 0;

void ask_to_stop(int /*signal*/) {
  asked_to_stop = 1;
}

double steady_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double thread_cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

int failed(const Error& error) {
  std::cerr << "weft-evaluate: " << one_line(error.message) << '\n';
  return exit_code_of(error.code);
}

int run(const evaluate::GenerateOptions& options) {
  const auto store = storage::open_sqlite(options.out);
  if (!store) return failed(store.error());
  const auto stored = (*store)->open();
  if (!stored) return failed(stored.error());
  const evaluate::GenerationWatch watch{std::cerr, steady_s, [] { return asked_to_stop != 0; }};
  const Result<evaluate::Generated> made = evaluate::generate_site(**store, *stored, options.plan, watch);
  if (!made) return failed(made.error());
  std::cout << made->places << " places in " << options.out.string() << ", " << made->written << " of them new\n";
  if (made->is_complete) return 0;
  std::cerr << "weft-evaluate: stopped; the same command goes on from there\n";
  return 130;
}

int finish(const Result<evaluate::Ended>& ended, const std::string& left) {
  if (!ended) return failed(ended.error());
  if (*ended == evaluate::Ended::complete) return 0;
  if (*ended == evaluate::Ended::missed) {
    std::cerr << "weft-evaluate: not everything that is promised holds; the table says NOT MET where\n";
    return 1;
  }
  std::cerr << "weft-evaluate: stopped; " << left << '\n';
  return 130;
}

int finish(const Result<evaluate::Ended>& ended, const std::filesystem::path& out) {
  return finish(ended, "what was measured is in " + out.string() + ", the same command goes on from there");
}

int run(const evaluate::DisturbancesOptions& options) {
  const evaluate::Surroundings around{std::cout, std::cerr, steady_s, [] { return asked_to_stop != 0; }};
  return finish(evaluate::study_disturbances(options, around), options.out);
}

int run(const evaluate::FloorOptions& options) {
  const evaluate::Surroundings around{std::cout, std::cerr, steady_s, [] { return asked_to_stop != 0; }};
  return finish(evaluate::floor::study_floor(options, around), options.out);
}

int run(const evaluate::AttemptsOptions& options) {
  const evaluate::Surroundings around{std::cout, std::cerr, steady_s, [] { return asked_to_stop != 0; }};
  return finish(evaluate::floor::study_attempts(options, around), options.out);
}

int run(const evaluate::RelocaliseOptions& options) {
  const evaluate::Surroundings around{std::cout, std::cerr, steady_s, [] { return asked_to_stop != 0; }};
  return finish(evaluate::floor::study_relocalisation(options, around), options.out);
}

int finish_at_once(const Result<evaluate::Ended>& ended, const std::string& left = "nothing was written") {
  return finish(ended, left);
}

int run(const evaluate::ForetoldOptions& options) {
  const evaluate::Surroundings around{std::cout, std::cerr, steady_s, [] { return asked_to_stop != 0; }};
  return finish_at_once(evaluate::floor::study_foretold(options, around));
}

int run(const evaluate::OdometryOptions& options) {
  const evaluate::Surroundings around{std::cout, std::cerr, steady_s, [] { return asked_to_stop != 0; }};
  return finish(evaluate::odometry::study_odometry(options, around, thread_cpu_s), options.out);
}

int run(const evaluate::BearingOptions& options) {
  const evaluate::Surroundings around{std::cout, std::cerr, steady_s, [] { return asked_to_stop != 0; }};
  return finish(evaluate::bearing::study_bearing(options, around), options.out);
}

int run(const evaluate::BearingRelocaliseOptions& options) {
  const evaluate::Surroundings around{std::cout, std::cerr, steady_s, [] { return asked_to_stop != 0; }};
  return finish(evaluate::bearing::study_look_alikes(options, around), options.out);
}

int run(const evaluate::LearningOptions& options) {
  const evaluate::Surroundings around{std::cout, std::cerr, steady_s, [] { return asked_to_stop != 0; }};
  return finish_at_once(evaluate::bearing::study_learning(options, around),
                        "learning.csv has what was measured; the next call begins anew");
}

int run(const evaluate::HeadingOptions& options) {
  const evaluate::Surroundings around{std::cout, std::cerr, steady_s, [] { return asked_to_stop != 0; }};
  return finish_at_once(evaluate::heading::study_heading(options, around));
}

int run(const evaluate::CeilingOptions& options) {
  const evaluate::Surroundings around{std::cout, std::cerr, steady_s, [] { return asked_to_stop != 0; }};
  return finish(evaluate::ceiling::study_ceiling(options, around), options.out);
}

int run(const evaluate::CeilingFramesOptions& options) {
  const evaluate::Surroundings around{std::cout, std::cerr, steady_s, [] { return asked_to_stop != 0; }};
  return finish_at_once(evaluate::ceiling::study_frames(options, around));
}

int run(const evaluate::RegisterOptions& options) {
  const evaluate::Surroundings around{std::cout, std::cerr, steady_s, [] { return asked_to_stop != 0; }};
  return finish_at_once(evaluate::registration::study_pair(options, around, thread_cpu_s));
}

int run(const evaluate::RegisterRoomsOptions& options) {
  const evaluate::Surroundings around{std::cout, std::cerr, steady_s, [] { return asked_to_stop != 0; }};
  return finish_at_once(evaluate::registration::study_rooms(options, around));
}

int run(const evaluate::ParticlesOptions& options) {
  const evaluate::Surroundings around{std::cout, std::cerr, steady_s, [] { return asked_to_stop != 0; }};
  return finish(evaluate::particles::study_particles(options, around), options.out);
}

int run(const evaluate::StereoOptions& options) {
  const evaluate::Surroundings around{std::cout, std::cerr, steady_s, [] { return asked_to_stop != 0; }};
  return finish(evaluate::stereo::study_stereo(options, around, thread_cpu_s), options.out);
}

int run(const evaluate::TopometricOptions& options) {
  const evaluate::Surroundings around{std::cout, std::cerr, steady_s, [] { return asked_to_stop != 0; }};
  return finish(evaluate::topometric::study_topometric(options, around), options.out);
}

int run(const evaluate::ReplayOptions& options) {
  const evaluate::Surroundings around{std::cout, std::cerr, steady_s, [] { return asked_to_stop != 0; }};
  return finish_at_once(evaluate::floor::replay_floor(options, around));
}

int run(const evaluate::NotRun& not_run) {
  (not_run.exit_code == 0 ? std::cout : std::cerr) << not_run.text;
  return not_run.exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const evaluate::Parsed parsed = evaluate::parse(argc, argv);
    std::signal(SIGINT, ask_to_stop);
    std::signal(SIGTERM, ask_to_stop);
    return std::visit([](const auto& options) { return run(options); }, parsed);
  } catch (const std::exception& error) {
    std::cerr << "weft-evaluate: ended by a defect: " << one_line(error.what()) << '\n';
    return 1;
  }
}
