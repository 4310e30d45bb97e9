#include "source_guess.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>

#include "sources/bag/joined_bag.h"
#include "sources/stereo_files.h"

namespace boomwatch {
namespace {

bool isCloud(const QString& name) {
  static const QRegularExpression clouds(QStringLiteral("\\.(pcd|ply)$"),
                                         QRegularExpression::CaseInsensitiveOption);
  return clouds.match(name).hasMatch();
}

bool isBag(const QString& name) { return isBagFile(name.toStdString()); }

bool isDepth(const QString& name) {
  static const QRegularExpression depths(QStringLiteral("^(depth|depth\\.txt|.*_depth\\.png)$"),
                                         QRegularExpression::CaseInsensitiveOption);
  return depths.match(name).hasMatch();
}

std::optional<QString> guessFolder(const QString& path) {
  const QStringList names = QDir(path).entryList(QDir::Files | QDir::Dirs | QDir::NoDotAndDotDot);
  // Depth first: TUM's folders may hold clouds as well.
  if (std::any_of(names.begin(), names.end(), isDepth)) return QStringLiteral("depth:") + path;
  if (holdsStereoPair(path.toStdString())) return QStringLiteral("stereo:") + path;
  if (std::any_of(names.begin(), names.end(), isCloud)) return QStringLiteral("cloud:") + path;
  // ROS 2 writes a folder for each recording.
  if (std::any_of(names.begin(), names.end(), isBag)) return QStringLiteral("bag:") + path;
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
  // A bag is a recording of its own, whatever lies beside it.
  if (isBag(info.fileName())) return QStringLiteral("bag:") + info.absoluteFilePath();
  // One picture, video or list out of a recording stands for the recording.
  return guessFolder(info.absolutePath());
}

}  // namespace boomwatch
