#include "simulation/yard/surface_place.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/yard/texture.h"

namespace boomwatch {
namespace {

using Eigen::Vector3f;

/// Blue, green, red from the more usual order.
Vector3f rgb(float red, float green, float blue) { return {blue, green, red}; }

float step(float from, float to, float x) {
  return std::clamp((x - from) / (to - from), 0.0F, 1.0F);
}

Vector3f mix(const Vector3f& a, const Vector3f& b, float t) { return a + t * (b - a); }

float fraction(float x) { return x - std::floor(x); }

/// Its own piece of the noise for every part's variety.
Vector3f ownPlace(const Part& part, const Vector3f& at) {
  return at + Vector3f::Constant(1.37F * static_cast<float>(part.variety));
}

Vector3f bark(const Part& part, const SurfacePlace& place) {
  Vector3f at = ownPlace(part, place.at);
  at.y() *= 0.3F;  // furrows run along the trunk
  const float rough = roughness(at, 0.12F, 5, place.footprint);
  const float lichen = step(0.25F, 0.6F, noiseAt(ownPlace(part, place.at) / 0.45F));
  const Vector3f base = mix(rgb(104, 84, 66), rgb(132, 130, 110), lichen);
  return base * (1.0F + 0.75F * rough);
}

Vector3f cutWood(const Part& part, const SurfacePlace& place) {
  const float radius = std::hypot(place.at.x(), place.at.z());
  const float edge = static_cast<float>(part.box.size.x()) / 2 - radius;
  if (edge < 0.012F) return rgb(84, 62, 46);  // the bark around it
  const float fade = std::min(1.0F, 0.012F / std::max(place.footprint, 1e-4F));
  const float bent = 0.01F * noiseAt(ownPlace(part, place.at) / 0.06F);
  const float ring = std::sin((radius + bent) * 2.0F * std::numbers::pi_v<float> / 0.022F);
  const float rough = roughness(ownPlace(part, place.at), 0.1F, 5, place.footprint);
  const float heart = step(0.03F, 0.10F, radius);
  return mix(rgb(176, 128, 78), rgb(214, 176, 122), heart) *
         (1.0F + 0.10F * fade * ring + 0.30F * rough);
}

Vector3f log(const Part& part, const SurfacePlace& place) {
  if (std::abs(place.normal.y()) > 0.5F) return cutWood(part, place);
  Vector3f at = ownPlace(part, place.at);
  at.y() *= 0.35F;
  const float rough = roughness(at, 0.10F, 5, place.footprint);
  // Here and there the bark is gone.
  const float bare = step(0.30F, 0.45F, noiseAt(ownPlace(part, place.at) / 0.30F));
  return mix(rgb(112, 84, 62), rgb(186, 148, 104), bare) * (1.0F + (0.8F - 0.4F * bare) * rough);
}

Vector3f concrete(const SurfacePlace& place) {
  const float rough = roughness(place.at, 0.6F, 7, place.footprint);
  // Blocks of 80 x 40 cm, every other course shifted by half.
  const float course = place.at.y() / 0.4F;
  const float shift = std::fmod(std::abs(std::floor(course)), 2.0F) * 0.5F;
  const float along = (std::abs(place.normal.x()) > 0.5F ? place.at.z() : place.at.x()) / 0.8F;
  const float joint =
      std::min(0.4F * std::min(fraction(course), 1.0F - fraction(course)),
               0.8F * std::min(fraction(along + shift), 1 - fraction(along + shift)));
  const float wide = std::max(0.012F, place.footprint);
  const float mortar = 1.0F - step(0.5F * wide, 1.5F * wide, joint);
  const float moss = step(0.2F, 0.6F, noiseAt(place.at / 0.7F + Vector3f::Constant(3.1F)));
  const Vector3f face = mix(rgb(168, 164, 156), rgb(128, 136, 104), 0.7F * moss);
  return mix(face, rgb(96, 92, 86), 0.8F * mortar) * (1.0F + 0.42F * rough);
}

Vector3f foliage(const Part& part, const SurfacePlace& place) {
  const Vector3f at = ownPlace(part, place.at);
  const float rough = roughness(at, 0.25F, 5, place.footprint);
  const float tint = 0.5F + 0.5F * std::sin(static_cast<float>(part.variety) * 2.4F);
  return mix(rgb(58, 86, 44), rgb(86, 112, 52), tint) * (1.0F + 0.9F * rough);
}

/// Worn machine paint: dirt from below, chips that show the steel.
Vector3f paint(const Part& part, const SurfacePlace& place, const Vector3f& colour) {
  const Vector3f at = ownPlace(part, place.at);
  const float rough = roughness(at, 0.35F, 6, place.footprint);
  const float dirt = step(0.0F, 0.7F, noiseAt(at / 0.22F) + 0.6F * rough);
  const float chip =
      step(0.42F, 0.52F, roughness(at + Vector3f::Constant(9.0F), 0.08F, 3, place.footprint));
  return mix(mix(colour, rgb(104, 88, 66), 0.55F * dirt), rgb(70, 68, 66), chip) *
         (1.0F + 0.25F * rough);
}

/// The grapple wears yellow and black stripes, so that people see it.
Vector3f grapple(const Part& part, const SurfacePlace& place) {
  const float slope = (place.at.x() + place.at.y() + place.at.z()) / 0.16F;
  const float wide = std::max(0.02F, 0.7F * place.footprint / 0.16F);
  const float middle = std::abs(fraction(slope) - 0.5F);
  const float black = step(0.25F - wide, 0.25F + wide, middle);
  return paint(part, place, mix(rgb(236, 190, 30), rgb(34, 32, 30), black));
}

Vector3f plain(const Part& part, const SurfacePlace& place, const Vector3f& colour, float contrast,
               float coarsest) {
  return colour *
         (1.0F + contrast * roughness(ownPlace(part, place.at), coarsest, 5, place.footprint));
}

Vector3f vest(const Part& part, const SurfacePlace& place) {
  const float height = place.at.y() / static_cast<float>(part.box.size.y());
  const bool stripe = std::abs(std::abs(height) - 0.18F) < 0.06F;
  return plain(part, place, stripe ? rgb(225, 228, 222) : rgb(248, 110, 24), 0.28F, 0.12F);
}

Vector3f fallenLeaf(const Part& part, const SurfacePlace& place) {
  const float tint = 0.5F + 0.5F * std::sin(static_cast<float>(part.variety) * 1.7F);
  return plain(part, place, mix(rgb(196, 132, 40), rgb(150, 74, 32), tint), 0.3F, 0.03F);
}

}  // namespace

Vector3f paintOf(const Part& part, const SurfacePlace& place) {
  switch (part.material) {
    case Material::Soil:
      return paintOfGround(place);
    case Material::Bark:
      return bark(part, place);
    case Material::Log:
      return log(part, place);
    case Material::Concrete:
      return concrete(place);
    case Material::Foliage:
      return foliage(part, place);
    case Material::DryBranch:
      return plain(part, place, rgb(108, 92, 76), 0.6F, 0.10F);
    case Material::Paint:
      return paint(part, place, rgb(214, 74, 34));
    case Material::DarkSteel:
      return paint(part, place, rgb(92, 92, 96));
    case Material::Grapple:
      return grapple(part, place);
    case Material::Chrome:
      return plain(part, place, rgb(196, 200, 206), 0.20F, 0.15F);
    case Material::Vest:
      return vest(part, place);
    case Material::Trousers:
      return plain(part, place, rgb(52, 60, 84), 0.45F, 0.10F);
    case Material::Skin:
      return plain(part, place, rgb(206, 158, 130), 0.25F, 0.06F);
    case Material::Helmet:
      return plain(part, place, rgb(244, 214, 40), 0.15F, 0.10F);
    case Material::Feather:
      return plain(part, place, rgb(46, 46, 52), 0.4F, 0.06F);
    case Material::FallenLeaf:
      return fallenLeaf(part, place);
  }
  return Vector3f::Zero();
}

Vector3f paintOfGround(const SurfacePlace& place) {
  const Vector3f at(place.at.x(), 0.0F, place.at.z());
  const float rough = roughness(at, 0.9F, 8, place.footprint);
  const float grass = step(-0.25F, 0.30F, noiseAt(at / 2.3F) + 0.5F * noiseAt(at / 0.7F));
  const float litter =
      step(0.30F, 0.50F, roughness(at + Vector3f::Constant(21.0F), 0.12F, 3, place.footprint));
  Vector3f colour = mix(rgb(122, 98, 72), rgb(96, 112, 58), grass);
  colour = mix(colour, rgb(170, 140, 92), 0.7F * litter);  // chips and needles
  return colour * (1.0F + 0.62F * rough);
}

bool isGap(const Part& part, const Vector3f& at) {
  if (part.material != Material::Foliage) return false;
  const Vector3f half = part.box.size.cast<float>() / 2;
  const float out = std::hypot(at.x() / half.x(), at.z() / half.z());
  const Vector3f own = ownPlace(part, at);
  const float ragged = noiseAt(own / 0.16F) + 0.6F * noiseAt(own / 0.06F);
  return ragged > 1.0F - 1.1F * out * out;
}

}  // namespace boomwatch
