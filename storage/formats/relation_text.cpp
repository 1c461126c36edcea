#include "storage/formats/relation_text.hpp"

#include <array>

#include "storage/formats/lines.hpp"

namespace weft::formats {
namespace {

std::string joined(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : " ") + text_of(number);
  return text;
}

std::vector<double> numbers_of(const Metric2& metric) {
  return {metric.a_from_b.x, metric.a_from_b.y, metric.a_from_b.heading};
}
std::vector<double> numbers_of(const Metric3& metric) {
  const Eigen::Vector3d& t = metric.a_from_b.translation;
  const Eigen::Quaterniond& q = metric.a_from_b.rotation;
  return {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()};
}
std::vector<double> numbers_of(const AlongPath& along) {
  return {along.distance_m, along.heading_shift_rad};
}

}  // namespace

const char* kind_text(const Relation& relation) {
  static constexpr std::array<const char*, 3> kKinds = {"planar", "spatial", "along"};
  return kKinds.at(relation.index());
}

std::string numbers_text(const Relation& relation) {
  return std::visit([](const auto& held) { return joined(numbers_of(held)); }, relation);
}

const char* drivable_text(Drivable drivable) {
  static constexpr std::array<const char*, 4> kDrivable = {"none", "a_to_b", "b_to_a", "both"};
  return kDrivable.at(static_cast<std::size_t>(drivable));
}

std::map<PlaceId, std::string> labels_by_place(const Window& network) {
  std::map<PlaceId, std::string> labels;
  for (const auto& [label, place] : network.labels) {
    std::string& text = labels[place];
    text += (text.empty() ? "" : " ") + label;
  }
  return labels;
}

}  // namespace weft::formats
