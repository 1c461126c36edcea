#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "storage/formats/cloud.hpp"

namespace weft::formats {

/// One column of a cloud file.
struct CloudField {
  std::string name;
  char type = 'F';  ///< I, U: two's complement and unsigned; F: IEEE 754
  std::size_t size = 4;
  std::size_t count = 1;
  std::size_t line = 0;  ///< where it is declared
  std::size_t bytes() const { return size * count; }
};

/// 1, 2, 4 or 8 bytes for whole numbers, 4 or 8 for others.
bool is_number(char type, std::size_t size);

/// Takes a file's columns into a cloud, by their names.
class CloudBuilder {
 public:
  /// Fields without a place in a cloud are noted. invalid: x, y or z is missing, or a field has a type that it cannot
  /// have.
  Result<void> begin(const std::vector<CloudField>& fields, std::size_t points, std::string_view file,
                     Leftovers& leftovers);
  bool takes(std::size_t field) const { return roles_[field] != Role::none; }
  /// False: the number cannot be one of this field (an infinite coordinate).
  bool put(std::size_t field, std::size_t point, double number);
  /// The same from a file's bytes.
  bool put(std::size_t field, std::size_t point, const std::uint8_t* bytes, bool big_endian);
  Cloud take() { return std::move(cloud_); }

 private:
  enum class Role : std::uint8_t { none, x, y, z, intensity, packed, red, green, blue, nx, ny, nz };
  static Role role_of(std::string_view name);
  bool suits(const CloudField& field, Role role) const;
  bool has(Role role) const;

  std::vector<CloudField> fields_;
  std::vector<Role> roles_;
  Cloud cloud_;
};

}  // namespace weft::formats
