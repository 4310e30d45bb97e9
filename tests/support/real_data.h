#pragma once

#include <QtTest>

#include "support/build_paths.h"

/// Skips the test where a recording is absent.
#define REQUIRE_DATA(path) \
  if (!QFileInfo::exists(path)) QSKIP(qPrintable("absent: " + QString(path)))
