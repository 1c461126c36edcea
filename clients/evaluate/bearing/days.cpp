#include "clients/evaluate/bearing/days.hpp"

#include <algorithm>

#include "clients/evaluate/bearing/trials.hpp"

namespace weft::evaluate::bearing {
namespace {

using agents::sim::Site;

constexpr int kDays = 6;
constexpr int kManyDays = 24;  // hardly anything is left of what was taught

Day by_day() {
  return {"day", [](Site&) {}};
}

/// Makes a day on which 30 % of the stock have changed so many times since it was taught.
Day restocked(int times) {
  return {"stock changed " + std::to_string(times) + " times", [times](Site& site) {
            site.change.stock = times > 0 ? 0.3 : 0.0;
            site.change.stock_times = std::max(1, times);
          }};
}

std::vector<Day> each(const std::function<Day(int)>& day, int count = kDays) {
  std::vector<Day> days;
  for (int i = 0; i < count; ++i) days.push_back(day(i));
  return days;
}

}  // namespace

const std::vector<Days>& all_days() {
  static const std::vector<Days> all = {
      {"same", "nothing changes", each([](int) { return by_day(); })},
      {"stock", "30 % of the stock changes each day", each([](int i) { return restocked(i + 1); })},
      {"stock-long", "the same for 24 days", each([](int i) { return restocked(i + 1); }, kManyDays)},
      {"stock-dark", "the same, every second day in the dark", each([](int i) {
         Day day = restocked(i + 1);
         if (i % 2 == 0) return day;
         return Day{day.about + ", dark", [day](Site& site) {
                      day.as(site);
                      dark(site);
                    }};
       })},
      {"day-dark", "day and dark alternate", each([](int i) {
         return i % 2 == 0 ? Day{"dark", dark} : by_day();
       })},
      {"half", "half of the lamps out from now on", each([](int) {
         return Day{"half", half_of_the_lamps};
       })},
  };
  return all;
}

}  // namespace weft::evaluate::bearing
