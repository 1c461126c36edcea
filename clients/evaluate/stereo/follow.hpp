#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "clients/evaluate/stereo/recording.hpp"
#include "clients/evaluate/surroundings.hpp"

namespace weft::evaluate::stereo {

/// Holds what one method made of a recording, a pose a pair.
struct Path {
  std::vector<Pose3> start_from_robot;
  std::size_t seen = 0;  ///< steps; the others are as the last one that was seen
  double took_s = 0.0;   ///< of the processor, rectifying included where the method needs it
};
struct Followed {
  std::vector<double> time_s;  ///< by the recording's clock
  Path ours;
  Path baseline;
};

/// Tells what following needs beside the recording.
struct Following {
  std::size_t every = 1;  ///< takes each so-manieth pair
  std::function<double()> processor_s;
  std::function<void(const std::string&)> warn;
  std::function<void(std::size_t pairs)> followed;  ///< so many pairs of it are done
  std::function<bool()> asked_to_stop;
};

/// Follows a recording by the product's visual odometry, without commands, and by KltPnp, pair by pair. A pair that
/// was dropped is blind to both. None: stopped. Errors of the recording.
Result<std::optional<Followed>> follow(const Recording& recording, const Following& following);

}  // namespace weft::evaluate::stereo
