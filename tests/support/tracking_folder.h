#pragma once

#include <QByteArray>
#include <QDir>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <string>

#include "support/tracked_target.h"

namespace boomwatch::test {

/// Where the target of these sequences is in `frame`, counted from 0.
inline cv::Point2d centreAt(int frame) { return {100.0 + 2.0 * frame, 100.0 + frame}; }

/// Pictures img/0001.png ... of a target that moves.
inline void writePictures(const QString& folder, int frames) {
  const TargetScene scene;
  QDir().mkpath(folder + QStringLiteral("/img"));
  for (int frame = 0; frame < frames; ++frame) {
    const QString file =
        QStringLiteral("%1/img/%2.png").arg(folder).arg(frame + 1, 4, 10, QLatin1Char('0'));
    cv::imwrite(file.toStdString(), scene.image(centreAt(frame)));
  }
}

/// The same as a video.
inline void writeVideo(const QString& file, int frames) {
  const TargetScene scene;
  cv::VideoWriter writer(file.toStdString(), cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 25.0,
                         scene.wall().size());
  for (int frame = 0; frame < frames; ++frame) writer << scene.image(centreAt(frame));
}

/// OTB's lines: x, y, width, height, counted from 1.
inline QByteArray sizeLines(int frames) {
  QByteArray text;
  for (int frame = 0; frame < frames; ++frame) {
    const cv::Rect2d box = TargetScene::box(centreAt(frame));
    text += QStringLiteral("%1,%2\t%3 %4\n")
                .arg(box.x + 1)
                .arg(box.y + 1)
                .arg(box.width)
                .arg(box.height)
                .toLatin1();
  }
  return text;
}

}  // namespace boomwatch::test
