#pragma once

#include <Eigen/Core>
#include <QImage>
#include <QMetaType>
#include <QPointF>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "pipeline/result.h"

namespace boomwatch {

/// By what the points of the cloud view are coloured.
enum class CloudColouring { Depth, Height, Image };
/// How the maps are coloured: grey as the thesis prints them, or a perceptually uniform map.
enum class MapColouring { Grey, Uniform };

struct DisplayOptions {
  CloudColouring cloud = CloudColouring::Depth;
  MapColouring maps = MapColouring::Grey;
};

/// The measured points inside the bounds, without gaps: what the cloud view draws. They lie in
/// layers, each an even sample of all, so that the first few layers can stand for the whole where
/// there is no time to draw it.
struct DrawnCloud {
  static constexpr std::size_t layerCount = 13;
  using Rgba = std::array<std::uint8_t, 4>;
  std::vector<Eigen::Vector3f> points;              ///< camera frame, metres; all finite
  std::vector<Rgba> colours;                        ///< one a point, opaque
  std::array<std::size_t, layerCount> layerEnds{};  ///< points in this layer and those before it
};

/// A result made ready to be drawn. Made on the worker thread, so that the GUI thread never
/// computes; immutable once made.
struct Display {
  ResultPtr result;
  DisplayOptions options;
  QImage camera;       ///< left image; null if there is none
  QImage probability;  ///< a pixel a cell, transparent where never observed; null without a model
  QImage model;        ///< as probability; nearer is brighter, free is darker than any depth
  QImage patches;      ///< what the tracker has learnt, see patchStrip(); null if there is nothing
  DrawnCloud cloud;
  CloudColouring cloudColouring = CloudColouring::Depth;  ///< Depth where Image was impossible
  /// Of `camera`; absent where the cloud is of another size or has no camera.
  std::optional<PinholeCamera> projection;
};

using DisplayPtr = std::shared_ptr<const Display>;

/// Where a point of the camera frame (z > 0, metres) falls in the left image.
inline QPointF pixelOf(const PinholeCamera& projection, const Eigen::Vector3d& p) {
  const Eigen::Vector2d pixel = projection.project(p);
  return {pixel.x(), pixel.y()};
}

/// Pure; any thread. Never null; `result` may be.
DisplayPtr makeDisplay(const ResultPtr& result, const DisplayOptions& options);

/// 256 colours, brighter with the index: 255 is the nearest or the most probable.
std::array<DrawnCloud::Rgba, 256> colourTable(MapColouring colouring);

/// Indices into colourTable. An observed cell with nothing in it is darker than every depth.
inline constexpr std::uint8_t freeBrightness = 20;
inline constexpr std::uint8_t maxBrightness = 64;       ///< of an occupied cell
inline constexpr std::uint8_t darkestPointColour = 70;  ///< of a point of the cloud

/// The colour of a depth level 1..255: nearer is brighter.
std::uint8_t brightnessOfLevel(std::uint8_t level);

}  // namespace boomwatch

Q_DECLARE_METATYPE(boomwatch::DisplayPtr)
