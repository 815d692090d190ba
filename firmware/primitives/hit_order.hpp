#pragma once

#include "firmware/primitives/primitive.hpp"

namespace maquette::firmware {

/// Puts hits in the order of their distances: by insertion, as they are few.
template <class Real>
void sort(Hit<Real>* hits, int count) {
  for (int i = 1; i < count; ++i) {
    const Hit<Real> hit = hits[i];
    int k = i;
    for (; k > 0 && hit.distance < hits[k - 1].distance; --k) {
      hits[k] = hits[k - 1];
    }
    hits[k] = hit;
  }
}

}  // namespace maquette::firmware
