#pragma once

#include <QImage>
#include <QMetaType>
#include <cstdint>
#include <memory>
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

/// A result made ready to be drawn. Made on the worker thread, so that the GUI thread never
/// computes; immutable once made.
struct Display {
  ResultPtr result;
  QImage camera;       ///< left image; null if there is none
  QImage probability;  ///< a pixel a cell; null if there is no model
  QImage model;        ///< a pixel a cell, nearer is brighter, never observed told apart
  std::vector<std::uint8_t> cloudColours;  ///< RGB a point of result->cloud
};

using DisplayPtr = std::shared_ptr<const Display>;

/// Pure; any thread.
DisplayPtr makeDisplay(const ResultPtr& result, const DisplayOptions& options);

}  // namespace boomwatch

Q_DECLARE_METATYPE(boomwatch::DisplayPtr)
