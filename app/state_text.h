#pragma once

#include <QString>

#include "messages.h"

namespace boomwatch {

/// One or two words over the distance bar: whether the picture is live.
QString barCaption(const SourceStatus& status);

/// A sentence about the source: live, a recording, paused (not live), ended, being opened.
QString stateSentence(const SourceStatus& status, bool rebuilding);

}  // namespace boomwatch
