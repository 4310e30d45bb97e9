#pragma once

#include <functional>
#include <string>

#include "parameters/parameters.h"

namespace boomwatch {

/// Reads the text of a YAML preset (`key: value` lines) over `base`. `name` stands for the text in
/// messages. Throws Error naming `name`, line, key, value and range; unknown keys are errors. Does
/// not check whether the values contradict each other.
Parameters parsePreset(const std::string& text, const std::string& name,
                       const Parameters& base = {});

/// Every parameter as a `key: value` line, in groups.
std::string presetText(const Parameters& parameters);

/// Runs `work`. An Error that it throws is thrown again with `where` before it, and says that the
/// whole file was refused.
void refuseWholeFile(const std::string& where, const std::function<void()>& work);

}  // namespace boomwatch
