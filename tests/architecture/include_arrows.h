#pragma once

#include <QDir>
#include <QMap>
#include <QRegularExpression>
#include <QString>
#include <QStringList>

namespace boomwatch {

/// One room of the tree, and the rooms whose headers its files may include besides their own.
struct Room {
  QString folder;
  QStringList below;
};

/// Headers of libraries that files below a folder must not include.
struct Ban {
  QString folder;  ///< empty: every folder
  QString header;  ///< how the header's name begins
};

/// Texts of source files by their path below the root of the tree.
using Sources = QMap<QString, QString>;

/// The room a path lies in: the one with the longest folder. Empty when there is none.
inline QString roomOfPath(const QList<Room>& rooms, const QString& path) {
  QString found;
  for (const Room& room : rooms) {
    if (path.startsWith(room.folder + '/') && room.folder.size() > found.size())
      found = room.folder;
  }
  return found;
}

/// The path an include in quotes means. A header that no file bears (generated, or not there yet)
/// still belongs to the room its folder names. Empty when it is none of this tree.
inline QString includedPath(const QList<Room>& rooms, const Sources& sources, const QString& from,
                            const QString& header) {
  const QString own = from.section('/', 0, -2) + '/';
  QStringList roots{own};
  for (const char* root : {"core/", "app/", "widgets/"}) roots << QString(root);
  for (const QString& root : roots) {
    const QString path = QDir::cleanPath(root + header);
    if (sources.contains(path)) return path;
  }
  for (const Room& room : rooms) {
    if (("core/" + header).startsWith(room.folder + '/')) return "core/" + header;
  }
  return {};
}

/// Says what is wrong with one include, or an empty text.
inline QString faultOfInclude(const QList<Room>& rooms, const QList<Ban>& bans,
                              const Sources& sources, const QString& from, const QString& header) {
  for (const Ban& ban : bans) {
    if (header.startsWith(ban.header) && (ban.folder.isEmpty() || from.startsWith(ban.folder)))
      return QString("%1 must not include <%2...>").arg(ban.folder, ban.header);
  }
  const QString path = includedPath(rooms, sources, from, header);
  if (path.isEmpty()) return {};
  const QString room = roomOfPath(rooms, from);
  const QString other = roomOfPath(rooms, path);
  if (room == other) return {};
  for (const Room& row : rooms) {
    if (row.folder == room && !row.below.contains(other))
      return QString("%1 must not include %2").arg(room, other);
  }
  return {};
}

/// Every include that breaks the table, as "file:line: what is wrong: the line".
inline QStringList includeFaults(const QList<Room>& rooms, const QList<Ban>& bans,
                                 const Sources& sources) {
  static const QRegularExpression include(R"(^\s*#\s*include\s*["<]([^">]+)[">])");
  QStringList faults;
  for (auto file = sources.cbegin(); file != sources.cend(); ++file) {
    if (roomOfPath(rooms, file.key()).isEmpty()) faults << file.key() + ": lies in no room";
    const QStringList lines = file->split('\n');
    for (qsizetype i = 0; i < lines.size(); ++i) {
      const auto match = include.match(lines[i]);
      if (!match.hasMatch()) continue;
      const QString fault = faultOfInclude(rooms, bans, sources, file.key(), match.captured(1));
      if (fault.isEmpty()) continue;
      faults << QString("%1:%2: %3: %4").arg(file.key()).arg(i + 1).arg(fault, lines[i].trimmed());
    }
  }
  return faults;
}

}  // namespace boomwatch
