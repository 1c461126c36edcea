#include "agents/perception/plane/sign.hpp"

#include "agents/perception/sign.hpp"

namespace weft::agents {

std::optional<std::vector<float>> sign_features(std::span<const PlaneFeature> features) {
  return sign_descriptors(descriptors_of(features));
}

}  // namespace weft::agents
