#pragma once

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <functional>

#include "support/build_paths.h"

/// What the program, started without a window, said and how it ended.
struct ProgramRun {
  int exitCode = -1;  ///< -1: it crashed or hung
  QByteArray errors;
  QList<QJsonObject> lines;
};

inline ProgramRun runProgram(const QStringList& arguments) {
  QProcess process;
  process.start(builtProgram("boomwatch"), QStringList{"--headless"} + arguments);
  if (!process.waitForFinished(120000)) {
    process.kill();
    process.waitForFinished();
    return {-1, "it hangs", {}};
  }
  ProgramRun result;
  if (process.exitStatus() == QProcess::NormalExit) result.exitCode = process.exitCode();
  result.errors = process.readAllStandardError();
  for (const QByteArray& line : process.readAllStandardOutput().split('\n')) {
    if (!line.isEmpty()) result.lines << QJsonDocument::fromJson(line).object();
  }
  return result;
}

/// With a load of 30 cm that hangs 2 m before the camera.
inline ProgramRun runWithLoad(const QString& address, const QStringList& more = {}) {
  return runProgram(QStringList{"--source", address, "--load", "0,0,2,0.3,0.3,0.3,0,0,0"} + more);
}

inline QString writeFile(const QString& path, const QByteArray& bytes) {
  QDir().mkpath(QFileInfo(path).path());
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
    qFatal("%s cannot be written", qPrintable(path));
  }
  return path;
}

inline QByteArray pcdHeader(qulonglong width, qulonglong height, const char* data) {
  const QByteArray w = QByteArray::number(width), h = QByteArray::number(height);
  return "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " + w +
         "\nHEIGHT " + h + "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
         QByteArray::number(width * height) + "\nDATA " + data + "\n";
}

/// Columns and rows of the clouds below.
constexpr int cloudSide = 120;

/// A cloud 4 m wide and high around the camera's axis; nothing is measured where `depth` is NaN.
inline QString writeCloud(const QString& path, const std::function<float(int, int)>& depth) {
  QByteArray bytes = pcdHeader(cloudSide, cloudSide, "binary");
  const auto across = [](int i) { return static_cast<float>(i) * 4.0F / cloudSide - 2.0F; };
  for (int j = 0; j < cloudSide; ++j) {
    for (int i = 0; i < cloudSide; ++i) {
      const float z = depth(i, j);
      const float gap = z * 0.0F;
      const float point[3] = {across(i) + gap, across(j) + gap, z};
      bytes.append(reinterpret_cast<const char*>(point), sizeof point);
    }
  }
  return writeFile(path, bytes);
}

/// A depth of `wall` metres that is never the same twice, as no real sensor's is.
inline float unsteady(float wall, int frame) { return wall + 0.0001F * static_cast<float>(frame); }
