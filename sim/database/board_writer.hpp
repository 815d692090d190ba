#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "firmware/arithmetic/number_format.hpp"
#include "firmware/layout.hpp"

namespace maquette::sim {

/// Writes structures of the firmware into a board's RAM as the board's program reads them:
/// big-endian, laid out as firmware::BoardLayout tells. Pointers become the addresses that were
/// told of what they point to.
class BoardWriter {
 public:
  /// The RAM is kept by reference.
  BoardWriter(std::vector<unsigned char>& ram, firmware::NumberFormat numbers)
      : ram_(ram), numbers_(numbers) {}

  /// Tells where on the board it is that a pointer of the host points to.
  void tell(const void* pointer, std::uint32_t address) { addresses_[pointer] = address; }

  /// What was told of a pointer. Throws std::out_of_range when nothing was.
  [[nodiscard]] std::uint32_t address_of(const void* pointer) const {
    return addresses_.at(pointer);
  }

  /// Writes one after another from an even address on; returns the address behind them. Throws
  /// std::out_of_range behind the RAM's end and for a pointer that nothing was told of.
  template <class Structure>
  std::uint32_t write(std::uint32_t address, const Structure* first, std::size_t count) {
    position_ = address;
    for (std::size_t i = 0; i < count; ++i) {
      (*this)(first[i]);
    }
    return position_;
  }

  template <class Field>
  void operator()(const Field& field) {
    if constexpr (std::is_integral_v<Field> || std::is_enum_v<Field>) {
      put(static_cast<std::uint32_t>(field), sizeof field);
    } else if constexpr (std::is_pointer_v<Field>) {
      put(field == nullptr ? 0 : address_of(field), firmware::BoardLayout::k_long_bytes);
    } else {
      firmware::BoardLayout layout;
      for_each_field(field, layout);
      align(layout.alignment());
      for_each_field(field, *this);
      align(layout.alignment());
    }
  }

  template <class Field, std::size_t count>
  void operator()(const Field (&fields)[count]) {
    for (const Field& field : fields) {
      (*this)(field);
    }
  }

  void operator()(const float& number) {
    put(firmware::bits_in(numbers_, number), firmware::BoardLayout::k_long_bytes);
  }

  void operator()(const firmware::Vector<float>& vector) {
    for (int i = 0; i < 3; ++i) {
      (*this)(vector[i]);
    }
  }

  void operator()(const firmware::Affine<float>& frame) {
    for (int column = 0; column < 4; ++column) {
      (*this)(frame[column]);
    }
  }

 private:
  void align(std::int64_t alignment);
  void put(std::uint32_t value, std::size_t bytes);

  std::vector<unsigned char>& ram_;
  firmware::NumberFormat numbers_;
  std::map<const void*, std::uint32_t> addresses_;
  std::uint32_t position_ = 0;
};

}  // namespace maquette::sim
