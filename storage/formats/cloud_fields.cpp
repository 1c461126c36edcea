#include "storage/formats/cloud_fields.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>

namespace weft::formats {
namespace {

constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

std::uint64_t bits_of(const std::uint8_t* bytes, std::size_t size, bool big_endian) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i) {
    bits = (bits << 8U) | bytes[big_endian ? i : size - 1 - i];
  }
  return bits;
}

double number_of(std::uint64_t bits, char type, std::size_t size) {
  if (type == 'F') {
    return size == 8 ? std::bit_cast<double>(bits) : std::bit_cast<float>(static_cast<std::uint32_t>(bits));
  }
  if (type == 'U') return static_cast<double>(bits);
  const std::size_t unused = 64 - 8 * size;
  return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
}

}  // namespace

bool is_number(char type, std::size_t size) {
  if (type == 'F') return size == 4 || size == 8;
  return (type == 'I' || type == 'U') && (size == 1 || size == 2 || size == 4 || size == 8);
}

CloudBuilder::Role CloudBuilder::role_of(std::string_view name) {
  static const std::map<std::string_view, Role> kRoles = {
      {"x", Role::x},         {"y", Role::y},
      {"z", Role::z},         {"intensity", Role::intensity},
      {"rgb", Role::packed},  {"scalar_intensity", Role::intensity},
      {"rgba", Role::packed}, {"scalar_Intensity", Role::intensity},
      {"red", Role::red},     {"green", Role::green},
      {"blue", Role::blue},   {"normal_x", Role::nx},
      {"normal_y", Role::ny}, {"normal_z", Role::nz},
      {"nx", Role::nx},       {"ny", Role::ny},
      {"nz", Role::nz}};
  const auto found = kRoles.find(name);
  return found == kRoles.end() ? Role::none : found->second;
}

bool CloudBuilder::suits(const CloudField& field, Role role) const {
  if (field.count != 1) return false;
  switch (role) {
    case Role::intensity:
      return true;
    case Role::packed:
      return field.size == 4 && field.type != 'I';
    case Role::red:
    case Role::green:
    case Role::blue:
      return field.size == 1 && field.type == 'U';
    default:
      return field.type == 'F';
  }
}

bool CloudBuilder::has(Role role) const {
  return std::find(roles_.begin(), roles_.end(), role) != roles_.end();
}

Result<void> CloudBuilder::begin(const std::vector<CloudField>& fields, std::size_t points, std::string_view file,
                                 Leftovers& leftovers) {
  fields_ = fields;
  for (const CloudField& field : fields) {
    const Role role = role_of(field.name);
    if (role != Role::none && !suits(field, role)) {
      return fail_at(file, field.line,
                     "field " + field.name + " has type " + field.type + std::to_string(8 * field.size) + " x " +
                         std::to_string(field.count) + ", which it cannot have");
    }
    if (role != Role::none && has(role)) {
      return fail_at(file, field.line, "field " + field.name + " stands for what an earlier one is already");
    }
    roles_.push_back(role);
  }
  const auto drop_unless_all = [this](const std::vector<Role>& group) {
    if (std::all_of(group.begin(), group.end(), [this](Role role) { return has(role); })) return true;
    for (Role& role : roles_) {
      if (std::find(group.begin(), group.end(), role) != group.end()) role = Role::none;
    }
    return false;
  };
  if (!drop_unless_all({Role::x, Role::y, Role::z})) {
    return fail_at(file, fields.empty() ? 1 : fields.front().line, "a cloud needs the fields x, y and z");
  }
  const bool normals = drop_unless_all({Role::nx, Role::ny, Role::nz});
  const bool colours = drop_unless_all({Role::red, Role::green, Role::blue}) || has(Role::packed);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (!takes(i) && fields[i].name != "_") leftovers.note("field " + fields[i].name, fields[i].line);
  }
  cloud_.points.assign(points, Eigen::Vector3f::Constant(kNoNumber));
  if (has(Role::intensity)) cloud_.intensities.assign(points, 0.0F);
  if (colours) cloud_.colours.assign(points, {0, 0, 0});
  if (normals) cloud_.normals.assign(points, Eigen::Vector3f::Constant(kNoNumber));
  cloud_.width = points;
  return {};
}

bool CloudBuilder::put(std::size_t field, std::size_t point, double number) {
  const Role role = roles_[field];
  const auto byte = [number] { return static_cast<std::uint8_t>(std::clamp(number, 0.0, 255.0)); };
  switch (role) {
    case Role::none:
      return true;
    case Role::x:
    case Role::y:
    case Role::z:
      cloud_.points[point][static_cast<int>(role) - static_cast<int>(Role::x)] = static_cast<float>(number);
      return !std::isinf(static_cast<float>(number));
    case Role::nx:
    case Role::ny:
    case Role::nz:
      cloud_.normals[point][static_cast<int>(role) - static_cast<int>(Role::nx)] = static_cast<float>(number);
      return true;
    case Role::intensity:
      cloud_.intensities[point] = static_cast<float>(number);
      return true;
    case Role::red:
    case Role::green:
    case Role::blue:
      cloud_.colours[point].at(static_cast<std::size_t>(role) - static_cast<std::size_t>(Role::red)) = byte();
      return number >= 0.0 && number <= 255.0;
    case Role::packed: {
      // Text of a float field is the float whose bits are the colour.
      const bool as_float = fields_[field].type == 'F';
      if (!as_float && !(number >= 0.0 && number <= std::numeric_limits<std::uint32_t>::max())) return false;
      const std::uint32_t bits =
          as_float ? std::bit_cast<std::uint32_t>(static_cast<float>(number)) : static_cast<std::uint32_t>(number);
      cloud_.colours[point] = {static_cast<std::uint8_t>(bits >> 16U), static_cast<std::uint8_t>(bits >> 8U),
                               static_cast<std::uint8_t>(bits)};
      return true;
    }
  }
  return false;
}

bool CloudBuilder::put(std::size_t field, std::size_t point, const std::uint8_t* bytes, bool big_endian) {
  const CloudField& of = fields_[field];
  const std::uint64_t bits = bits_of(bytes, of.size, big_endian);
  if (roles_[field] == Role::packed) {
    // Never through a float: colours with bits of a NaN would not survive.
    cloud_.colours[point] = {static_cast<std::uint8_t>(bits >> 16U), static_cast<std::uint8_t>(bits >> 8U),
                             static_cast<std::uint8_t>(bits)};
    return true;
  }
  return put(field, point, number_of(bits, of.type, of.size));
}

}  // namespace weft::formats
