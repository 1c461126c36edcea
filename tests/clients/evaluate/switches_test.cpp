#include "clients/evaluate/disturbances/switches.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace weft::evaluate {
namespace {

using agents::sim::Disturbances;

/// All that can be turned off; the vibration's band is not.
constexpr std::array kFields = {&Disturbances::focal_error,     &Disturbances::mount_error_m,
                                &Disturbances::mount_error_rad, &Disturbances::vibration_rad,
                                &Disturbances::vibration_m,     &Disturbances::exposure_s,
                                &Disturbances::noise_grey,      &Disturbances::vignetting,
                                &Disturbances::exposure_drift,  &Disturbances::dropped_frames,
                                &Disturbances::time_jitter_s,   &Disturbances::wheel_scale_error,
                                &Disturbances::wheel_asymmetry, &Disturbances::slip,
                                &Disturbances::light_change,    &Disturbances::shadow,
                                &Disturbances::centre_error_px, &Disturbances::distortion_error_px};

std::set<std::size_t> on(const Disturbances& disturbances) {
  std::set<std::size_t> fields;
  for (std::size_t i = 0; i < kFields.size(); ++i) {
    if (disturbances.*kFields.at(i) != 0.0) fields.insert(i);
  }
  return fields;
}

TEST(Switches, NothingIsForgotten) {
  const auto variants = variants_of({});
  EXPECT_EQ(variants.at(0).kind, Variant::Kind::none);
  EXPECT_TRUE(on(variants.at(0).disturbances).empty());
  EXPECT_EQ(on(variants.at(1).disturbances).size(), kFields.size());
  EXPECT_EQ(variants.size(), 2 + 2 * disturbance_names().size());
  EXPECT_EQ(variants.at(0).disturbances.vibration_high_hz, Disturbances{}.vibration_high_hz);
}

TEST(Switches, WithoutAndOnlyAreEachOthersOpposite) {
  std::set<std::size_t> seen;
  const auto variants = variants_of({});
  for (std::size_t i = 2; i < variants.size(); i += 2) {
    ASSERT_EQ(variants[i].kind, Variant::Kind::without);
    ASSERT_EQ(variants[i + 1].kind, Variant::Kind::only);
    ASSERT_EQ(variants[i].disturbance, variants[i + 1].disturbance);
    const std::set<std::size_t> only = on(variants[i + 1].disturbances);
    EXPECT_FALSE(only.empty()) << name_of(variants[i]);
    EXPECT_EQ(on(variants[i].disturbances).size(), kFields.size() - only.size()) << name_of(variants[i]);
    for (const std::size_t field : only) {
      EXPECT_FALSE(on(variants[i].disturbances).contains(field));
      EXPECT_TRUE(seen.insert(field).second) << "two switches share a field";
    }
  }
  EXPECT_EQ(seen.size(), kFields.size());
}

TEST(Switches, TheSitesOwnSizesAreUsed) {
  Disturbances site;
  site.noise_grey = 7.0;
  for (const Variant& variant : variants_of(site)) {
    if (name_of(variant) == "only noise") {
      EXPECT_EQ(variant.disturbances.noise_grey, 7.0);
    }
    if (name_of(variant) == "without noise") {
      EXPECT_EQ(variant.disturbances.noise_grey, 0.0);
    }
  }
}

}  // namespace
}  // namespace weft::evaluate
