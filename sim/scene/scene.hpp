#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "firmware/facets/facet_table.hpp"
#include "firmware/projection.hpp"
#include "firmware/textures/texture_table.hpp"
#include "models/bus/instant.hpp"
#include "sim/primitives/primitive.hpp"
#include "sim/yaml/source_position.hpp"
#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

using Color = glm::dvec3;  ///< red, green, blue; linear

/// The screen as a rectangle, in scene units: in front of the eye, or placed like an object, as a
/// window that may be off the centre of the view and oblique to it.
struct Screen {
  double distance = 1;  ///< from the eye, unless it is placed
  double width = 1;
  double height = 1;
  /// Of a rectangle around the origin with x to the right and y up, seen from z above 0.
  std::optional<Placement> placement;
};

/// The observer (paper, section II.1): exactly one of the fields of view and screen is given, of a
/// parallel view height or screen. A screen that is placed takes the place of target and up.
struct View {
  Vector3 eye{0, 0, 0};
  Vector3 target{0, 0, -1};
  Vector3 up{0, 0, 1};
  std::optional<double> field_of_view_deg;  ///< vertical; pixels are square
  std::optional<double> horizontal_field_of_view_deg;
  std::optional<Screen> screen;
  std::optional<firmware::Projection> projection;  ///< perspective when it is not said
  std::optional<double> height;                    ///< of what a parallel view shows
};

/// A light that shines in a cone only.
struct Spot {
  Vector3 target{0, 0, 0};  ///< a point on the cone's axis
  double angle_deg = 30;    ///< from the axis, within which it shines whole
  double edge_deg = 5;      ///< over which it falls to nothing beyond that
};

/// A distant point source: a facing surface receives `intensity` whatever its distance (the paper's
/// approximation of remote sources, section III.1), unless it says how its light falls off.
struct Light {
  std::string name;
  Vector3 position{0, 0, 0};
  Color intensity{1, 1, 1};
  std::optional<double> falloff;  ///< distance at which it has its intensity, in scene units
  std::optional<Spot> spot;
  std::optional<Placement> placement;  ///< of the position and of a spot's target
};

/// The texels of a picture, rows from the top, three bytes red, green, blue each.
struct TexturePicture {
  int columns = 0;
  int rows = 0;
  std::vector<std::uint8_t> texels;
};

/// In which frame the pattern of a texture lies: that of each primitive, or that of the object that
/// names the surface.
enum class TextureFrame { primitive, object };

/// What the diffuse share of a surface shows instead of one colour: a pattern of the surface's and
/// a second one, or a picture, which the surface's tints. Exactly one of them is given.
struct Texture {
  std::optional<firmware::TextureKind> pattern;
  Color color{0, 0, 0};  ///< the second of a pattern
  double size = 1;       ///< of a pattern's cell, in units of its frame
  TextureFrame frame = TextureFrame::object;
  std::optional<Placement> placement;  ///< of the pattern in its frame
  std::optional<TexturePicture> picture;
  int repeat_u = 1;  ///< of the picture, over the whole range of a surface's parameters
  int repeat_v = 1;
};

/// A named surface and, for transparent bodies, the matter behind it (paper, section III).
struct Surface {
  std::string name;
  Color diffuse{1, 1, 1};      ///< reflectance of the diffuse share, 0..1
  double specular = 0;         ///< share s of specular reflection; d = 1 - s
  bool metal = false;          ///< Fresnel factor from index and extinction per colour
  Color index{1.5, 1.5, 1.5};  ///< dielectrics have the same for the three colours
  Color extinction{0, 0, 0};
  firmware::FacetKind facets = firmware::facet_kind_of<firmware::cosine_power::Kind>;
  double half_angle_deg = 10;  ///< Blinn's beta: where the facet distribution falls to one half
  bool transparent = false;
  Color absorption{0, 0, 0};     ///< per scene unit of length
  std::optional<Color> ambient;  ///< uniform light besides that of the scene
  std::optional<Texture> texture;
  SourcePosition position_in_file;
};

/// A node of the object tree: a primitive or an operator with its operands.
struct Object {
  std::string name;                    ///< may be empty
  Placement placement{1.0};            ///< to the frame of the parent
  std::string surface;                 ///< name; empty: the parent's
  std::optional<Primitive> primitive;  ///< of a leaf
  firmware::BooleanOperator combination = firmware::BooleanOperator::union_of;  ///< of the children
  std::vector<Object> children;  ///< of an operator; two or more
  SourcePosition position_in_file;
};

/// Where the binary tree of rays ends (paper, figure 3).
struct RayTree {
  int depth = 4;  ///< secondary rays in a row; 0: primary rays only
  double minimum_weight = 1.0 / 256;
};

/// How near numerical solutions come to the exact ones.
struct Roots {
  double tolerance = 1;  ///< of those that give a ray's hits, in ulps
};

/// The time that the paper states for a picture, beside which a run shows its own.
struct PaperTime {
  models::Duration value{};
  std::string source;  ///< where the paper states it
};

/// Rays of a pixel: a regular grid. With a contrast, all of them only where those in its corners
/// differ by more.
struct Samples {
  int per_side = 1;
  double contrast = 0;
};

/// A parameter whose value differs from frame to frame.
struct SequenceTrack {
  std::string path;              ///< as in an override
  std::vector<YamlNode> values;  ///< one for each frame
};

/// Frames that follow one another.
struct Sequence {
  int frames = 1;
  std::vector<SequenceTrack> tracks;
};

/// The kinds of extents that rays are compared with.
enum class Extents { all, none, rectangles, boxes, spheres };

/// A checked scene: every name resolves, every value is in its range.
struct Scene {
  std::string name;
  std::optional<PaperTime> paper_time;
  View view;
  std::vector<Light> lights;
  Color ambient{0, 0, 0};
  Color background{0, 0, 0};
  std::vector<Surface> surfaces;
  RayTree ray_tree;
  Roots roots;
  std::optional<Samples> samples;
  std::optional<Sequence> sequence;
  std::optional<Extents> extents;  ///< all when it is not said
  bool shadows = true;
  Object object;
};

}  // namespace maquette::sim
