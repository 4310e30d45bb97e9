#pragma once

#include <string>
#include <string_view>

#include "sources/point_table.h"

namespace boomwatch {

/// Fills `table` from the bytes of a PCD file. Throws Error naming `where` and the line of the
/// header.
void readPcd(std::string_view bytes, const std::string& where, PointTable& table);

}  // namespace boomwatch
