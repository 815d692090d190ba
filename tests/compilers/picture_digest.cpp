#include <cstdint>
#include <cstdio>

#include "firmware/arithmetic/counted.hpp"
#include "tests/firmware/facet_surface.hpp"
#include "tests/firmware/random_model.hpp"

// Renders random scenes with everything in them and prints a digest of their pixels and of the work
// counted. Built by several compilers and options, whose outputs must be equal.

namespace {

using namespace maquette::firmware;
using namespace maquette::firmware::trial;

/// FNV-1a over 32-bit words.
class Digest {
 public:
  void add(std::uint32_t word) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
      value_ = (value_ ^ ((word >> shift) & 0xFFU)) * 0x100000001B3U;
    }
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xCBF29CE484222325U;
};

/// Surfaces of every kind, all facet distributions among them.
Model furnished_model() {
  Model model;
  model.add(glass_surface(1.5, {0.3, 0.1, 0.5}));
  model.add(mirror_surface());
  for (const FacetKind facets : facet_kinds()) {
    Surface<double> glossy = facet_surface(facets, 0.2);
    glossy.diffuse = {0.7, 0.4, 0.2};
    glossy.specular = 0.4;
    model.add(glossy);
  }
  model.lights = {{{4, 5, -3}, {2, 2, 1.5}}, {{-5, 2, 1}, {0.7, 0.8, 1}}};
  model.ambient = {0.1, 0.12, 0.15};
  model.background = {0.1, 0.2, 0.4};
  return model;
}

void render(Random& random, Digest& digest) {
  const RandomTree tree = random_tree(random, furnished_model(), 9, {0, 0, 5}, 2.5);
  reset_counted_work();
  BuiltFrame<Counted> built(tree.model, tree.root);
  for (std::int16_t row = 0; row < tree.model.rows; ++row) {
    for (std::int16_t column = 0; column < tree.model.columns; ++column) {
      digest.add(built.pixel(column, row).rgb);
    }
  }
  const Work work = counted_work();
  for (const std::uint32_t count : work.counts) {
    digest.add(count);
  }
}

}  // namespace

int main() {
  constexpr int k_scenes = 30;
  constexpr unsigned k_seed = 1984;
  Random random(k_seed);
  Digest digest;
  for (int scene = 0; scene < k_scenes; ++scene) {
    render(random, digest);
    std::printf("%016llx\n", static_cast<unsigned long long>(digest.value()));
  }
  return 0;
}
