#pragma once

#include <cstddef>
#include <cstring>
#include <limits>

#include "firmware/arithmetic/counted_meter.hpp"
#include "firmware/arithmetic/elementary.hpp"
#include "firmware/arithmetic/real.hpp"
#include "firmware/arithmetic/stop_request.hpp"

namespace maquette::firmware {

template <>
struct Meter<struct Counted> {
  static void charge(Operation operation, std::uint32_t count) {
    counted_meter.place(operation) += count;
  }
};

/// A float that counts what is done with it. Gives the same bits as float.
struct Counted {
  float value;

  Counted() = default;
  constexpr Counted(float initial) : value(initial) {}  // NOLINT(google-explicit-constructor)
};

namespace counting {

/// 1 when the float is plus or minus zero; without a branch.
inline std::uint32_t is_zero(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return static_cast<std::uint32_t>((bits << 1U) == 0);
}

inline void count(Operation operation, std::uint32_t times = 1) {
  counted_meter.place(operation) += times;
}

}  // namespace counting

/// Sums look for a zero operand by the product. It is also zero when both are tiny; at least one is
/// then below 5.4e-20, which is zero in the package's format.
[[gnu::always_inline]] inline Counted operator+(Counted a, Counted b) {
  counting::count(Operation::add);
  counted_meter.place(Operation::add_zero) += counting::is_zero(a.value * b.value);
  return {a.value + b.value};
}

[[gnu::always_inline]] inline Counted operator-(Counted a, Counted b) {
  counting::count(Operation::subtract);
  counted_meter.place(Operation::subtract_zero) += counting::is_zero(a.value * b.value);
  return {a.value - b.value};
}

/// A product is taken as one with a zero operand when it is zero: the package leaves as early on
/// an underflow.
[[gnu::always_inline]] inline Counted operator*(Counted a, Counted b) {
  const float product = a.value * b.value;
  counting::count(Operation::multiply);
  counted_meter.place(Operation::multiply_zero) += counting::is_zero(product);
  return {product};
}

inline Counted operator/(Counted a, Counted b) {
  counting::count(Operation::divide);
  counted_meter.place(Operation::divide_zero) += counting::is_zero(a.value);
  return {a.value / b.value};
}

inline Counted operator-(Counted a) {
  counting::count(Operation::negate);
  return {-a.value};
}

inline Counted& operator+=(Counted& a, Counted b) { return a = a + b; }
inline Counted& operator-=(Counted& a, Counted b) { return a = a - b; }
inline Counted& operator*=(Counted& a, Counted b) { return a = a * b; }
inline Counted& operator/=(Counted& a, Counted b) { return a = a / b; }

inline bool operator<(Counted a, Counted b) {
  counting::count(Operation::compare);
  return a.value < b.value;
}
inline bool operator>(Counted a, Counted b) { return b < a; }
inline bool operator<=(Counted a, Counted b) {
  counting::count(Operation::compare);
  return a.value <= b.value;
}
inline bool operator>=(Counted a, Counted b) { return b <= a; }

inline Counted square_root(Counted a) {
  counting::count(Operation::square_root);
  return {square_root(a.value)};
}

inline Counted saturated_inverse(Counted a) {
  counting::count(Operation::divide);
  return {saturated_inverse(a.value)};
}

inline Counted absolute(Counted a) {
  counting::count(Operation::absolute);
  return {absolute(a.value)};
}

inline std::int32_t to_integer(Counted a) {
  counting::count(Operation::float_to_integer);
  return to_integer(a.value);
}

/// The elementary functions are calls of the arithmetic package, counted whole.
inline Counted exponential(Counted a) {
  counting::count(Operation::exponential);
  return {exponential(a.value)};
}

inline Counted power(Counted base, Counted exponent) {
  counting::count(Operation::power);
  return {power(base.value, exponent.value)};
}

inline Counted arc_cosine(Counted a) {
  counting::count(Operation::arc_cosine);
  return {arc_cosine(a.value)};
}

template <>
struct InFunction<Counted> {
  explicit InFunction(Function function) : before_(counted_meter.cell) {
    counted_meter.enter_function(static_cast<std::uint32_t>(function));
  }
  InFunction(const InFunction&) = delete;
  InFunction& operator=(const InFunction&) = delete;
  InFunction(InFunction&&) = delete;
  InFunction& operator=(InFunction&&) = delete;
  ~InFunction() { counted_meter.cell = before_; }

