#include "agents/navigation/method_navigators.hpp"

#include <algorithm>
#include <utility>

#include "agents/methods/advance.hpp"
#include "agents/methods/dead_reckoning.hpp"
#include "agents/navigation/agreement.hpp"
#include "agents/navigation/method_switch.hpp"

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

bool may_take_over(const MethodNavigator& one, const MethodNavigator& active, const NavigationConfig& config,
                   const Window& window) {
  if (!one.knows() || one.navigator->estimate()->blind_m > kFreshM) return false;
  return !active.knows() || agree(config, window, *active.now(), *one.now());
}

}  // namespace

std::optional<Estimate> MethodNavigator::now() const {
  std::optional<Estimate> here = navigator->estimate();
  if (!here || since.elapsed <= Duration::zero()) return here;
  const Step step = dead_reckon({}, since, {});
  CommonErrors common = CommonErrors::Zero();
  here->place_from_robot = advanced(here->place_from_robot, step, common);
  here->blind_m += distance_m(step.previous_from_current);
  return here;
}

void MethodNavigator::moves(const Motion& motion) {
  since = joined(since, motion);
  since_hint += motion.elapsed;
  rolls_unseen = rolls(motion) ? rolls_unseen + motion.elapsed : Duration::zero();
}

bool MethodNavigator::is_due_blind() const {
  return rolls_unseen >= kSilent || since.elapsed >= kSilentAtRest;
}

Motion MethodNavigator::take_motion(bool sees) {
  if (sees) rolls_unseen = {};
  return std::exchange(since, Motion{});
}

/// Tells the one what `knowing` believes, in words of the one's method, as of the one's own last step: of what has
/// moved since then it will be told.
static void hint(MethodNavigator& one, const MethodNavigator& knowing, const NavigationConfig& config,
                 const Window& window) {
  one.since_hint = {};
  auto told = as_seen_by(one.navigator->method(), config, window, *knowing.now());
  if (!told) return;
  told->place_from_robot = compose(told->place_from_robot, inverse(moved_by(one.since)));
  told->blind_m = std::max(told->blind_m, kFreshM + 0.01);  // it has not seen it itself
  if (told->blind_m < config.follow.blind_limit_m) one.navigator->believe(*told);
}

void seed_lost(MethodNavigators& navigators, std::size_t active, const NavigationConfig& config,
               const Window& window) {
  const MethodNavigator* best = navigators[active].knows() ? &navigators[active] : nullptr;
  for (const MethodNavigator& one : navigators)
    if (best == nullptr && one.knows()) best = &one;
  if (best == nullptr) return;
  for (MethodNavigator& one : navigators) {
    if (&one == best || one.knows() || one.since_hint < kBetweenHints) continue;
    hint(one, *best, config, window);
  }
}

/// Returns whether a place of that method comes soon on the route.
static bool comes_soon(std::string_view method, const Window& window, const Route& route, std::uint32_t at) {
  constexpr std::uint32_t kAhead = 10;  // places
  for (std::uint32_t ahead = 0; ahead < kAhead; ++ahead) {
    if (next_method(window, route, at + ahead) == method) return true;
  }
  return false;
}

void correct_mistaken(MethodNavigators& navigators, std::size_t active, const NavigationConfig& config,
                      const Window& window, const Route& route, std::uint32_t at) {
  const auto is_fresh = [](const MethodNavigator& one) {
    return one.knows() && one.navigator->estimate()->blind_m <= kFreshM;
  };
  const auto spread_m = [](const MethodNavigator& one) {
    return spread_of(one.navigator->estimate()->place_from_robot).metres;
  };
  MethodNavigator& drives = navigators[active];
  for (std::size_t i = 0; i < navigators.size(); ++i) {
    MethodNavigator& next = navigators[i];
    if (i == active || !drives.knows() || !next.knows()) continue;
    if (!comes_soon(next.navigator->method(), window, route, at)) continue;
    if (agree(config, window, *drives.now(), *next.now())) continue;
    const bool next_is_surer = spread_m(next) < spread_m(drives);
    const MethodNavigator& surer = next_is_surer ? next : drives;
    MethodNavigator& other = next_is_surer ? drives : next;
    if (is_fresh(surer) && other.since_hint >= kBetweenHints) hint(other, surer, config, window);
  }
}

std::optional<std::size_t> successor(const MethodNavigators& navigators, std::size_t active,
                                     const NavigationConfig& config, const Window& window, const Route& route,
                                     std::uint32_t at) {
  const std::string_view method = next_method(window, route, at);
  for (std::size_t i = 0; i < navigators.size(); ++i) {
    const bool is_meant = i != active && navigators[i].navigator->method() == method;
    if (is_meant && may_take_over(navigators[i], navigators[active], config, window)) return i;
  }
  return std::nullopt;
}

}  // namespace weft::agents
