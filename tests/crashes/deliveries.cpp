#include "tests/crashes/deliveries.hpp"

#include "core/network/codec.hpp"
#include "tests/crashes/wire.hpp"

namespace weft::crashes {
namespace {

constexpr std::uint64_t kShared = 16;

Random random_for(std::uint64_t seed, std::uint64_t stream, std::uint64_t number) {
  return Random(seed).fork(stream).fork(number);
}

Bytes content_of(std::uint64_t seed, std::uint32_t producer, std::uint64_t index, bool is_shared) {
  Random random = is_shared ? random_for(seed, 1000, index % kShared) : random_for(seed, producer, index);
  const std::size_t size = 500 + random.below(6000);
  return storage::sample::content(random, size);
}

Edge odometry(const PlaceId& from) {
  Edge edge;
  edge.id = {from, {from.experience, from.index + 1}};
  edge.a_from_b = Metric2{{0.3, 0.01, 0.002}, Eigen::Matrix3d::Identity() * 1e-4};
  edge.method = "marks";
  return edge;
}

}  // namespace

ExperienceId experience_of(std::uint32_t producer) {
  return {producer % 2 == 0 ? producer + 1ULL : 0xf000'0000'0000'0000ULL + producer};
}

storage::sample::Delivery delivery_of(std::uint64_t seed, std::uint32_t producer, std::uint64_t sequence) {
  storage::sample::Delivery delivery;
  Batch& batch = delivery.batch;
  batch.experience = experience_of(producer);
  batch.sequence = sequence;
  batch.robot = storage::sample::robot(producer + 1);
  batch.name = "producer-" + std::to_string(producer);
  batch.method = "marks";
  for (std::uint32_t at = 0; at < kPlaces; ++at) {
    const std::uint64_t index = (sequence - 1) * kPlaces + at;
    delivery.contents.push_back(content_of(seed, producer, index, at == 0));
    Place place;
    place.id = {batch.experience, static_cast<std::uint32_t>(index)};
    place.method = "marks";
    place.content = {hash_bytes(delivery.contents.back()), delivery.contents.back().size()};
    place.robot = batch.robot;
    place.frame = index;
    batch.places.push_back(place);
    if (index > 0) batch.edges.push_back(odometry({batch.experience, static_cast<std::uint32_t>(index - 1)}));
  }
  batch.edges.push_back(storage::sample::stitch(batch.places.front().id, batch.places.back().id));
  return delivery;
}

bool send_delivery(int to, const storage::sample::Delivery& delivery) {
  const Bytes batch = encode(delivery.batch);
  Bytes frame;
  const auto put = [&](ByteView bytes) {
    const auto size = static_cast<std::uint32_t>(bytes.size());
    const auto* const raw = reinterpret_cast<const std::uint8_t*>(&size);
    frame.insert(frame.end(), raw, raw + sizeof size);
    frame.insert(frame.end(), bytes.begin(), bytes.end());
  };
  put(batch);
  for (const Bytes& content : delivery.contents) put(content);
  return write_whole(to, frame.data(), frame.size());
}

bool receive_delivery(int from, storage::sample::Delivery& delivery) {
  const auto get = [&](Bytes& bytes) {
    std::uint32_t size = 0;
    if (!read_whole(from, &size, sizeof size)) return false;
    bytes.resize(size);
    return read_whole(from, bytes.data(), bytes.size());
  };
  Bytes encoded;
  if (!get(encoded)) return false;
  auto batch = decode_batch(encoded);
  if (!batch) return false;
  delivery.batch = std::move(*batch);
  delivery.contents.resize(delivery.batch.places.size());
  for (Bytes& content : delivery.contents) {
    if (!get(content)) return false;
  }
  return true;
}

}  // namespace weft::crashes
