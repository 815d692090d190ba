#include "sim/database/surface_union_report.hpp"

#include <fmt/format.h>

#include <string_view>

#include "firmware/primitives/primitive_table.hpp"
#include "sim/primitives/primitive_table.hpp"

namespace maquette::sim {

namespace {

namespace revolution = firmware::revolution;

using Generatrix = revolution::Generatrix<float>;

/// A node of the tree, which covers sections from `first` on.
struct UnionNode {
  int number;
  std::string parent;
  int first;
  int sections;
};

std::string rows_of(const Generatrix& curve, const UnionNode& node) {
  const revolution::RingExtent<float> extent = curve.extent(node.number);
  const int half = node.sections / 2;
  const bool is_leaf = node.sections == 1;
  const int second = node.number + 2 * half;
  const std::string sons = is_leaf ? "-" : fmt::format("{}, {}", node.number + 1, second);
  const std::string sections =
      is_leaf ? std::to_string(node.first)
              : fmt::format("{} to {}", node.first, node.first + node.sections - 1);
  std::string text = fmt::format(
      "  {:>5}  {:>6}  {:>9}  {:<12}  {:>8.4f} to {:>8.4f}  {:>8.4f} to {:>8.4f}\n", node.number,
      node.parent, sons, sections, extent.low_r, extent.high_r, extent.low_z, extent.high_z);
  if (!is_leaf) {
    const std::string own = std::to_string(node.number);
    text += rows_of(curve, {node.number + 1, own, node.first, half});
    text += rows_of(curve, {second, own, node.first + half, node.sections - half});
  }
  return text;
}

std::string tree_of(firmware::NodeIndex leaf, std::string_view primitive, const Generatrix& curve) {
  const int nodes = 2 * curve.sections - 1;
  std::string text = fmt::format(
      "\nSurface union of primitive {}, a {}: {} sections, {} nodes of {} bytes\n"
      "  {:>5}  {:>6}  {:>9}  {:<12}  {:>20}  {:>20}\n",
      leaf, primitive, curve.sections, nodes, revolution::k_extent_reals * 4, "node", "parent",
      "sons", "sections", "r", "z");
  return text + rows_of(curve, {0, "-", 0, curve.sections});
}

}  // namespace

std::string surface_union_report(const PackedScene<float>& scene) {
  std::string text;
  for (std::size_t i = 0; i < scene.leaves.size(); ++i) {
    const firmware::Leaf<float>& leaf = scene.leaves[i];
    if (leaf.kind == firmware::kind_of<revolution::Kind> ||
        leaf.kind == firmware::kind_of<firmware::shell::Kind>) {
      text += tree_of(static_cast<firmware::NodeIndex>(i), description_of(leaf.kind).name,
                      revolution::generatrix(scene.parameters.data() + leaf.first_parameter));
    }
  }
  return text;
}

}  // namespace maquette::sim
