#pragma once
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "clients/evaluate/surroundings.hpp"

namespace weft::evaluate::stereo {

/// Tells how far one pass over the pairs is, how fast it goes and how long it takes still.
class PairsDone {
 public:
  PairsDone(const std::string& what, std::size_t all, const Surroundings& around)
      : what_(what), all_(all), around_(around), began_s_(around.steady_s()) {}
  void done(std::size_t pairs) const {
    if (pairs % kProgressEvery != 0) return;
    const double rate = static_cast<double>(pairs) / std::max(1e-9, around_.steady_s() - began_s_);
    std::array<char, 200> words{};
    std::snprintf(words.data(), words.size(), "%s: %zu of %zu pairs, %.1f a second, %.0f s left\n", what_.c_str(),
                  pairs, all_, rate, static_cast<double>(all_ - pairs) / rate);
    around_.progress << words.data() << std::flush;
  }

 private:
  static constexpr std::size_t kProgressEvery = 20;

  std::string what_;
  std::size_t all_;
  const Surroundings& around_;
  double began_s_;
};

}  // namespace weft::evaluate::stereo
