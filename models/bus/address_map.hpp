#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace maquette::models {

/// Byte addresses [base, base + size) of a bus, answered by one slave.
struct AddressRange {
  std::string slave;
  std::uint64_t base;
  std::uint64_t size;
  /// Each access takes the same time, whenever it comes; it may be told several writes one after
  /// the other, of those to one address the last alone.
  bool is_steady = false;

  [[nodiscard]] bool contains(std::uint64_t address) const { return address - base < size; }
};

/// Which slave answers which addresses; slaves are numbered from 0 as they are added.
class AddressMap {
 public:
  static constexpr int k_unmapped = -1;

  /// Throws std::invalid_argument for an empty range, or one that overlaps an earlier one.
  void add(const AddressRange& range);

  /// The number of the slave at `address`, or k_unmapped.
  [[nodiscard]] int find(std::uint64_t address) const;

  [[nodiscard]] int count() const { return static_cast<int>(ranges_.size()); }
  [[nodiscard]] const AddressRange& operator[](int slave) const {
    return ranges_[static_cast<std::size_t>(slave)];
  }

  /// One line per slave: first and last address, name.
  [[nodiscard]] std::string text() const;

 private:
  std::vector<AddressRange> ranges_;
};

}  // namespace maquette::models
