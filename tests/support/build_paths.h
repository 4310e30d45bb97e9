#pragma once

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QString>

// Paths are looked for when a test runs. Compiled in, they would keep another clone of this tree
// from using what ccache has of this one.

/// The first folder above the test program that holds `entry`; "." where none does.
inline QDir folderAboveWith(const QString& entry) {
  QDir folder(QCoreApplication::applicationDirPath());
  do {
    if (QFileInfo::exists(folder.filePath(entry))) return folder;
  } while (folder.cdUp());
  return QDir(QStringLiteral("."));
}

/// A file of the source tree.
inline QString sourceFile(const QString& relative) {
  return folderAboveWith(QStringLiteral("CMakePresets.json")).filePath(relative);
}

/// A program that was built beside the tests, such as "boomwatch".
inline QString builtProgram(const QString& name) {
  return QDir(QCoreApplication::applicationDirPath()).filePath(QStringLiteral("../app/") + name);
}

/// A path below the folder of recordings: $BOOMWATCH_SHARED_DATA, or shared/data beside the clone.
inline QString sharedData(const QString& relative) {
  const QString named = qEnvironmentVariable("BOOMWATCH_SHARED_DATA");
  if (!named.isEmpty()) return QDir(named).filePath(relative);
  return folderAboveWith(QStringLiteral("shared/data"))
      .filePath(QStringLiteral("shared/data/") + relative);
}
