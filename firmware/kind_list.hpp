#pragma once

/// Tables whose rows are types.
namespace maquette::firmware {

/// The rows of a table, in the order of their numbers.
template <class... Kinds>
struct KindList {
  static constexpr int k_count = sizeof...(Kinds);
};

/// The place of a row in a list.
template <class Kind, class List>
struct PlaceIn;

template <class Kind, class... Others>
struct PlaceIn<Kind, KindList<Kind, Others...>> {
  static constexpr int k_value = 0;
};

template <class Kind, class Other, class... Others>
struct PlaceIn<Kind, KindList<Other, Others...>> {
  static constexpr int k_value = 1 + PlaceIn<Kind, KindList<Others...>>::k_value;
};

}  // namespace maquette::firmware
