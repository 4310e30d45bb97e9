#pragma once

#include <QString>
#include <optional>

namespace boomwatch {

/// The address of the source that a file or folder looks like, by what is in it; absent when it
/// looks like none. Reads names only.
std::optional<QString> guessAddress(const QString& path);

}  // namespace boomwatch
