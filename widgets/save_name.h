#pragma once

#include <QString>

class QWidget;

namespace boomwatch {

/// Asks for the name of a file to save to; empty when nobody wants to. A name without an ending
/// gets `suffix` ("yaml"), without which no dialog would show the file again; whether what is there
/// may be replaced is asked of the whole name. GUI thread.
QString askSaveName(QWidget* parent, const QString& title, const QString& suggestion,
                    const QString& filter, const QString& suffix);

}  // namespace boomwatch
