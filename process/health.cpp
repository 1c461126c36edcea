#include "process/health.hpp"

#include <sstream>
#include <utility>

#include "core/text.hpp"
#include "core/utf8.hpp"

namespace weft::process {
namespace {

constexpr std::string_view kKind = "weft-health";
constexpr int kVersion = 1;
constexpr std::size_t kShown = 40;  ///< bytes of what is no record
constexpr Duration kAhead = std::chrono::seconds(1);

std::string since(SteadyTime then, SteadyTime now) {
  return fixed_number(seconds(now - then), 1) + " s";
}

tl::unexpected<Error> no_record(std::string_view text) {
  const std::string shown = one_line(as_utf8(std::string(text.substr(0, kShown)), kShown));
  return fail(ErrorCode::corrupt,
              "holds no health record (\"" + shown + "\"): a process that works replaces it within a second");
}

}  // namespace

std::string health_text(const Health& health) {
  std::string text = std::string(kKind) + " " + std::to_string(kVersion) + " " + health.program + " " +
                     std::to_string(health.process) + " " + std::to_string(health.beat.time_since_epoch().count()) +
                     (health.is_starting ? " starting" : " running");
  const std::size_t room = kHealthBytes - 2 > text.size() ? kHealthBytes - 2 - text.size() : 0;
  if (!health.trouble.empty()) text += " " + as_utf8(one_line(health.trouble), room);
  text.resize(kHealthBytes - 1, ' ');
  return text + "\n";
}

Result<Health> parse_health(std::string_view text) {
  if (text.size() != kHealthBytes || text.back() != '\n') return no_record(text);
  std::istringstream in{std::string(text)};
  std::string kind, phase;
  int version = 0;
  std::int64_t beat = 0;
  Health health;
  if (!(in >> kind >> version) || kind != kKind) return no_record(text);
  if (version != kVersion) {
    return fail(ErrorCode::newer, "is of version " + std::to_string(version) + ", this program reads version " +
                                      std::to_string(kVersion) + ": ask with the program that runs");
  }
  if (!(in >> health.program >> health.process >> beat >> phase)) return no_record(text);
  if (phase != "starting" && phase != "running") return no_record(text);
  health.beat = SteadyTime(Duration(beat));
  health.is_starting = phase == "starting";
  std::getline(in >> std::ws, health.trouble);
  health.trouble.erase(health.trouble.find_last_not_of(' ') + 1);
  return health;
}

Verdict judge(const Health& health, SteadyTime now) {
  const std::string who = health.program + ", process " + std::to_string(health.process);
  if (health.beat > now + kAhead) {
    return {false, who + ": its clock is " + since(now, health.beat) +
                       " ahead of this one: ask on the machine that it runs on"};
  }
  if (health.is_starting) {
    return {false, who + ": has been starting for " + since(health.beat, now) + ": " + health.trouble};
  }
  if (now - health.beat >= kHungAfter) {
    const std::string before = health.trouble.empty() ? "" : "; before that: " + health.trouble;
    return {false, who + ": hung for " + since(health.beat, now) + ": its main loop does not turn" + before};
  }
  if (!health.trouble.empty()) return {false, who + ": " + health.trouble};
  return {true, who + ": its main loop turned " + since(health.beat, now) + " ago"};
}

}  // namespace weft::process
