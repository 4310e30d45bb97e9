#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "simulation/convex_pair.h"
#include "simulation/solids.h"

namespace boomwatch {

/// What a pixel of the yard shows. From Person on it moves.
enum class YardKind : std::uint8_t {
  Nothing,  ///< the sky
  Ground,
  Tree,
  Stack,
  Wall,
  Person,
  Branch,  ///< sways
  Crane,
  Tool,  ///< the grapple and what it hangs on
  Load,
  Bird,
  Leaf,  ///< falls
};
/// Stable name for files.
std::string_view toString(YardKind kind);
constexpr bool moves(YardKind kind) { return kind >= YardKind::Person; }

/// How a surface is painted; see paintOf in material.h.
enum class Material : std::uint8_t {
  Soil,
  Bark,
  Log,  ///< bark around it, the cut wood at its ends
  Concrete,
  Foliage,
  DryBranch,
  Paint,  ///< the crane's
  DarkSteel,
  Grapple,
  Chrome,
  Vest,
  Trousers,
  Skin,
  Helmet,
  Feather,
  FallenLeaf,
};

/// A convex body of the yard. Metres; in whichever frame it is said to be.
struct Part {
  enum class Shape : std::uint8_t {
    Cylinder,   ///< around the box's y
    Box,        ///< all of it
    Ellipsoid,  ///< touches its sides
  };
  Shape shape = Shape::Box;
  OrientedBox box;  ///< which the body just fits
  Material material = Material::Soil;
  YardKind kind = YardKind::Nothing;
  std::uint8_t variety = 0;  ///< tells apart things of one material
};
using Parts = std::vector<Part>;

/// A turned frame's rotation with `y` as its second axis (which need not have length 1, and is not
/// zero), and `near` as close to its third as that allows.
Eigen::Matrix3d rotationWithY(const Eigen::Vector3d& y,
                              const Eigen::Vector3d& near = Eigen::Vector3d::UnitZ());

/// A cylinder from `a` to `b`, which differ.
Part rod(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius);
/// A box from `a` to `b`, `width` across and `depth` along `near`; see rotationWithY.
Part beam(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double width, double depth,
          const Eigen::Vector3d& near = Eigen::Vector3d::UnitZ());
Part ellipsoid(const Eigen::Vector3d& centre, const Eigen::Vector3d& size,
               const Eigen::Matrix3d& rotation = Eigen::Matrix3d::Identity());
Part withLook(Part part, YardKind kind, Material material, int variety = 0);

/// The same body in a frame whose axes are `rotation`'s rows in the old one.
Part turned(Part part, const Eigen::Matrix3d& rotation);

/// The cylinder that such a part is.
Cylinder cylinderOf(const Part& part);

/// Where a ray first enters the body; absent where it misses or begins inside.
std::optional<Hit> cast(const Part& part, const Eigen::Vector3d& origin,
                        const Eigen::Vector3d& direction);

Support supportOf(const Part& part);

}  // namespace boomwatch