 private:
  std::size_t before_;
};

template <>
struct InRay<Counted> {
  explicit InRay(RayKind kind) : before_(counted_meter.ray) {
    end_if_requested();
    counted_meter.enter_ray(static_cast<std::uint32_t>(kind));
  }
  InRay(const InRay&) = delete;
  InRay& operator=(const InRay&) = delete;
  InRay(InRay&&) = delete;
  InRay& operator=(InRay&&) = delete;
  ~InRay() { counted_meter.enter_ray(before_); }

 private:
  std::uint32_t before_;
};

template <>
struct InLeg<Counted> {
  template <class Messages>
  InLeg(Stage stage, const Messages& messages, int primitive = 0) {
    if (counted_meter.listener != nullptr) {
      counted_meter.listener->begin(counted_meter.listener->self, stage, primitive, messages());
    }
  }
  InLeg(const InLeg&) = delete;
  InLeg& operator=(const InLeg&) = delete;
  InLeg(InLeg&&) = delete;
  InLeg& operator=(InLeg&&) = delete;
  ~InLeg() {
    if (counted_meter.listener != nullptr) {
      counted_meter.listener->end(counted_meter.listener->self);
    }
  }
};

template <>
inline void returns_also<Counted>(int words) {
  if (counted_meter.listener != nullptr) {
    counted_meter.listener->returns_also(counted_meter.listener->self, words);
  }
}

template <>
struct LightAsked<Counted> {
  static void put(int light) { counted_meter.shadow_ray = shadow_of(light); }
  static RayKind shadow_ray() { return counted_meter.shadow_ray; }
};

template <>
struct WaitingRays<Counted> {
  static void put(std::int32_t place, RayKind kind) {
    counted_meter.waiting[static_cast<std::uint32_t>(place) % k_waiting_rays] = kind;
  }
  static RayKind at(std::int32_t place) {
    return counted_meter.waiting[static_cast<std::uint32_t>(place) % k_waiting_rays];
  }
};

template <>
struct ExtentUse<Counted> {
  static constexpr bool is_chosen = true;
  bool tests_rectangles = true;
  bool tests_boxes = true;
  bool tests_spheres = true;
  const std::uint32_t* leaves_below = nullptr;  ///< by node, where what is spared shall be told

  void note(ExtentKind kind, std::uint32_t node, bool is_met) const {
    ExtentCounts& counts = counted_meter.extents[static_cast<int>(kind)];
    ++counts.tests;
    if (is_met) {
      ++counts.hits;
    } else if (leaves_below != nullptr) {
      counts.spared_leaves += leaves_below[node];
    }
  }
  void note_entry(std::uint32_t node, const Counted& entry) const {
    note(ExtentKind::box, node, entry.value < far_away<float>());
  }
};

template <>
struct RootSteps<Counted> {
  static void note(int steps) {
    if (counted_meter.is_in_intersection()) {
      ++counted_meter.intersection_roots[steps];
      counted_meter.root_steps_end =
          steps < counted_meter.root_steps_end ? counted_meter.root_steps_end : steps + 1;
    }
  }
};

/// This thread's work since the last reset. Throughout, operations on zero operands are taken out
/// of their general class.
inline LongWork long_counted_work() { return general_apart(counted_meter.sum()); }

/// The same where it is a pixel's or the preprocessing's. Throws as narrowed.
inline Work counted_work() { return narrowed(long_counted_work()); }

/// Sets this thread's meter to zero.
inline void reset_counted_work() { counted_meter.reset(); }

}  // namespace maquette::firmware

/// GLM and the tolerances ask for these; a Counted is a float to them.
template <>
class std::numeric_limits<maquette::firmware::Counted> : public std::numeric_limits<float> {};
