#include "clients/evaluate/surroundings.hpp"

#include <array>
#include <cstdio>

namespace weft::evaluate {

std::string words_of(Seeds seeds) {
  if (seeds.first == seeds.last) return "seed " + std::to_string(seeds.first);
  return "seeds " + std::to_string(seeds.first) + " to " + std::to_string(seeds.last);
}

RowsMeasured::RowsMeasured(std::size_t all, std::size_t kept, const Surroundings& around)
    : all_(all), kept_(kept), around_(around), began_s_(around.steady_s()) {
  around_.progress << "weft-evaluate: " << all_ << " rows to measure, " << kept_ << " of them are there already\n"
                   << std::flush;
}

void RowsMeasured::row(const std::string& what) {
  ++measured_;
  const double each_s = (around_.steady_s() - began_s_) / static_cast<double>(measured_);
  const double left_s = each_s * static_cast<double>(all_ - kept_ - measured_);
  std::array<char, 300> words{};
  std::snprintf(words.data(), words.size(), "%zu of %zu (%s): %.1f s a row, %.0f min left\n", kept_ + measured_, all_,
                what.c_str(), each_s, left_s / 60.0);
  around_.progress << words.data() << std::flush;
}

}  // namespace weft::evaluate
