#pragma once
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "storage/formats/cloud.hpp"

namespace weft::formats {

/// Describes one column of a cloud file.
struct CloudField {
  std::string name;
  char type = 'F';  ///< I, U: two's complement and unsigned; F: IEEE 754
  std::size_t size = 4;
  std::size_t count = 1;
  std::size_t line = 0;  ///< where it is declared
  std::size_t bytes() const { return size * count; }
};

/// Returns whether numbers can have that size: 1, 2, 4 or 8 bytes for whole numbers, 4 or 8 for others.
bool is_number(char type, std::size_t size);

/// Takes a file's columns into a cloud, by their names.
class CloudBuilder {
 public:
  /// Notes fields without a place in a cloud, of a type that says nothing of their scale, and second ones for the
  /// same. invalid: x, y or z is missing.
  Result<void> begin(const std::vector<CloudField>& fields, std::size_t points, std::string_view file,
                     Leftovers& leftovers);
  bool takes(std::size_t field) const { return roles_[field] != Role::none; }
  /// Puts a number. False: it cannot be one of this field (an infinite coordinate).
  bool put(std::size_t field, std::size_t point, double number);
  /// Puts the same from a file's bytes.
  bool put(std::size_t field, std::size_t point, const std::uint8_t* bytes, bool big_endian);
  Cloud take() { return std::move(cloud_); }

 private:
  enum class Role : std::uint8_t { none, x, y, z, intensity, packed, red, green, blue, nx, ny, nz };
  static Role role_of(std::string_view name);
  static bool suits(const CloudField& field, Role role);
  bool has(Role role) const;
  std::string give_role(const CloudField& field);
  /// Drops a group of which not all are there. Returns false when it did.
  bool keep_if_all(std::initializer_list<Role> group);
  void drop(std::initializer_list<Role> group);
  bool put_colour(std::size_t field, std::size_t point, double number);
  bool put_packed(std::size_t field, std::size_t point, double number);
  /// Puts a colour from 0x00RRGGBB.
  void put_bits(std::size_t point, std::uint64_t bits);

  std::vector<CloudField> fields_;
  std::vector<Role> roles_;
  Cloud cloud_;
};

}  // namespace weft::formats
