#pragma once

#include <QString>

#include "messages.h"

namespace boomwatch {

/// One or two words over the distance bar: is this now?
QString barCaption(const SourceStatus& status);

/// A sentence about what is shown: live, a recording, paused (so not now), ended, being opened.
QString stateSentence(const SourceStatus& status, bool rebuilding);

}  // namespace boomwatch
