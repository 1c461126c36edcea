#pragma once
// Private to the command line of weft-evaluate.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "clients/evaluate/invocation.hpp"

namespace weft::evaluate {

/// Returns what adds one flag after the other to a subcommand.
inline auto flags_of(CLI::App* sub) {
  return [sub](const char* flag, auto& into, const char* unit, const std::string& help) {
    return sub->add_option(flag, into, help)->type_name(unit);
  };
}

/// Holds the flags of `floor`: of the study in simulation, or of a recording to be replayed.
struct FloorWords {
  FloorOptions study;
  std::string seeds;
  ReplayOptions replay;
  std::vector<double> mount;
  bool is_whole = false;  ///< every light and kind of wear, ten seeds
  bool is_quick = false;
  std::filesystem::path out = "out/floor";
};

struct BearingWords {
  BearingOptions study;
  std::string seeds;
  bool is_quick = false;
};

struct BearingRelocaliseWords {
  BearingRelocaliseOptions study;
  std::string seeds;
  bool is_quick = false;
};

struct CeilingWords {
  CeilingOptions study;
  std::string seeds;
  bool is_quick = false;
};

struct TopometricWords {
  TopometricOptions study;
  std::string seeds;
  bool is_quick = false;
};

/// Adds a subcommand to the program, one function each; its flags write into what is given.
CLI::App* describe(CLI::App& app, DisturbancesOptions& options, std::string& seeds);
CLI::App* describe(CLI::App& app, FloorWords& words);
CLI::App* describe(CLI::App& app, AttemptsOptions& options, std::string& seeds);
CLI::App* describe(CLI::App& app, RelocaliseOptions& options, std::string& seeds);
CLI::App* describe(CLI::App& app, ForetoldOptions& options, std::string& seeds);
CLI::App* describe(CLI::App& app, OdometryOptions& options, std::string& seeds);
CLI::App* describe(CLI::App& app, BearingWords& words);
CLI::App* describe(CLI::App& app, BearingRelocaliseWords& words);
CLI::App* describe(CLI::App& app, LearningOptions& options, std::string& seeds);
CLI::App* describe(CLI::App& app, HeadingOptions& options);
CLI::App* describe(CLI::App& app, CeilingWords& words);
CLI::App* describe(CLI::App& app, CeilingFramesOptions& options);
CLI::App* describe(CLI::App& app, RegisterOptions& options);
CLI::App* describe(CLI::App& app, RegisterRoomsOptions& options, std::string& seeds);
CLI::App* describe(CLI::App& app, ParticlesOptions& options, std::string& seeds);
CLI::App* describe(CLI::App& app, StereoOptions& options);
CLI::App* describe(CLI::App& app, TopometricWords& words);
CLI::App* describe(CLI::App& app, GenerateOptions& generate);

}  // namespace weft::evaluate
