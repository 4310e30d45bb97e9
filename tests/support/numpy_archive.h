#pragma once

#include <zlib.h>

#include <QByteArray>
#include <QFile>
#include <QRegularExpression>
#include <QString>
#include <QtEndian>
#include <cstring>
#include <opencv2/core.hpp>
#include <stdexcept>

namespace boomwatch::test {

/// The first member of a ZIP archive that holds it deflated.
inline QByteArray firstMember(const QByteArray& archive) {
  constexpr qsizetype header = 30;
  const auto number = [&](qsizetype at) { return qFromLittleEndian<quint16>(&archive.data()[at]); };
  if (archive.size() < header || !archive.startsWith("PK\3\4") || number(8) != Z_DEFLATED) {
    throw std::runtime_error("not a deflated archive");
  }
  const qsizetype begin = header + number(26) + number(28);  // name and extra field
  if (begin > archive.size()) throw std::runtime_error("a truncated archive");
  QByteArray member(64 << 20, Qt::Uninitialized);
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw std::runtime_error("zlib");  // no header
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(archive.data() + begin));
  stream.avail_in = static_cast<uInt>(archive.size() - begin);
  stream.next_out = reinterpret_cast<Bytef*>(member.data());
  stream.avail_out = static_cast<uInt>(member.size());
  const int ended = inflate(&stream, Z_FINISH);
  inflateEnd(&stream);
  if (ended != Z_STREAM_END) throw std::runtime_error("a damaged archive");
  member.truncate(static_cast<qsizetype>(stream.total_out));
  return member;
}

/// The image of floats that numpy.savez_compressed wrote as the only array of `file`, CV_32FC1.
inline cv::Mat readNumpyImage(const QString& file) {
  QFile archive(file);
  if (!archive.open(QIODevice::ReadOnly)) throw std::runtime_error(file.toStdString());
  const QByteArray array = firstMember(archive.readAll());
  static const QRegularExpression shape(
      R"('descr': '<f4', 'fortran_order': False, 'shape': \((\d+), (\d+)\))");
  const auto found = shape.match(QString::fromLatin1(array.left(256)));
  if (!array.startsWith("\x93NUMPY\1") || !found.hasMatch()) {
    throw std::runtime_error("not a row-major image of floats: " + file.toStdString());
  }
  cv::Mat image(found.captured(1).toInt(), found.captured(2).toInt(), CV_32FC1);
  const auto bytes = static_cast<qsizetype>(image.total() * sizeof(float));
  const qsizetype begin = 10 + qFromLittleEndian<quint16>(&array.data()[8]);
  if (array.size() < begin + bytes) throw std::runtime_error("truncated: " + file.toStdString());
  std::memcpy(image.data, array.data() + begin, static_cast<std::size_t>(bytes));
  return image;
}

}  // namespace boomwatch::test
