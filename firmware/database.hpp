#pragma once

#include <cstdint>

#include "firmware/arithmetic/extent_use.hpp"
#include "firmware/boolean_operator.hpp"
#include "firmware/vector.hpp"

/// The scene as a board's RAM holds it (paper, section V.2.3.1.1): flat arrays, loaded by the host.
/// The host program lays them out in its own way; how a board does, layout.hpp tells.
namespace maquette::firmware {

/// Leaves are numbered 0 .. leaf_count-1, composites follow; children have smaller numbers than
/// their parent.
using NodeIndex = std::uint32_t;
using SurfaceIndex = std::uint16_t;

inline constexpr NodeIndex k_no_node = 0xFFFFFFFF;
/// The medium outside of every body.
inline constexpr SurfaceIndex k_void = 0xFFFF;

/// Which primitive a leaf is: its place in the table of primitives
/// (primitives/primitive_table.hpp).
enum class PrimitiveKind : std::uint8_t {};
/// So many are told apart.
inline constexpr int k_primitive_kind_limit = 32;

/// A primitive: where it hangs, what it is, its frame and its surface.
template <class Real>
struct Leaf {
  NodeIndex parent;
  PrimitiveKind kind;
  SurfaceIndex surface;
  std::uint32_t first_parameter;  ///< into Database::parameters
  Affine<Real> to_scene;          ///< local frame to scene frame
  Affine<Real> from_scene;
};

struct Composite {
  NodeIndex parent;
  NodeIndex children[2];
  BooleanOperator combination;
};

/// How the normals of a surface's facets scatter: the place of a distribution in their table
/// (facets/facet_table.hpp).
enum class FacetKind : std::uint8_t {};
inline constexpr int k_facet_kind_limit = 7;

/// Optical properties (paper, section III).
template <class Real>
struct Surface {
  Color<Real> diffuse;  ///< reflectance of the diffuse share
  Real specular;        ///< the share s; d = 1 - s
  bool metal;
  bool transparent;
  bool absorbing;
  FacetKind facets;
  Color<Real> index;       ///< dielectrics: the same for the three colours
  Color<Real> extinction;  ///< metals
  Real facet_parameter;    ///< of the distribution
  Real facet_scale;        ///< makes the integral of D cos over the hemisphere pi/4
  Color<Real> absorption;  ///< per scene unit
};

template <class Real>
struct Light {
  Vector<Real> position;  ///< scene frame
  Color<Real> intensity;
};

/// How the light of a source that is not alike everywhere depends on the place it falls on.
template <class Real>
struct LightShape {
  Real reference_squared;  ///< of the distance at which it has its intensity; 0: at every distance
  Vector<Real> axis;       ///< of a spot, unit vector in the scene frame
  Real edge_cosine;        ///< of the angle to the axis at which a spot ends
  Real per_cosine;         ///< how fast it grows from there, until it is whole; 0: no spot
};

/// What the pattern of a texture is: its place in their table (textures/texture_table.hpp).
enum class TextureKind : std::uint8_t {};
inline constexpr int k_texture_kind_limit = 4;

/// The texture of a leaf (paper, section V.2.3.1.1: the identification of a surface), by which the
/// reflectance of its diffuse share is multiplied.
template <class Real>
struct Texture {
  Affine<Real> from_leaf;  ///< local frame to the pattern's, in which a cell is one unit wide
  Color<Real> colors[2];   ///< of a pattern's cells; the first also tints a picture
  Real columns_per_turn;   ///< of a picture: texels over the whole range of u, repeated ones too
  Real rows_per_turn;      ///< and of v
  std::uint32_t first_texel;
  std::uint16_t columns;
  std::uint16_t rows;
  TextureKind kind;
};

inline constexpr std::uint16_t k_no_texture = 0xFFFF;

/// Bytes of a texel: red, green, blue.
inline constexpr std::uint32_t k_texel_bytes = 3;

/// Rays of a pixel: a regular grid of so many a side. With a contrast, all of them only where two
/// in its corners differ by more.
template <class Real>
struct Samples {
  std::int32_t per_side;
  Real contrast;  ///< 0: always all
};

/// The observer's frame and the screen one unit in front of the eye, or, of a parallel view, in the
/// plane of the eye. Screen frame: x to the right, y up, z into the scene, the eye at the origin,
/// lengths as in the scene.
template <class Real>
struct Observer {
  Affine<Real> to_screen;  ///< scene frame to screen frame
  Affine<Real> from_screen;
  Real left;  ///< x of the centre of column 0
  Real top;   ///< y of the centre of row 0
  Real step;  ///< between pixel centres, both ways
  std::int32_t columns;
  std::int32_t rows;
};

/// What of the firmware a scene needs; the rest is neither run nor packed nor charged.
struct Needs {
  bool primitives[k_primitive_kind_limit];  ///< by PrimitiveKind
  bool several_spans;  ///< a primitive in which a ray may have more than one span
  bool unions;
  bool large_unions;  ///< a union of so many that testing boxes is worth its while
  bool intersections;
  bool differences;
  bool diffuse;   ///< a surface with d > 0
  bool specular;  ///< a surface with s > 0: facets, Fresnel, reflected rays
  bool dielectrics;
  bool metals;
  bool facets[k_facet_kind_limit];  ///< by FacetKind
  bool parallel_view;               ///< in place of perspective
  bool transparency;                ///< refracted rays
  bool absorption;
  bool lights;
  bool shadows;
  bool ambient;
  bool reflections;                     ///< specular surfaces and a ray tree deeper than 0
  bool depth;                           ///< the display takes a depth with each pixel
  bool surface_ambient;                 ///< surfaces with an ambient light of their own
  bool shaped_lights;                   ///< lights that are not alike everywhere
  bool textures[k_texture_kind_limit];  ///< by TextureKind
  bool textured;                        ///< any of them
  bool samples;                         ///< more than one ray a pixel
};

template <class Real>
struct Database : ExtentUse<Real> {
  const Leaf<Real>* leaves;
  const Composite* composites;
  const Real* parameters;
  const Surface<Real>* surfaces;
  const Light<Real>* lights;
  const Color<Real>* surface_ambients;   ///< one for each surface, or none
  const LightShape<Real>* light_shapes;  ///< one for each light, or none
  const std::uint16_t* leaf_textures;    ///< one for each leaf, or none
  const Texture<Real>* textures;
  const std::uint8_t* texels;
  NodeIndex leaf_count;
  NodeIndex composite_count;
  std::uint32_t parameter_count;
  SurfaceIndex surface_count;
  std::uint16_t light_count;
  std::uint16_t texture_count;
  std::uint32_t texel_count;
  NodeIndex root;
  Observer<Real> observer;
  Color<Real> ambient;
  Color<Real> background;
  std::int32_t ray_depth;  ///< secondary rays in a row
  Real minimum_weight;     ///< rays that count less are not cast
  Samples<Real> samples;
  Needs needs;

  [[nodiscard]] bool is_leaf(NodeIndex node) const { return node < leaf_count; }
  [[nodiscard]] NodeIndex node_count() const { return leaf_count + composite_count; }
  [[nodiscard]] const Composite& composite(NodeIndex node) const {
    return composites[node - leaf_count];
  }
};

}  // namespace maquette::firmware
