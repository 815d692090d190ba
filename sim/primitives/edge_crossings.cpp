#include "sim/primitives/edge_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace maquette::sim {
namespace {

/// Bisections of either edge: down to 2^-34.
constexpr int k_bisections = 34;

/// Pairs of parts that may still meet; where edges cross there are a few at each crossing, where
/// they lie on one another ever more.
constexpr std::size_t k_pair_limit = 256;

/// Crossings nearer to one another in either parameter are one.
constexpr double k_same = 1e-6;

struct PartPair {
  Edge a;
  Edge b;
  double u;
  double v;
};

bool may_meet(const Edge& a, const Edge& b) {
  for (int axis = 0; axis < 2; ++axis) {
    const auto less = [axis](const glm::dvec2& p, const glm::dvec2& q) {
      return p[axis] < q[axis];
    };
    const auto of_a = std::minmax_element(a.points.begin(), a.points.end(), less);
    const auto of_b = std::minmax_element(b.points.begin(), b.points.end(), less);
    if ((*of_a.second)[axis] < (*of_b.first)[axis] || (*of_b.second)[axis] < (*of_a.first)[axis]) {
      return false;
    }
  }
  return true;
}

std::vector<PartPair> bisected(const std::vector<PartPair>& pairs, double half) {
  std::vector<PartPair> result;
  for (const PartPair& pair : pairs) {
    const auto [a_low, a_high] = cut_at(pair.a, 0.5);
    const auto [b_low, b_high] = cut_at(pair.b, 0.5);
    const PartPair quarters[] = {{a_low, b_low, pair.u, pair.v},
                                 {a_low, b_high, pair.u, pair.v + half},
                                 {a_high, b_low, pair.u + half, pair.v},
                                 {a_high, b_high, pair.u + half, pair.v + half}};
    std::copy_if(std::begin(quarters), std::end(quarters), std::back_inserter(result),
                 [](const PartPair& quarter) { return may_meet(quarter.a, quarter.b); });
  }
  return result;
}

}  // namespace

Edge straight_edge(const glm::dvec2& first, const glm::dvec2& last) {
  return {{first, glm::mix(first, last, 1.0 / 3), glm::mix(first, last, 2.0 / 3), last}, true};
}

glm::dvec2 point_at(const Edge& edge, double u) { return cut_at(edge, u).first.points[3]; }

std::pair<Edge, Edge> cut_at(const Edge& edge, double u) {
  const auto& p = edge.points;
  if (edge.straight) {
    const glm::dvec2 middle = glm::mix(p[0], p[3], u);
    return {straight_edge(p[0], middle), straight_edge(middle, p[3])};
  }
  const glm::dvec2 first = glm::mix(p[0], p[1], u);
  const glm::dvec2 middle = glm::mix(p[1], p[2], u);
  const glm::dvec2 last = glm::mix(p[2], p[3], u);
  const glm::dvec2 low = glm::mix(first, middle, u);
  const glm::dvec2 high = glm::mix(middle, last, u);
  const glm::dvec2 joint = glm::mix(low, high, u);
  return {{{p[0], first, low, joint}, false}, {{joint, high, last, p[3]}, false}};
}

std::vector<std::pair<double, double>> crossings(const Edge& a, const Edge& b) {
  std::vector<PartPair> pairs;
  if (may_meet(a, b)) {
    pairs.push_back({a, b, 0, 0});
  }
  double width = 1;
  for (int i = 0; i < k_bisections && !pairs.empty(); ++i) {
    width /= 2;
    pairs = bisected(pairs, width);
    if (pairs.size() > k_pair_limit) {
      return {};
    }
  }
  std::vector<std::pair<double, double>> found;
  for (const PartPair& pair : pairs) {
    const double u = pair.u + width / 2;
    const double v = pair.v + width / 2;
    const bool is_known = std::any_of(found.begin(), found.end(), [u, v](const auto& other) {
      return std::abs(other.first - u) < k_same && std::abs(other.second - v) < k_same;
    });
    if (!is_known) {
      found.emplace_back(u, v);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace maquette::sim
