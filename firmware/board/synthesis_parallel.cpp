#include "firmware/board/elementary.hpp"
#include "firmware/board/unit_synthesis.hpp"
#include "firmware/preprocess.hpp"
#include "firmware/synthesize.hpp"

/// What boards do in a parallel view in place of the functions whose names stand behind
/// `parallel_`, with the same operands.
namespace maquette::firmware {

[[gnu::flatten]] Rectangle parallel_projected(const Box<BoardNumber>& local,
                                              const Affine<BoardNumber>& to_screen,
                                              BoardNumber scale,
                                              const Observer<BoardNumber>& observer) {
  return preprocessing::projected<Projection::parallel>(local, to_screen, scale, observer);
}

std::int32_t parallel_cross_convex(const Frame<BoardNumber>& frame,
                                   const RayQuery<BoardNumber>& query, NodeIndex node,
                                   Crossing<BoardNumber>* first) {
  return cross_primitive<k_convex_hit_limit, Projection::parallel>(frame, query, node, first);
}

std::int32_t parallel_cross_spans(const Frame<BoardNumber>& frame,
                                  const RayQuery<BoardNumber>& query, NodeIndex node,
                                  Crossing<BoardNumber>* first) {
  return cross_primitive<k_primitive_hit_limit, Projection::parallel>(frame, query, node, first);
}

FacePoint<BoardNumber> parallel_face_point(const Frame<BoardNumber>& frame,
                                           const RayQuery<BoardNumber>& query,
                                           const Crossing<BoardNumber>& crossing) {
  return settled_point<Projection::parallel>(frame, query, crossing);
}

void parallel_synthesize_unit(const BoardTask<BoardNumber>& task, const Rectangle& unit,
                              Line& line) {
  for (std::int16_t row = unit.first_row; row < unit.end_row; ++row) {
    if (line.count != 0 && line.row != row) {
      flush(task.order, line);
    }
    for (std::int16_t column = unit.first_column; column < unit.end_column; ++column) {
      put(task.order, line, column, row,
          synthesize<Projection::parallel>(task.frame, task.area, column, row));
    }
  }
}

}  // namespace maquette::firmware
