#include "clients/cli/teach_report.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "clients/cli/table.hpp"

namespace weft::cli {
namespace {

constexpr const char* kSeen = "seen";  // of metres, not of places

/// Describes a condition under which places may have to be found, as robots name them, or the way to them.
struct Condition {
  const char* name;
  const char* words;
  const char* failing;
  const char* what_to_do;
};
constexpr std::array kConditions{
    Condition{"as_is", "as it is", "will not be found again as they are",
              "the camera sees too little there: look at focus, lens and light, and teach them again"},
    Condition{"half_light", "in half the light", "will not be found in half the light",
              "keep the light as it is, or clean the lens or give more light, and teach them again"},
    Condition{"worn", "on a worn floor", "will not be found on a worn or dirty floor",
              "keep the floor clean there, and teach them again when it has changed"},
    Condition{kSeen, "seen while it drove", "were driven nearly blind",
              "how far and where to is a guess: give light and something to see there, and teach them again"},
};

const Condition* known(const std::string& name) {
  const auto* const found = std::find_if(kConditions.begin(), kConditions.end(),
                                         [&](const Condition& condition) { return name == condition.name; });
  return found == kConditions.end() ? nullptr : found;
}

/// Returns the mildest condition under which the stretch will not be found again; empty: there is none.
std::string failing(const msg::TaughtStretch& stretch) {
  for (const Diagnostic& share : stretch.found)
    if (share.value < share.bound) return share.name;
  return {};
}

std::string advice_on(const std::string& condition) {
  if (const Condition* const it = known(condition); it != nullptr)
    return std::string(it->failing) + ": " + it->what_to_do;
  return "will not be found under \"" + condition + "\": teach them again when it has come";
}

/// Returns metres to the tenth, without ".0": "12" or "12.4".
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

/// Returns the heading of a column: "HALF LIGHT" of "half_light".
std::string heading_of(std::string name) {
  for (char& letter : name)
    letter = letter == '_' ? ' ' : static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return name;
}

/// Returns ", in half the light and on a worn floor too"; empty: places are tried as they are alone.
std::string worse_conditions(const msg::TaughtStretch& stretch) {
  std::vector<std::string> conditions;
  for (std::size_t i = 1; i < stretch.found.size(); ++i)
    if (stretch.found[i].name != kSeen) conditions.push_back(words_for(stretch.found[i].name));
  std::string words;
  for (std::size_t i = 0; i < conditions.size(); ++i)
    words += (i > 0 && i + 1 == conditions.size() ? " and " : ", ") + conditions[i];
  return words.empty() ? words : words + " too";
}

}  // namespace

std::vector<std::string> advice_of(const std::vector<msg::TaughtStretch>& report) {
  std::vector<std::string> advice;
  for (std::size_t first = 0, next = 0; first < report.size(); first = next) {
    const std::string condition = failing(report[first]);
    for (next = first + 1; next < report.size() && failing(report[next]) == condition;) ++next;
    if (condition.empty()) continue;
    advice.push_back("metres " + metres(report[first].from_m, report[next - 1].to_m) + " " + advice_on(condition));
  }
  return advice;
}

std::string words_for(const std::string& condition) {
  const Condition* const it = known(condition);
  return it != nullptr ? it->words : condition;
}

void print_report(const std::vector<msg::TaughtStretch>& report, std::ostream& out) {
  Table table;
  std::vector<std::string> heading = {"METRES", "PLACES"};
  if (!report.empty())
    for (const Diagnostic& share : report.front().found) heading.push_back(heading_of(share.name));
  heading.insert(heading.end(), {"SIGMA", "WEAKEST"});
  table.add(std::move(heading));
  for (const msg::TaughtStretch& stretch : report) {
    const std::string sigma = stretch.sigma_m > 0.0 ? fixed(1000.0 * stretch.sigma_m, 0) + " mm" : "-";
    std::vector<std::string> row = {metres(stretch.from_m, stretch.to_m), std::to_string(stretch.places)};
    for (const Diagnostic& share : stretch.found) row.push_back(percent(share.value));
    row.insert(row.end(), {sigma, stretch.reason});
    table.add(std::move(row));
  }
  table.print(out);
  const std::vector<std::string> advice = advice_of(report);
  for (const std::string& words : advice) out << words << '\n';
  if (advice.empty() && !report.empty()) {
    out << "all " << metre(report.back().to_m - report.front().from_m) << " m will be found again"
        << worse_conditions(report.front()) << '\n';
  }
}

nlohmann::json to_json(const msg::TaughtStretch& stretch) {
  nlohmann::json object = {{"from_m", stretch.from_m},   {"to_m", stretch.to_m},
                           {"places", stretch.places},   {"first", to_string(stretch.first)},
                           {"sigma_m", stretch.sigma_m}, {"reason", stretch.reason}};
  for (const Diagnostic& share : stretch.found) object.emplace(share.name, share.value);
  return object;
}

}  // namespace weft::cli
