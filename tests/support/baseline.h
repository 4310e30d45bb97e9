#pragma once

#include <QDir>
#include <QFile>
#include <QImage>
#include <QString>
#include <algorithm>
#include <cmath>

#include "support/build_paths.h"

namespace boomwatch {

/// How many pixels of two pictures of one size differ by more than smoothing of edges explains.
inline int differentPixels(const QImage& one, const QImage& other) {
  constexpr int allowed = 64;  // of 255 a channel: fonts are smoothed a little differently
  int count = 0;
  for (int y = 0; y < one.height(); ++y) {
    for (int x = 0; x < one.width(); ++x) {
      const QRgb a = one.pixel(x, y), b = other.pixel(x, y);
      const int apart = std::max({std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)),
                                  std::abs(qBlue(a) - qBlue(b))});
      count += apart > allowed ? 1 : 0;
    }
  }
  return count;
}

/// The number of different pixels that a baseline of this size passes: one in 250.
inline int allowedPixels(const QImage& image) { return image.width() * image.height() / 250; }

/// Compares a picture with tests/baselines/NAME.png. Says what is wrong, or an empty text, and
/// leaves the picture that was seen in baselines_seen/ of the working directory. With
/// BOOMWATCH_WRITE_BASELINES in the environment it writes the baseline instead, where it differs.
inline QString baselineFault(const QImage& picture, const QString& name) {
  const QImage seen = picture.convertToFormat(QImage::Format_RGB32);
  const QString path = sourceFile(QStringLiteral("tests/baselines/%1.png").arg(name));
  const QImage baseline = QImage(path).convertToFormat(QImage::Format_RGB32);
  const bool fits = baseline.size() == seen.size();
  const int different = fits ? differentPixels(seen, baseline) : -1;
  if (qEnvironmentVariableIsSet("BOOMWATCH_WRITE_BASELINES")) {
    if (different == 0) return {};
    QDir().mkpath(sourceFile(QStringLiteral("tests/baselines")));
    return seen.save(path, "PNG", 0) ? QString() : QStringLiteral("cannot write ") + path;
  }
  if (fits && different <= allowedPixels(seen)) return {};
  QDir().mkpath(QStringLiteral("baselines_seen"));
  const QString kept = QDir().absoluteFilePath(QStringLiteral("baselines_seen/%1.png").arg(name));
  seen.save(kept);
  const QString what =
      baseline.isNull() ? QStringLiteral("there is no baseline")
      : fits ? QStringLiteral("%1 pixels differ, %2 may").arg(different).arg(allowedPixels(seen))
             : QStringLiteral("the size is another");
  return QStringLiteral("%1: %2. Compare it with %3; `packaging/dev baselines` takes it over.")
      .arg(path, what, kept);
}

}  // namespace boomwatch
