#include <draco/compression/decode.h>
#include <draco/compression/encode.h>
#include <draco/point_cloud/point_cloud_builder.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "tests/bench/clouds/rivals.hpp"

namespace weft::clouds {

std::string draco_compressed(const Cloud& cloud, double quantum_m, int speed) {
  draco::PointCloudBuilder builder;
  builder.Start(static_cast<std::uint32_t>(cloud.points.size()));
  const int positions = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  builder.SetAttributeValuesForAllPoints(positions, cloud.points.data(), sizeof(Eigen::Vector3f));
  const auto points = builder.Finalize(false);

  Eigen::Vector3f least = cloud.points.front();
  Eigen::Vector3f most = least;
  for (const Eigen::Vector3f& point : cloud.points) {
    least = least.cwiseMin(point);
    most = most.cwiseMax(point);
  }
  // The range is widened to a power of two of quanta, so that a step is a quantum and no less.
  const auto quanta = static_cast<std::uint32_t>(std::ceil((most - least).maxCoeff() / quantum_m));
  const int bits = std::bit_width(quanta);
  const auto range = static_cast<float>(((1U << static_cast<unsigned>(bits)) - 1) * quantum_m);
  draco::Encoder encoder;
  encoder.SetEncodingMethod(draco::POINT_CLOUD_KD_TREE_ENCODING);
  encoder.SetSpeedOptions(speed, speed);
  encoder.SetAttributeExplicitQuantization(draco::GeometryAttribute::POSITION, bits, 3, least.data(), range);
  draco::EncoderBuffer out;
  if (!encoder.EncodePointCloudToBuffer(*points, &out).ok()) return {};
  return {out.data(), out.size()};
}

std::size_t draco_point_count(const std::string& compressed) {
  draco::DecoderBuffer in;
  in.Init(compressed.data(), compressed.size());
  draco::Decoder decoder;
  const auto decoded = decoder.DecodePointCloudFromBuffer(&in);
  return decoded.ok() ? decoded.value()->num_points() : 0;
}

}  // namespace weft::clouds
