#pragma once

#include <QFileInfo>
#include <QString>
#include <QtTest>

/// A path below the folder of recordings; tests skip where it is absent.
inline QString sharedData(const QString& relative) {
  return QStringLiteral(BOOMWATCH_SHARED_DATA "/") + relative;
}

#define REQUIRE_DATA(path) \
  if (!QFileInfo::exists(path)) QSKIP(qPrintable("absent: " + QString(path)))
