#pragma once

#include <string>

#include "program/program.h"

namespace boomwatch {

/// The manual page of section 1, in troff's man macros. The same program gives the same bytes.
std::string manualPage(const Program& program);

}  // namespace boomwatch
