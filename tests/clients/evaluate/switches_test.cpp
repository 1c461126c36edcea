#include "clients/evaluate/disturbances/switches.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace weft::evaluate {
namespace {

using agents::sim::Disturbances;

/// Lists all that can be turned off; the vibration's band is not.
constexpr std::array kFields = {&Disturbances::focal_error,     &Disturbances::mount_error_m,
                                &Disturbances::mount_error_rad, &Disturbances::vibration_rad,
                                &Disturbances::vibration_m,     &Disturbances::exposure_s,
                                &Disturbances::noise_grey,      &Disturbances::vignetting,
                                &Disturbances::exposure_drift,  &Disturbances::dropped_frames,
                                &Disturbances::time_jitter_s,   &Disturbances::wheel_scale_error,
                                &Disturbances::wheel_asymmetry, &Disturbances::slip,
                                &Disturbances::light_change,    &Disturbances::shadow,
                                &Disturbances::centre_error_px, &Disturbances::distortion_error_px};
/// Lists what sites have off unless they say otherwise.
constexpr std::array kHarder = {&Disturbances::unevenness_m, &Disturbances::rolling_shutter_s,
                                &Disturbances::time_offset_s};

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
  for (std::size_t i = 2; i < variants.size() - 2 * kHarder.size(); i += 2) {
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

TEST(Switches, HarderOnesComeOnTopOfAllAndAlone) {
  Disturbances site;
  site.time_offset_s = -0.05;
  const auto variants = variants_of(site);
  for (const auto field : kHarder) EXPECT_EQ(variants.at(0).disturbances.*field, 0.0);
  EXPECT_EQ(variants.at(1).disturbances.time_offset_s, -0.05) << "as the site says";
  constexpr std::array kNames = {"floor uneven by 2 mm", "rolling shutter 20 ms", "stamps 10 ms late"};
  constexpr std::array kSizes = {0.002, 0.02, 0.01};
  const std::size_t first = variants.size() - 2 * kHarder.size();
  for (std::size_t i = 0; i < kHarder.size(); ++i) {
    const Variant& with = variants.at(first + 2 * i);
    const Variant& only = variants.at(first + 2 * i + 1);
    EXPECT_EQ(name_of(with), std::string("with ") + kNames.at(i));
    EXPECT_EQ(name_of(only), std::string("only ") + kNames.at(i));
    EXPECT_EQ(with.disturbances.*kHarder.at(i), kSizes.at(i));
    EXPECT_EQ(only.disturbances.*kHarder.at(i), kSizes.at(i));
    EXPECT_EQ(on(with.disturbances).size(), kFields.size());
    EXPECT_TRUE(on(only.disturbances).empty());
    for (std::size_t other = 0; other < kHarder.size(); ++other) {
      if (other != i) {
        EXPECT_EQ(only.disturbances.*kHarder.at(other), 0.0);
      }
    }
  }
}

TEST(Switches, AreChosenByTheNameOfARowOrOfADisturbance) {
  const auto all = variants_of({});
  const auto names = [&](const std::vector<std::string>& only) {
    std::vector<std::string> chosen;
    const auto found = named(all, only);
    for (const Variant& variant : *found) chosen.push_back(name_of(variant));
    return chosen;
  };
  EXPECT_EQ(names({}).size(), all.size());
  EXPECT_EQ(names({"blur", "all", "all"}), (std::vector<std::string>{"all", "without blur", "only blur"}));
  EXPECT_EQ(names({"with stamps 10 ms late"}), std::vector<std::string>{"with stamps 10 ms late"});
  for (const char* wrong : {"", "blurr", "without", "with blur"}) {
    const auto refused = named(all, {"all", wrong});
    ASSERT_FALSE(refused) << wrong;
    EXPECT_EQ(refused.error().code, ErrorCode::invalid);
    EXPECT_NE(refused.error().message.find("'" + std::string(wrong) + "'"), std::string::npos);
    EXPECT_NE(refused.error().message.find("'own shadow', 'floor uneven by 2 mm'"), std::string::npos);
  }
}

}  // namespace
}  // namespace weft::evaluate
