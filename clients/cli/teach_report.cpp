#include "clients/cli/teach_report.hpp"

#include <array>
#include <cmath>

#include "clients/cli/table.hpp"

namespace weft::cli {
namespace {

/// A way in which places may have to be found, the mildest first.
struct Prospect {
  double msg::TaughtStretch::*found;
  const char* words;
  const char* what_to_do;
};
constexpr std::array kProspects{
    Prospect{&msg::TaughtStretch::as_is, "will not be found again as they are",
             "the camera sees too little there: look at focus, lens and light, and teach them again"},
    Prospect{&msg::TaughtStretch::half_light, "will not be found in half the light",
             "keep the light as it is, or clean the lens or give more light, and teach them again"},
    Prospect{&msg::TaughtStretch::worn, "will not be found on a worn or dirty floor",
             "keep the floor clean there, and teach them again when it has changed"},
};

/// The mildest one under which the stretch will not be found; null: none.
const Prospect* failing(const msg::TaughtStretch& stretch) {
  for (const Prospect& prospect : kProspects)
    if (stretch.*prospect.found < kFoundEnough) return &prospect;
  return nullptr;
}

/// 12 or 12.4.
std::string metre(double value) {
  const double tenths = std::round(10.0 * value);
  return fixed(0.1 * tenths, std::fmod(tenths, 10.0) == 0.0 ? 0 : 1);
}

std::string metres(double from_m, double to_m) {
  return metre(from_m) + ".." + metre(to_m);
}

std::string percent(double share) {
  return fixed(100.0 * share, 0) + " %";
}

}  // namespace

std::vector<std::string> advice_of(const std::vector<msg::TaughtStretch>& report) {
  std::vector<std::string> advice;
  for (std::size_t first = 0, next = 0; first < report.size(); first = next) {
    const Prospect* const prospect = failing(report[first]);
    for (next = first + 1; next < report.size() && failing(report[next]) == prospect;) ++next;
    if (prospect == nullptr) continue;
    advice.push_back("metres " + metres(report[first].from_m, report[next - 1].to_m) + " " + prospect->words + ": " +
                     prospect->what_to_do);
  }
  return advice;
}

void print_report(const std::vector<msg::TaughtStretch>& report, std::ostream& out) {
  Table table;
  table.add({"METRES", "PLACES", "AS IS", "HALF LIGHT", "WORN", "SIGMA", "WEAKEST"});
  for (const msg::TaughtStretch& stretch : report) {
    const std::string sigma = stretch.sigma_m > 0.0 ? fixed(1000.0 * stretch.sigma_m, 0) + " mm" : "-";
    table.add({metres(stretch.from_m, stretch.to_m), std::to_string(stretch.places), percent(stretch.as_is),
               percent(stretch.half_light), percent(stretch.worn), sigma, stretch.reason});
  }
  table.print(out);
  const std::vector<std::string> advice = advice_of(report);
  for (const std::string& words : advice) out << words << '\n';
  if (advice.empty() && !report.empty()) {
    out << "all " << metre(report.back().to_m - report.front().from_m)
        << " m will be found again, in half the light and on a worn floor too\n";
  }
}

nlohmann::json to_json(const msg::TaughtStretch& stretch) {
  return {{"from_m", stretch.from_m}, {"to_m", stretch.to_m},
          {"places", stretch.places}, {"first", to_string(stretch.first)},
          {"as_is", stretch.as_is},   {"half_light", stretch.half_light},
          {"worn", stretch.worn},     {"sigma_m", stretch.sigma_m},
          {"reason", stretch.reason}};
}

}  // namespace weft::cli
