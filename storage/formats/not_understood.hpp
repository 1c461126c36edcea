#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/result.hpp"

namespace weft::formats {

/// Describes something of a file that a reader knows of and does not take: its first line, and how often it is there.
struct NotUnderstood {
  std::string what;
  std::size_t line = 0;  ///< from 1
  std::size_t count = 1;
  bool operator==(const NotUnderstood&) const = default;
};

/// Returns "graph.g2o:12: VERTEX_XY, 37 times".
std::string to_string(const NotUnderstood& part, std::string_view file);

/// Counts what is not understood by its name, in the order in which it was first noted.
class Leftovers {
 public:
  void note(std::string_view what, std::size_t line);
  std::vector<NotUnderstood> take() { return std::move(parts_); }

 private:
  std::vector<NotUnderstood> parts_;
};

/// Holds the value that a reader made of a file, and the parts of the file that are not in it.
template <class T>
struct Read {
  T value;
  std::vector<NotUnderstood> not_understood;
};

}  // namespace weft::formats
