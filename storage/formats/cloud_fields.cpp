#include "storage/formats/cloud_fields.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>

#include "core/text.hpp"

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

bool CloudBuilder::suits(const CloudField& field, Role role) {
  if (field.count != 1 || !is_number(field.type, field.size)) return false;
  switch (role) {
    case Role::packed:
      return field.size == 4;
    case Role::red:
    case Role::green:
    case Role::blue:
      return field.type == 'U' && field.size <= 2;  // of other types nobody knows which number is full
    case Role::nx:
    case Role::ny:
    case Role::nz:
      return field.type == 'F';
    default:
      return true;
  }
}

bool CloudBuilder::has(Role role) const {
  return std::find(roles_.begin(), roles_.end(), role) != roles_.end();
}

/// Gives the field a role. Returns why it has none, to stand behind its name; empty if clouds have no place for it.
std::string CloudBuilder::give_role(const CloudField& field) {
  const Role role = role_of(field.name);
  const bool is_suited = role != Role::none && suits(field, role);
  const bool is_second = is_suited && has(role);
  roles_.push_back(is_suited && !is_second ? role : Role::none);
  if (is_second) return " beside an earlier one for the same";
  if (role == Role::none || is_suited) return "";
  return std::string(" of type ") + field.type + std::to_string(8 * field.size) +
         (field.count == 1 ? "" : " x " + std::to_string(field.count));
}

bool CloudBuilder::keep_if_all(std::initializer_list<Role> group) {
  if (std::all_of(group.begin(), group.end(), [this](Role role) { return has(role); })) return true;
  drop(group);
  return false;
}

void CloudBuilder::drop(std::initializer_list<Role> group) {
  for (Role& role : roles_) {
    if (std::find(group.begin(), group.end(), role) != group.end()) role = Role::none;
  }
}

Result<void> CloudBuilder::begin(const std::vector<CloudField>& fields, std::size_t points, std::string_view file,
                                 Leftovers& leftovers) {
  fields_ = fields;
  std::vector<std::string> reasons;
  for (const CloudField& field : fields) reasons.push_back(give_role(field));
  if (!keep_if_all({Role::x, Role::y, Role::z})) {
    return fail_at(file, fields.empty() ? 1 : fields.front().line, "a cloud needs the fields x, y and z");
  }
  const bool normals = keep_if_all({Role::nx, Role::ny, Role::nz});
  const bool three_colours = keep_if_all({Role::red, Role::green, Role::blue});
  if (three_colours) drop({Role::packed});
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (!takes(i) && fields[i].name != "_") leftovers.note("field " + fields[i].name + reasons[i], fields[i].line);
  }
  cloud_.points.assign(points, Eigen::Vector3f::Constant(kNoNumber));
  if (has(Role::intensity)) cloud_.intensities.assign(points, 0.0F);
  if (three_colours || has(Role::packed)) cloud_.colours.assign(points, {0, 0, 0});
  if (normals) cloud_.normals.assign(points, Eigen::Vector3f::Constant(kNoNumber));
  cloud_.width = points;
  return {};
}

bool CloudBuilder::put_colour(std::size_t field, std::size_t point, double number) {
  constexpr double kByte = 255.0;
  const double full = fields_[field].size == 2 ? 65535.0 : kByte;
  if (!(number >= 0.0 && number <= full)) return false;
  const auto channel = static_cast<std::size_t>(roles_[field]) - static_cast<std::size_t>(Role::red);
  cloud_.colours[point].at(channel) = static_cast<std::uint8_t>(std::lround(number * kByte / full));
  return true;
}

bool CloudBuilder::put_packed(std::size_t field, std::size_t point, double number) {
  std::uint32_t bits = 0;
  if (fields_[field].type == 'F') {
    bits = std::bit_cast<std::uint32_t>(static_cast<float>(number));  // text of the float that has the colour's bits
  } else {
    constexpr double kLeast = std::numeric_limits<std::int32_t>::min();
    constexpr double kMost = std::numeric_limits<std::uint32_t>::max();
    if (!(number >= kLeast && number <= kMost)) return false;
    bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(number));
  }
  put_bits(point, bits);
  return true;
}

void CloudBuilder::put_bits(std::size_t point, std::uint64_t bits) {
  cloud_.colours[point] = {static_cast<std::uint8_t>(bits >> 16U), static_cast<std::uint8_t>(bits >> 8U),
                           static_cast<std::uint8_t>(bits)};
}

bool CloudBuilder::put(std::size_t field, std::size_t point, double number) {
  const Role role = roles_[field];
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
      return put_colour(field, point, number);
    case Role::packed:
      return put_packed(field, point, number);
  }
  return false;
}

bool CloudBuilder::put(std::size_t field, std::size_t point, const std::uint8_t* bytes, bool big_endian) {
  const CloudField& of = fields_[field];
  const std::uint64_t bits = bits_of(bytes, of.size, big_endian);
  if (roles_[field] == Role::packed) {
    // Never through a float: colours with bits of a NaN would not survive.
    put_bits(point, bits);
    return true;
  }
  return put(field, point, number_of(bits, of.type, of.size));
}

}  // namespace weft::formats
