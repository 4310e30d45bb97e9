#pragma once

#include <functional>
#include <string>

#include "parameters/parameters.h"

namespace boomwatch {

/// Reads the text of a YAML preset (`key: value` lines) over `base`. `name` names the text in
/// messages. Throws Error with `name`, line, key, value and range, also for an unknown key. Does
/// not check whether the values agree with each other; see validate().
Parameters parsePreset(const std::string& text, const std::string& name,
                       const Parameters& base = {});

/// All parameters as `key: value` lines, in groups.
std::string presetText(const Parameters& parameters);

/// Runs `work`. Rethrows its Error with `where` in front, and with the remark that the whole file
/// was rejected.
void refuseWholeFile(const std::string& where, const std::function<void()>& work);

}  // namespace boomwatch
