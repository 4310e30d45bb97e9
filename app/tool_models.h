#pragma once

#include <memory>
#include <span>
#include <string>

#include "tracking/tool_model.h"

namespace boomwatch {

/// The model that these files make together; several are merged. Throws Error naming the file.
std::shared_ptr<const ToolModel> loadToolModels(std::span<const std::string> files);

}  // namespace boomwatch
