#include "agents/navigation/parts.hpp"

#include <algorithm>
#include <utility>

#include "agents/methods/advance.hpp"
#include "agents/methods/dead_reckoning.hpp"
#include "agents/navigation/agreement.hpp"
#include "agents/navigation/hand_over.hpp"

namespace weft::agents {
namespace {

constexpr double kFreshM = 0.5;  ///< travelled since its last fix: who knows no better does not take over
constexpr Duration kSilent = std::chrono::milliseconds(300);
constexpr Duration kSilentAtRest = std::chrono::seconds(2);
constexpr Duration kBetweenHints = std::chrono::seconds(1);

Relation moved_by(const Motion& motion) {
  return dead_reckon({}, motion, {}).previous_from_current;
}

bool rolls(const Motion& motion) {
  return motion.command != Twist{} || (motion.wheels && motion.wheels->distance_m != 0.0);
}

bool may_take_over(const Part& part, const Part& active, const NavigationConfig& config, const Window& window) {
  if (!part.knows() || part.navigator->estimate()->blind_m > kFreshM) return false;
  return !active.knows() || agree(config, window, *active.now(), *part.now());
}

}  // namespace

std::optional<Estimate> Part::now() const {
  std::optional<Estimate> here = navigator->estimate();
  if (!here || since.elapsed <= Duration::zero()) return here;
  const Step step = dead_reckon({}, since, {});
  CommonErrors common = CommonErrors::Zero();
  here->place_from_robot = advanced(here->place_from_robot, step, common);
  here->blind_m += distance_m(step.previous_from_current);
  return here;
}

void Part::moves(const Motion& motion) {
  since = joined(since, motion);
  since_hint += motion.elapsed;
  rolls_unseen = rolls(motion) ? rolls_unseen + motion.elapsed : Duration::zero();
}

bool Part::is_due_blind() const {
  return rolls_unseen >= kSilent || since.elapsed >= kSilentAtRest;
}

Motion Part::take_motion(bool sees) {
  if (sees) rolls_unseen = {};
  return std::exchange(since, Motion{});
}

/// Tells the part what `knowing` believes, in words of the part's method, as of the part's own last step: of what has
/// moved since then it will be told.
static void hint(Part& part, const Part& knowing, const NavigationConfig& config, const Window& window) {
  part.since_hint = {};
  auto told = as_seen_by(part.navigator->method(), config, window, *knowing.now());
  if (!told) return;
  told->place_from_robot = compose(told->place_from_robot, inverse(moved_by(part.since)));
  told->blind_m = std::max(told->blind_m, kFreshM + 0.01);  // it has not seen it itself
  if (told->blind_m < config.follow.blind_limit_m) part.navigator->believe(*told);
}

void tell_who_does_not_know(Parts& parts, std::size_t active, const NavigationConfig& config, const Window& window) {
  const Part* best = parts[active].knows() ? &parts[active] : nullptr;
  for (const Part& part : parts)
    if (best == nullptr && part.knows()) best = &part;
  if (best == nullptr) return;
  for (Part& part : parts) {
    if (&part == best || part.knows() || part.since_hint < kBetweenHints) continue;
    hint(part, *best, config, window);
  }
}

/// Whether a place of that method comes soon on the route.
static bool comes_soon(std::string_view method, const Window& window, const Route& route, std::uint32_t at) {
  constexpr std::uint32_t kAhead = 10;  // places
  for (std::uint32_t ahead = 0; ahead < kAhead; ++ahead) {
    if (next_method(window, route, at + ahead) == method) return true;
  }
  return false;
}

void tell_who_is_mistaken(Parts& parts, std::size_t active, const NavigationConfig& config, const Window& window,
                          const Route& route, std::uint32_t at) {
  const auto is_fresh = [](const Part& part) {
    return part.knows() && part.navigator->estimate()->blind_m <= kFreshM;
  };
  const auto spread_m = [](const Part& part) {
    return spread_of(part.navigator->estimate()->place_from_robot).metres;
  };
  Part& drives = parts[active];
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Part& next = parts[i];
    if (i == active || !drives.knows() || !next.knows()) continue;
    if (!comes_soon(next.navigator->method(), window, route, at)) continue;
    if (agree(config, window, *drives.now(), *next.now())) continue;
    const bool next_is_surer = spread_m(next) < spread_m(drives);
    const Part& surer = next_is_surer ? next : drives;
    Part& other = next_is_surer ? drives : next;
    if (is_fresh(surer) && other.since_hint >= kBetweenHints) hint(other, surer, config, window);
  }
}

std::optional<std::size_t> successor(const Parts& parts, std::size_t active, const NavigationConfig& config,
                                     const Window& window, const Route& route, std::uint32_t at) {
  const std::string_view method = next_method(window, route, at);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool is_meant = i != active && parts[i].navigator->method() == method;
    if (is_meant && may_take_over(parts[i], parts[active], config, window)) return i;
  }
  return std::nullopt;
}

}  // namespace weft::agents
