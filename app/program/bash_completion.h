#pragma once

#include <string>

#include "program/program.h"

namespace boomwatch {

/// A script for bash that completes options, their values and commands; needs bash alone.
std::string bashCompletion(const Program& program);

}  // namespace boomwatch
