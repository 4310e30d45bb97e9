#pragma once

#include "load/load_body.h"
#include "parameters/parameters.h"

namespace boomwatch {

/// The box around what hangs at the tool, by what is seen of it: of the boxes that lie along its
/// largest face, along a surface it stands on or along its principal axes, each turned to the
/// smallest rectangle about that axis, the one with the least volume. The boom (what goes on to the
/// limit of `reach` or out of the picture) is left away first.
///
/// Refused where only one face is seen, so that nothing says how deep the box is; with locked sizes
/// it is as deep as they say, behind the side that is seen. Pure.
LoadDetection fitBox(const DepthPatch& patch, const LoadBody& body, double reach,
                     const LoadParameters& parameters);

}  // namespace boomwatch
