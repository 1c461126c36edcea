#include "agents/perception/plane/feature.hpp"

namespace weft::agents {

std::vector<Descriptor> descriptors_of(std::span<const PlaneFeature> features) {
  std::vector<Descriptor> descriptors;
  descriptors.reserve(features.size());
  for (const PlaneFeature& feature : features) descriptors.push_back(feature.descriptor);
  return descriptors;
}

}  // namespace weft::agents
