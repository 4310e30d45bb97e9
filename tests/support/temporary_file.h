#pragma once

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QtTest>
#include <filesystem>

#include "base/error.h"

/// A folder that goes with the test, and files in it.
class TemporaryFolder {
 public:
  std::filesystem::path path(const QString& name = {}) const {
    return (name.isEmpty() ? m_folder.path() : m_folder.filePath(name)).toStdString();
  }
  std::filesystem::path write(const QString& name, const QByteArray& bytes) const {
    const QString file = m_folder.filePath(name);
    QDir().mkpath(QFileInfo(file).path());
    QFile::remove(file);  // rewriting in place is flushed to disk by some file systems
    QFile out(file);
    if (!out.open(QIODevice::WriteOnly) || out.write(bytes) != bytes.size()) {
      qFatal("cannot write %s", qPrintable(file));
    }
    return file.toStdString();
  }

 private:
  QTemporaryDir m_folder;
};

/// The message of the Error that `work` throws; empty when it throws none.
template <class Work>
QString errorOf(Work&& work) {
  try {
    work();
  } catch (const boomwatch::Error& error) {
    return QString::fromUtf8(error.what());
  }
  return {};
}

#define COMPARE_CONTAINS(text, part)                                                          \
  do {                                                                                        \
    const QString got = (text);                                                               \
    QVERIFY2(got.contains(part), qPrintable("got: '" + got + "', wanted: '" + (part) + "'")); \
  } while (false)
