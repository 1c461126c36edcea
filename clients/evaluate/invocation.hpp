#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>

#include "clients/evaluate/bearing/learning.hpp"
#include "clients/evaluate/bearing/relocalise/led_study.hpp"
#include "clients/evaluate/bearing/study.hpp"
#include "clients/evaluate/ceiling/frames/frames_study.hpp"
#include "clients/evaluate/ceiling/study.hpp"
#include "clients/evaluate/disturbances/study.hpp"
#include "clients/evaluate/floor/attempts/attempts_study.hpp"
#include "clients/evaluate/floor/foretold_study.hpp"
#include "clients/evaluate/floor/relocalise/relocalise_study.hpp"
#include "clients/evaluate/floor/replay.hpp"
#include "clients/evaluate/floor/study.hpp"
#include "clients/evaluate/generate/site_generator.hpp"
#include "clients/evaluate/heading/heading_study.hpp"
#include "clients/evaluate/odometry/study.hpp"
#include "clients/evaluate/particles/study.hpp"
#include "clients/evaluate/registration/pair_study.hpp"
#include "clients/evaluate/registration/rooms_study.hpp"
#include "clients/evaluate/stereo/study.hpp"
#include "clients/evaluate/topometric/study.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

/// Answers a command line that is not to be run: help, or a mistake in one line.
struct NotRun {
  int exit_code = 2;
  std::string text;
};

struct GenerateOptions {
  SitePlan plan;
  std::filesystem::path out;  ///< the store's directory; made if it is not there
};

using Parsed =
    std::variant<DisturbancesOptions, FloorOptions, AttemptsOptions, RelocaliseOptions, ForetoldOptions,
                 ReplayOptions, OdometryOptions, BearingOptions, BearingRelocaliseOptions, LearningOptions,
                 HeadingOptions, CeilingOptions, CeilingFramesOptions, RegisterOptions, RegisterRoomsOptions,
                 ParticlesOptions, StereoOptions, TopometricOptions, GenerateOptions, NotRun>;
Parsed parse(int argc, const char* const* argv);

/// Reads "A..B", or one number. invalid: says what is wrong.
Result<Seeds> parse_seeds(std::string_view text);

}  // namespace weft::evaluate
