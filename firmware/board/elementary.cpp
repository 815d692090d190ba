#include "firmware/board/ffp.hpp"

namespace maquette::firmware {

Ffp exponential(Ffp x) { return exponential<Ffp>(x); }

Ffp power(Ffp base, Ffp exponent) { return power<Ffp>(base, exponent); }

Ffp arc_cosine(Ffp cosine) { return arc_cosine<Ffp>(cosine); }

}  // namespace maquette::firmware
