#pragma once

namespace weft {

/// Makes one visitor of several lambdas: std::visit(Overloaded{[](const A&) {}, [](const B&) {}}, variant).
template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace weft
