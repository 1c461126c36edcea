// A method's wish for how its camera exposes.
#include <gtest/gtest.h>

#include "agents/methods/floor/floor.hpp"
#include "agents/navigation/navigator_of.hpp"
#include "tests/support/marks.hpp"

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

/// Sees marks best in images that are twice as bright.
class Brighter : public MarksMethod {
 public:
  std::optional<Exposure> expose(const Odometry&, const View& view) const {
    if (!view.exposure) return std::nullopt;
    return Exposure{2.0 * view.exposure->time_s, view.exposure->gain};
  }
};
static_assert(Exposes<Brighter> && !Exposes<MarksMethod>);
static_assert(!Exposes<Floor>);

class NothingHeld final : public Contents {
 public:
  std::shared_ptr<const Bytes> find(const ContentHash&) const override { return nullptr; }
};

template <class M>
Navigated seen(const std::vector<View>& views) {
  const auto navigator = make_navigator(M(), {});
  const Window window;
  const NothingHeld contents;
  const Sample sample{1, SensorTime{100ms}, views, {100ms, {}, std::nullopt}, true, false};
  return navigator->step(sample, {window, contents});
}

View exposed_view() {
  View view;
  view.sensor = "forward";
  view.data = Marks{};
  view.exposure = Exposure{0.004, 1.5};
  return view;
}

TEST(Exposing, AWishGoesOnWithTheCameraThatItIsFor) {
  const View view = exposed_view();
  const Navigated navigated = seen<Brighter>({view});
  ASSERT_TRUE(navigated.exposes) << "while a hand drives, too";
  EXPECT_EQ(navigated.exposes->sensor, "forward");
  EXPECT_EQ(navigated.exposes->exposure.time_s, 0.008);
  EXPECT_EQ(navigated.exposes->exposure.gain, 1.5);
}

TEST(Exposing, WithoutAnImageOrAWishNothingIsSaid) {
  EXPECT_FALSE(seen<Brighter>({}).exposes);
  View view = exposed_view();
  EXPECT_FALSE(seen<MarksMethod>({view}).exposes);
  view.exposure.reset();
  EXPECT_FALSE(seen<Brighter>({view}).exposes);
}

}  // namespace
}  // namespace weft::agents
