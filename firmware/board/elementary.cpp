#include "firmware/board/elementary.hpp"

#include "firmware/arithmetic/elementary.hpp"

namespace maquette::firmware {

BoardNumber exponential(BoardNumber x) { return exponential<BoardNumber>(x); }

BoardNumber power(BoardNumber base, BoardNumber exponent) {
  return power<BoardNumber>(base, exponent);
}

BoardNumber arc_cosine(BoardNumber cosine) { return arc_cosine<BoardNumber>(cosine); }

}  // namespace maquette::firmware
