#include "models/board/maquette_ffp/package_number.hpp"

#include "firmware/arithmetic/maquette_ffp/package.hpp"
#include "models/board/maquette_ffp/package_processor.hpp"

namespace maquette::models {

namespace {

using namespace firmware::maquette_ffp;

PackageCall call(std::uint32_t entry, PackageNumber d7, PackageNumber d6 = 0.0F) {
  thread_local PackageProcessor processor;
  const PackageCall made = processor.call(entry, d7.bits, d6.bits);
  PackageMeter& meter = package_meter();
  ++meter.calls;
  meter.cycles += made.cycles;
  meter.reads += made.reads;
  meter.writes += made.writes;
  return made;
}

PackageNumber result_of(std::uint32_t entry, PackageNumber d7, PackageNumber d6 = 0.0F) {
  return PackageNumber::of_bits(call(entry, d7, d6).result);
}

}  // namespace

PackageMeter& package_meter() {
  thread_local PackageMeter meter;
  return meter;
}

PackageNumber operator+(PackageNumber a, PackageNumber b) { return result_of(k_add_entry, a, b); }
PackageNumber operator-(PackageNumber a, PackageNumber b) {
  return result_of(k_subtract_entry, a, b);
}
PackageNumber operator*(PackageNumber a, PackageNumber b) {
  return result_of(k_multiply_entry, a, b);
}
PackageNumber operator/(PackageNumber a, PackageNumber b) {
  return result_of(k_divide_entry, a, b);
}
PackageNumber operator-(PackageNumber a) { return result_of(k_negate_entry, a); }

bool operator<(PackageNumber a, PackageNumber b) {
  const mc68000::ConditionCodes codes = call(k_compare_entry, a, b).conditions;
  return codes.negative() != codes.overflow;
}

bool operator<=(PackageNumber a, PackageNumber b) {
  const mc68000::ConditionCodes codes = call(k_compare_entry, a, b).conditions;
  return codes.zero() || codes.negative() != codes.overflow;
}

PackageNumber square_root(PackageNumber a) { return result_of(k_square_root_entry, a); }

std::int32_t to_integer(PackageNumber a) {
  return static_cast<std::int32_t>(call(k_to_integer_entry, a).result);
}

}  // namespace maquette::models
