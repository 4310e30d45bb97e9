#pragma once

#include <Eigen/Core>

namespace boomwatch {

/// Smooth noise in space, -1..1, with features of size 1; repeats every 64. Pure.
float noiseAt(const Eigen::Vector3f& p);

/// Noise with features of all sizes from `coarsest` metres down through `octaves` halvings, about
/// -1..1. What is finer than `footprint` (the metres that a pixel covers there) fades out, as it
/// would in a real picture. Pure.
float roughness(const Eigen::Vector3f& p, float coarsest, int octaves, float footprint);

}  // namespace boomwatch
