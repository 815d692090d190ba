#include "sim/database/object_tree.hpp"

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "firmware/primitives/primitive_table.hpp"
#include "sim/scene/placement.hpp"

namespace maquette::sim {

namespace {

using firmware::BooleanOperator;
using firmware::NodeIndex;

/// A node under construction. Numbers of composites are known only when all leaves are.
struct Node {
  bool is_leaf = true;
  std::size_t index = 0;  ///< among the leaves or among the composites
  int height = 0;
  bool bounded = true;
  Vector3 center{0, 0, 0};  ///< of the box around it, roughly: only orders the children of unions
};

struct CompositeDraft {
  Node children[2];
  BooleanOperator combination;
};

class TreeBuilder {
 public:
  explicit TreeBuilder(const Scene& scene) {
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
      surfaces_.emplace(scene.surfaces[i].name, i);
    }
    const Node root = node_of(scene.object, Placement(1.0), {scene.object.surface, Placement(1.0)});
    number_nodes(root);
  }

  ObjectTree take() { return std::move(tree_); }

 private:
  /// A surface by its name, and the frame of the object that names it.
  struct NamedSurface {
    const std::string& name;
    Placement frame;
  };

  Node node_of(const Object& object, const Placement& above, const NamedSurface& inherited) {
    const Placement placement = concatenated(above, object.placement);
    const NamedSurface surface =
        object.surface.empty() ? inherited : NamedSurface{object.surface, placement};
    if (object.primitive) {
      return leaf_of(*object.primitive, placement, surface);
    }
    std::vector<Node> children;
    children.reserve(object.children.size());
    for (const Object& child : object.children) {
      children.push_back(node_of(child, placement, surface));
    }
    switch (object.combination) {
      case BooleanOperator::union_of:
        return united(children.begin(), children.end());
      case BooleanOperator::difference:
        return children.size() == 1 ? children.front()
                                    : composite_of(BooleanOperator::difference, children.front(),
                                                   united(children.begin() + 1, children.end()));
      case BooleanOperator::intersection:
        break;
    }
    Node result = children.front();
    for (std::size_t i = 1; i < children.size(); ++i) {
      result = composite_of(BooleanOperator::intersection, result, children[i]);
    }
    return result;
  }

  Node leaf_of(const Primitive& primitive, const Placement& placement,
               const NamedSurface& surface) {
    const LocalFrame frame = frame_of(primitive);
    TreeLeaf leaf;
    leaf.kind = frame.kind;
    leaf.surface = surfaces_.at(surface.name);
    leaf.parameters = frame.parameters;
    leaf.given = frame.given;
    leaf.to_scene = concatenated(placement, frame.to_object);
    leaf.own_frame = placement;
    leaf.surface_frame = surface.frame;
    tree_.leaves.push_back(leaf);
    Node node;
    node.index = tree_.leaves.size() - 1;
    firmware::Box<double> box{};
    node.bounded = firmware::primitive_of<double>(leaf.kind).bounds(leaf.parameters.data(), box);
    node.center = leaf.to_scene[3];
    return node;
  }

  Node composite_of(BooleanOperator combination, const Node& a, const Node& b) {
    composites_.push_back({{a, b}, combination});
    Node node;
    node.is_leaf = false;
    node.index = composites_.size() - 1;
    node.height = 1 + std::max(a.height, b.height);
    switch (combination) {
      case BooleanOperator::union_of:
        node.bounded = a.bounded && b.bounded;
        node.center = (a.center + b.center) / 2.0;
        break;
      case BooleanOperator::intersection:
        node.bounded = a.bounded || b.bounded;
        node.center = a.bounded ? a.center : b.center;
        break;
      case BooleanOperator::difference:
        node.bounded = a.bounded;
        node.center = a.center;
        break;
    }
    return node;
  }

  using Iterator = std::vector<Node>::iterator;

  /// Unbounded children come first, on their own: they have no place to be sorted by.
  Node united(Iterator first, Iterator last) {
    const auto bounded =
        std::stable_partition(first, last, [](const Node& node) { return !node.bounded; });
    if (bounded == first || bounded == last) {
      return halved(first, last);
    }
    return composite_of(BooleanOperator::union_of, halved(first, bounded), halved(bounded, last));
  }

  /// Halves along the axis on which the centres spread most.
  Node halved(Iterator first, Iterator last) {
    if (last - first == 1) {
      return *first;
    }
    const int axis = widest_axis(first, last);
    std::stable_sort(first, last, [axis](const Node& a, const Node& b) {
      return a.center[axis] < b.center[axis];
    });
    const auto middle = first + (last - first) / 2;
    const Node lower = halved(first, middle);
    return composite_of(BooleanOperator::union_of, lower, halved(middle, last));
  }

  static int widest_axis(Iterator first, Iterator last) {
    Vector3 low(std::numeric_limits<double>::max());
    Vector3 high(-std::numeric_limits<double>::max());
    for (auto node = first; node != last; ++node) {
      low = glm::min(low, node->center);
      high = glm::max(high, node->center);
    }
    const Vector3 spread = high - low;
    if (spread.x >= spread.y && spread.x >= spread.z) {
      return 0;
    }
    return spread.y >= spread.z ? 1 : 2;
  }

  [[nodiscard]] NodeIndex number_of(const Node& node) const {
    return static_cast<NodeIndex>(node.is_leaf ? node.index : tree_.leaves.size() + node.index);
  }

  /// Leaves in the order of the tree: what lies together in space lies together in memory.
  void order_leaves(const Node& node, std::vector<TreeLeaf>& ordered) {
    if (!node.is_leaf) {
      for (Node& child : composites_[node.index].children) {
        order_leaves(child, ordered);
        if (child.is_leaf) {
          child.index = ordered.size() - 1;
        }
      }
    } else {
      ordered.push_back(std::move(tree_.leaves[node.index]));
    }
  }

  void number_nodes(const Node& root) {
    std::vector<TreeLeaf> ordered;
    ordered.reserve(tree_.leaves.size());
    order_leaves(root, ordered);
    tree_.leaves = std::move(ordered);
    tree_.root = number_of(root);
    tree_.height = root.height;
    for (const CompositeDraft& draft : composites_) {
      tree_.composites.push_back({firmware::k_no_node,
                                  {number_of(draft.children[0]), number_of(draft.children[1])},
                                  draft.combination});
    }
    for (std::size_t i = 0; i < tree_.composites.size(); ++i) {
      const auto parent = static_cast<NodeIndex>(tree_.leaves.size() + i);
      for (const NodeIndex child : tree_.composites[i].children) {
        if (child < tree_.leaves.size()) {
          tree_.leaves[child].parent = parent;
        } else {
          tree_.composites[child - tree_.leaves.size()].parent = parent;
        }
      }
    }
  }

  ObjectTree tree_;
  std::vector<CompositeDraft> composites_;
  std::unordered_map<std::string, std::size_t> surfaces_;
};

}  // namespace

ObjectTree object_tree_of(const Scene& scene) { return TreeBuilder(scene).take(); }

}  // namespace maquette::sim
