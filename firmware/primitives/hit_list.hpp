#pragma once

#include "firmware/primitives/hit_order.hpp"

/// Hits of a ray with a solid that it may meet more often than there is room for hits.
namespace maquette::firmware {

/// Hits as they are found, in no order. Behind the ray's origin the last one or two stay in any
/// case, which tell whether it starts inside, and ahead of it more than a hundred, the nearest.
template <class Real>
struct HitList {
  Hit<Real>* hits;  ///< room for k_primitive_hit_limit
  int count;
  bool is_cut;
  Real end;  ///< of one that is cut: from here on hits may be missing
};

template <class Real>
HitList<Real> hit_list(Hit<Real>* hits) {
  return {hits, 0, false, far_away<Real>()};
}

/// Drops what matters least of the hits, so that there is room for at least as many.
template <class Real>
[[gnu::noinline]] void drop_hits(HitList<Real>& list) {
  constexpr int k_kept = k_primitive_hit_limit / 2;
  Hit<Real>* hits = list.hits;
  sort(hits, list.count);
  int behind = 0;
  while (behind < list.count && hits[behind].distance < constant<Real>(0)) {
    ++behind;
  }
  const int dropped = behind > 2 ? (behind - 1) & ~1 : 0;
  list.count -= dropped;
  for (int i = 0; i < list.count; ++i) {
    hits[i] = hits[i + dropped];
  }
  if (list.count > k_kept) {
    list.end = smaller(list.end, hits[k_kept].distance);
    list.is_cut = true;
    list.count = k_kept;
  }
}

/// So many of the hits, in order, are before the end.
template <class Real>
[[gnu::noinline]] int before_end(const HitList<Real>& list) {
  int count = list.count;
  while (count > 0 && !(list.hits[count - 1].distance < list.end)) {
    --count;
  }
  return count & ~1;
}

/// Makes room for some more hits.
template <class Real>
void make_room(HitList<Real>& list, int more) {
  if (list.count + more > k_primitive_hit_limit) {
    drop_hits(list);
  }
}

/// Puts the hits in order; returns their number, which is even.
template <class Real>
int in_order(const HitList<Real>& list) {
  sort(list.hits, list.count);
  return list.is_cut ? before_end(list) : list.count;
}

}  // namespace maquette::firmware
