#include "source_guess.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>

namespace boomwatch {
namespace {

bool isCloud(const QString& name) {
  static const QRegularExpression clouds(QStringLiteral("\\.(pcd|ply)$"),
                                         QRegularExpression::CaseInsensitiveOption);
  return clouds.match(name).hasMatch();
}

bool isDepth(const QString& name) {
  static const QRegularExpression depths(QStringLiteral("^(depth|depth\\.txt|.*_depth\\.png)$"),
                                         QRegularExpression::CaseInsensitiveOption);
  return depths.match(name).hasMatch();
}

struct SidePair {
  QRegularExpression left;
  QString right;
};

/// The name that the right side has where `name` is the left side's; empty if it is no left side.
QString rightOf(const QString& name) {
  static const SidePair pairs[] = {
      {QRegularExpression(QStringLiteral("left")), QStringLiteral("right")},
      {QRegularExpression(QStringLiteral("Left")), QStringLiteral("Right")},
      {QRegularExpression(QStringLiteral("^cam0$")), QStringLiteral("cam1")},
      {QRegularExpression(QStringLiteral("^im0\\.")), QStringLiteral("im1.")},
      {QRegularExpression(QStringLiteral("^image_0$")), QStringLiteral("image_1")},
      {QRegularExpression(QStringLiteral("^image_2$")), QStringLiteral("image_3")},
      {QRegularExpression(QStringLiteral("^im2\\.")), QStringLiteral("im6.")},
      {QRegularExpression(QStringLiteral("^image_l$")), QStringLiteral("image_r")},
      {QRegularExpression(QStringLiteral("L(\\.\\w+)$")), QStringLiteral("R\\1")},
  };
  for (const auto& [left, right] : pairs) {
    if (left.match(name).hasMatch()) return QString(name).replace(left, right);
  }
  return {};
}

bool isStereo(const QStringList& names) {
  return std::any_of(names.begin(), names.end(), [&](const QString& name) {
    const QString right = rightOf(name);
    return !right.isEmpty() && names.contains(right);
  });
}

std::optional<QString> guessFolder(const QString& path) {
  const QStringList names = QDir(path).entryList(QDir::Files | QDir::Dirs | QDir::NoDotAndDotDot);
  // Depth first: TUM's folders may hold clouds as well.
  if (std::any_of(names.begin(), names.end(), isDepth)) return QStringLiteral("depth:") + path;
  if (isStereo(names)) return QStringLiteral("stereo:") + path;
  if (std::any_of(names.begin(), names.end(), isCloud)) return QStringLiteral("cloud:") + path;
  return std::nullopt;
}

}  // namespace

std::optional<QString> guessAddress(const QString& path) {
  const QFileInfo info(path);
  if (!info.exists()) return std::nullopt;
  if (info.isDir()) return guessFolder(info.absoluteFilePath());
  if (info.suffix().compare(QStringLiteral("asc"), Qt::CaseInsensitive) == 0) {
    return QStringLiteral("map:") + info.absoluteFilePath();
  }
  if (isCloud(info.fileName())) return QStringLiteral("cloud:") + info.absoluteFilePath();
  // One picture, video or list out of a recording stands for the recording.
  return guessFolder(info.absolutePath());
}

}  // namespace boomwatch
