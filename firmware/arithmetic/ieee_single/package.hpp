#pragma once

#include <cstdint>

/// Stands in a board's RAM for an arithmetic package of IEEE single precision, of which the project
/// has none: its routines have no code but an instruction at which an MC68000 stops. The host
/// computes in their place.
namespace maquette::firmware::ieee_single {

/// Where each routine begins, in bytes from the start of the package.
inline constexpr std::uint32_t k_add_entry = 0;
inline constexpr std::uint32_t k_subtract_entry = 2;
inline constexpr std::uint32_t k_multiply_entry = 4;
inline constexpr std::uint32_t k_divide_entry = 6;
inline constexpr std::uint32_t k_compare_entry = 8;
inline constexpr std::uint32_t k_square_root_entry = 10;
inline constexpr std::uint32_t k_to_integer_entry = 12;
inline constexpr std::uint32_t k_from_integer_entry = 14;

/// ILLEGAL, once for each.
inline constexpr std::uint8_t k_package[] = {0x4a, 0xfc, 0x4a, 0xfc, 0x4a, 0xfc, 0x4a, 0xfc,
                                             0x4a, 0xfc, 0x4a, 0xfc, 0x4a, 0xfc, 0x4a, 0xfc};

}  // namespace maquette::firmware::ieee_single
