#pragma once
#include <string_view>
#include <tl/expected.hpp>

namespace weft::agents {

/// Tells why a pair shows nothing: a name that is counted and shown, the measured value and its bound.
struct Unseen {
  std::string_view reason;  ///< static text, e.g. "few_inliers"
  double measured = 0.0;
  double bound = 0.0;
};
template <class T>
using OrUnseen = tl::expected<T, Unseen>;

}  // namespace weft::agents
