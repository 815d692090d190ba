#pragma once

#include <cstdint>

/// The Boolean operators that a composite combines its two operands by (paper, section II.2; Roth
/// 1982), and what each of them leaves of the operands' matter.
namespace maquette::firmware {

enum class BooleanOperator : std::uint8_t { union_of, intersection, difference };
/// So many are told apart.
inline constexpr int k_boolean_operator_limit = 8;

/// Where matter is left; an operator leaves some in at least one of these regions.
struct KeptRegions {
  bool first_alone;   ///< inside the first operand, outside of the second
  bool second_alone;  ///< inside the second operand, outside of the first
  bool overlap;       ///< inside both
};

/// The regions that an operator keeps, none where the number is no operator's.
[[nodiscard]] constexpr KeptRegions kept_by(BooleanOperator combination) {
  switch (combination) {
    case BooleanOperator::union_of:
      return {true, true, true};
    case BooleanOperator::intersection:
      return {false, false, true};
    case BooleanOperator::difference:
      return {true, false, false};
  }
  return {false, false, false};
}

/// The only operator of whose regions `law` holds. Boards compare with it, which is fastest; with a
/// further such operator it is no constant, and what compares does not compile.
template <class Law>
constexpr BooleanOperator only_operator(Law law) {
  BooleanOperator found[1] = {};
  int count = 0;
  for (int number = 0; number < k_boolean_operator_limit; ++number) {
    const auto combination = static_cast<BooleanOperator>(number);
    const KeptRegions kept = kept_by(combination);
    if ((kept.first_alone || kept.second_alone || kept.overlap) && law(kept)) {
      found[count++] = combination;
    }
  }
  return found[count - 1];
}

/// Where a ray misses the second operand, this leaves nothing; the others leave the first.
inline constexpr BooleanOperator k_drops_first =
    only_operator([](const KeptRegions& kept) { return !kept.first_alone; });

/// Where a ray misses the first operand, this leaves the second; the others leave nothing, nor is
/// there any matter of the second elsewhere.
inline constexpr BooleanOperator k_keeps_second =
    only_operator([](const KeptRegions& kept) { return kept.second_alone; });

/// This leaves all matter of both operands, so that each may be looked at on its own.
inline constexpr BooleanOperator k_keeps_all = only_operator(
    [](const KeptRegions& kept) { return kept.first_alone && kept.second_alone && kept.overlap; });

}  // namespace maquette::firmware
