#pragma once

#include <filesystem>

#include "parameters/parameters.h"

namespace boomwatch {

/// Reads a YAML preset (`key: value` lines) over `base`. Throws Error naming file, key, value and
/// range; unknown keys and values that contradict each other are errors.
Parameters loadPreset(const std::filesystem::path& file, const Parameters& base = {});

/// Writes every parameter. Throws Error when the file cannot be written; an old file is replaced
/// only by a whole new one.
void savePreset(const std::filesystem::path& file, const Parameters& parameters);

}  // namespace boomwatch
