#include "sim/database/database_image.hpp"

#include <cstring>

#include "firmware/facets/facet_table.hpp"
#include "firmware/primitives/primitive_table.hpp"

namespace maquette::sim {

namespace {

class ImageWriter {
 public:
  void word(std::uint32_t value) {
    bytes_.push_back(static_cast<unsigned char>(value >> 8U));
    bytes_.push_back(static_cast<unsigned char>(value));
  }

  void real(float value) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    word(bits >> 16U);
    word(bits);
  }

  void vector(const firmware::Vector<float>& v) {
    real(v.x);
    real(v.y);
    real(v.z);
  }

  void affine(const firmware::Affine<float>& frame) {
    for (int column = 0; column < 4; ++column) {
      vector(frame[column]);
    }
  }

  std::vector<unsigned char> take() { return std::move(bytes_); }

 private:
  std::vector<unsigned char> bytes_;
};

template <class Enumeration>
std::uint32_t number(Enumeration value) {
  return static_cast<std::uint32_t>(value);
}

/// The needs as bits, the highest of the first word first. Primitives come last, so that a further
/// one moves no bit.
void write_needs(ImageWriter& writer, const firmware::Needs& needs) {
  std::vector<bool> bits;
  for (const bool need : {needs.unions, needs.large_unions, needs.intersections, needs.differences,
                          needs.diffuse, needs.specular, needs.dielectrics, needs.metals}) {
    bits.push_back(need);
  }
  for (int kind = 0; kind < firmware::k_facet_kind_count; ++kind) {
    bits.push_back(needs.facets[kind]);
  }
  for (const bool need : {needs.transparency, needs.absorption, needs.lights, needs.shadows,
                          needs.ambient, needs.reflections, needs.depth}) {
    bits.push_back(need);
  }
  for (int kind = 0; kind < firmware::k_primitive_kind_count; ++kind) {
    bits.push_back(needs.primitives[kind]);
  }
  constexpr std::size_t k_word_bits = 16;
  for (std::size_t first = 0; first < bits.size(); first += k_word_bits) {
    std::uint32_t word = 0;
    for (std::size_t i = first; i < first + k_word_bits; ++i) {
      word = word << 1U | static_cast<std::uint32_t>(i < bits.size() && bits[i]);
    }
    writer.word(word);
  }
}

/// Counts and the root are long words, where a large scene may need them.
void write_header(ImageWriter& writer, const firmware::Database<float>& database) {
  for (const std::uint32_t count :
       {database.leaf_count, database.composite_count, database.parameter_count, database.root}) {
    writer.word(count >> 16U);
    writer.word(count);
  }
  writer.word(database.surface_count);
  writer.word(database.light_count);
  writer.word(static_cast<std::uint32_t>(database.ray_depth));
  write_needs(writer, database.needs);
  writer.vector(database.ambient);
  writer.vector(database.background);
  writer.real(database.minimum_weight);
}

void write_observer(ImageWriter& writer, const firmware::Observer<float>& observer) {
  writer.affine(observer.to_screen);
  writer.affine(observer.from_screen);
  writer.real(observer.left);
  writer.real(observer.top);
  writer.real(observer.step);
  writer.word(static_cast<std::uint32_t>(observer.columns));
  writer.word(static_cast<std::uint32_t>(observer.rows));
}

void write_leaf(ImageWriter& writer, const firmware::Leaf<float>& leaf) {
  writer.word(leaf.parent);
  writer.word(number(leaf.kind));
  writer.word(leaf.surface);
  writer.word(leaf.first_parameter);
  writer.affine(leaf.to_scene);
  writer.affine(leaf.from_scene);
}

void write_composite(ImageWriter& writer, const firmware::Composite& composite) {
  writer.word(composite.parent);
  writer.word(composite.children[0]);
  writer.word(composite.children[1]);
  writer.word(number(composite.combination));
}

void write_surface(ImageWriter& writer, const firmware::Surface<float>& surface,
                   const firmware::Needs& needs) {
  writer.word(number(surface.facets) << 3U | static_cast<std::uint32_t>(surface.metal) << 2U |
              static_cast<std::uint32_t>(surface.transparent) << 1U |
              static_cast<std::uint32_t>(surface.absorbing));
  writer.real(surface.specular);
  if (needs.diffuse) {
    writer.vector(surface.diffuse);
  }
  if (needs.specular) {
    writer.real(surface.facet_parameter);
    writer.real(surface.facet_scale);
  }
  if (needs.metals) {
    writer.vector(surface.index);
    writer.vector(surface.extinction);
  } else if (needs.dielectrics) {
    writer.real(surface.index.x);
  }
  if (needs.absorption) {
    writer.vector(surface.absorption);
  }
}

}  // namespace

std::vector<unsigned char> database_image(const firmware::Database<float>& database) {
  ImageWriter writer;
  write_header(writer, database);
  write_observer(writer, database.observer);
  for (firmware::NodeIndex i = 0; i < database.leaf_count; ++i) {
    write_leaf(writer, database.leaves[i]);
  }
  for (firmware::NodeIndex i = 0; i < database.composite_count; ++i) {
    write_composite(writer, database.composites[i]);
  }
  for (std::uint32_t i = 0; i < database.parameter_count; ++i) {
    writer.real(database.parameters[i]);
  }
  for (firmware::SurfaceIndex i = 0; i < database.surface_count; ++i) {
    write_surface(writer, database.surfaces[i], database.needs);
  }
  for (std::uint16_t i = 0; i < database.light_count; ++i) {
    writer.vector(database.lights[i].position);
    writer.vector(database.lights[i].intensity);
  }
  return writer.take();
}

}  // namespace maquette::sim
