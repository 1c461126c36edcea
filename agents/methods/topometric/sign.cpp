#include "agents/perception/sign.hpp"
#include "agents/methods/topometric/topometric.hpp"

namespace weft::agents {

std::optional<Signature> Topometric::sign(const Content& content) const {
  std::vector<Descriptor> descriptors;
  for (const SpaceFeature& feature : content.features) descriptors.push_back(feature.descriptor);
  return sign_descriptors(descriptors);
}

std::optional<Signature> Topometric::sign_bytes(ByteView bytes) {
  const Result<Content> content = decode_topometric_content(bytes);
  if (!content) return std::nullopt;
  std::vector<Descriptor> descriptors;
  for (const SpaceFeature& feature : content->features) descriptors.push_back(feature.descriptor);
  return sign_descriptors(descriptors);
}

}  // namespace weft::agents
