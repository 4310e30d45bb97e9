#pragma once

#include <string>

#include "tracking/tool_model.h"

namespace boomwatch {

/// Writes a versioned file that loadToolModel() reads. Throws Error naming the file when it cannot
/// be written; an older file of that name is then left as it was.
void saveToolModel(const ToolModel& model, const std::string& file);

/// Throws Error that names the file when it is missing, truncated, damaged, of another kind or of
/// another version. Memory stays bounded whatever the file claims.
ToolModel loadToolModel(const std::string& file);

}  // namespace boomwatch
