#include "sim/database/board_stack.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>

#include "sim/primitives/primitive_table.hpp"

namespace maquette::sim {

namespace {

constexpr std::int64_t k_return_address_bytes = 4;
/// Routines in assembler call each other no deeper than once and keep two registers.
constexpr std::int64_t k_routine_bytes = 16;

/// Each goes down a level of the object tree when it calls itself, and stays there when it calls
/// another of them.
constexpr CodeName k_tree_walkers[] = {"cross", "cross_nearest", "pass_node"};

bool is_tree_walker(std::string_view function) {
  return std::any_of(std::begin(k_tree_walkers), std::end(k_tree_walkers),
                     [function](const CodeName& walker) { return walker.name == function; });
}

/// How often a function that calls itself may stand on the stack; 0 when nothing is known of it.
int recursion_depth(std::string_view function) {
  int depth = 0;
  for (const PrimitiveDescription* primitive : primitive_table()) {
    for (const Recursion& recursion : primitive->recursions) {
      depth = recursion.function.name == function ? std::max(depth, recursion.depth) : depth;
    }
  }
  return depth;
}

std::int64_t frame_bytes(const firmware::CodePiece& piece) {
  return k_return_address_bytes + piece.stack_bytes;
}

/// The deepest chain of calls from each piece on; of the walkers of the tree on one level.
class CallDepth {
 public:
  explicit CallDepth(const BoardPieces& pieces) : pieces_(pieces) {}

  std::int64_t from(std::uint32_t number) {
    const auto [known, is_new] = depths_.emplace(number, k_in_question);
    if (!is_new) {
      return settled(number, known->second);
    }
    const firmware::CodePiece& piece = pieces_.code->pieces[number];
    std::int64_t below = k_routine_bytes;
    bool calls_itself = false;
    for (std::uint32_t i = 0; i < piece.addresses; ++i) {
      const firmware::CodeAddress& address = pieces_.code->addresses[piece.first_address + i];
      calls_itself = calls_itself || address.piece == number;
      if (address.piece != number && is_linked(address)) {
        below = std::max(below, from(pieces_.target(address.piece)));
      }
    }
    return depths_[number] = below + (calls_itself ? times(piece) : 1) * frame_bytes(piece);
  }

 private:
  static constexpr std::int64_t k_in_question = -1;

  [[nodiscard]] bool is_linked(const firmware::CodeAddress& address) const {
    return address.piece != firmware::k_package &&
           pieces_.bytes[pieces_.target(address.piece)] != 0;
  }

  [[nodiscard]] std::int64_t settled(std::uint32_t number, std::int64_t depth) const {
    if (depth == k_in_question) {
      throw std::logic_error("functions of the board's program call each other in a circle: " +
                             std::string(pieces_.code->pieces[number].name));
    }
    return depth;
  }

  static std::int64_t times(const firmware::CodePiece& piece) {
    const int depth = is_tree_walker(piece.name) ? 1 : recursion_depth(piece.name);
    if (depth == 0) {
      throw std::logic_error("nobody says how deep this function calls itself: " +
                             std::string(piece.name));
    }
    return depth;
  }

  const BoardPieces& pieces_;
  std::map<std::uint32_t, std::int64_t> depths_;
};

}  // namespace

std::int64_t board_stack_bytes(const BoardPieces& pieces, int tree_height) {
  CallDepth depth(pieces);
  std::int64_t deepest = 0;
  std::int64_t level = 0;
  for (std::uint32_t number = 0; number < pieces.bytes.size(); ++number) {
    const firmware::CodePiece& piece = pieces.code->pieces[number];
    if (pieces.bytes[number] != 0) {
      deepest = std::max(deepest, depth.from(number));
      level = is_tree_walker(piece.name) ? std::max(level, frame_bytes(piece)) : level;
    }
  }
  return deepest + tree_height * level;
}

}  // namespace maquette::sim
