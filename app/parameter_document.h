#pragma once

#include <string>

namespace boomwatch {

/// docs/parameters.md: every parameter of the table, as Markdown. English.
std::string parameterDocument();

}  // namespace boomwatch
