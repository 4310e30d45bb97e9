#include <QtTest>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "pipeline/scene_motion.h"
#include "support/real_data.h"
#include "support/test_registry.h"

using boomwatch::SceneMotion;

namespace {

/// Smooth random texture: corners everywhere.
cv::Mat texture(int columns = 800, int rows = 600) {
  cv::RNG random(1);
  cv::Mat image(rows, columns, CV_8UC1);
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
  cv::GaussianBlur(image, image, {0, 0}, 4.0);
  cv::normalize(image, image, 0, 255, cv::NORM_MINMAX);
  return image;
}

cv::Mat warped(const cv::Mat& image, const cv::Mat& matrix) {
  cv::Mat result;
  cv::warpAffine(image, result, matrix, image.size(), cv::INTER_LINEAR, cv::BORDER_REFLECT);
  return result;
}

std::optional<double> shareBetween(const cv::Mat& first, const cv::Mat& second) {
  SceneMotion motion;
  motion.shareMoved(first);
  return motion.shareMoved(second);
}

/// Shares of the first 300 pairs of a film that there was an answer for.
std::vector<double> sharesOf(const QString& film) {
  cv::VideoCapture video(film.toStdString(), cv::CAP_FFMPEG);
  SceneMotion motion;
  std::vector<double> shares;
  cv::Mat image;
  while (shares.size() < 300 && video.read(image)) {
    if (const auto share = motion.shareMoved(image)) shares.push_back(*share);
  }
  return shares;
}

void verifyStill(const QString& film, std::size_t atLeast) {
  const std::vector<double> shares = sharesOf(film);
  QVERIFY2(shares.size() >= atLeast, qPrintable(QString::number(shares.size())));
  const auto high =
      std::count_if(shares.begin(), shares.end(), [](double share) { return share >= 0.35; });
  QVERIFY2(100 * high <= static_cast<std::ptrdiff_t>(shares.size()),
           qPrintable(QString("%1 of %2 pairs").arg(high).arg(shares.size())));
}

}  // namespace

class TestSceneMotion : public QObject {
  Q_OBJECT

 private slots:
  void aStillPictureDoesNotMove() {
    QCOMPARE(shareBetween(texture(), texture()), std::optional(0.0));
  }

  void noiseAndAChangeOfExposureAreNoMotion() {
    cv::Mat brighter = texture();
    cv::Mat noise(brighter.size(), CV_8UC1);
    cv::RNG(2).fill(noise, cv::RNG::UNIFORM, 0, 12);
    brighter = brighter * 0.85 + 20 + noise;
    QVERIFY(shareBetween(texture(), brighter).value() < 0.1);
  }

  void aShiftMovesEverything() {
    for (const auto& [dx, dy] : {std::pair{4, 0}, {0, 5}, {-12, 9}, {40, 10}}) {
      const cv::Mat shift = (cv::Mat_<double>(2, 3) << 1, 0, dx, 0, 1, dy);
      QVERIFY(shareBetween(texture(), warped(texture(), shift)).value() > 0.9);
    }
  }

  void aTurnMovesAllButTheMiddle() {
    const cv::Mat turn = cv::getRotationMatrix2D({400, 300}, 2.0, 1.0);
    QVERIFY(shareBetween(texture(), warped(texture(), turn)).value() > 0.8);
  }

  void aPersonBeforeAStillBackgroundIsNotTheScene() {
    const cv::Mat before = texture();
    cv::Mat after = before.clone();
    // A quarter of the width, the full height, all of it full of texture.
    before(cv::Rect(200, 0, 200, 600)).copyTo(after(cv::Rect(210, 0, 200, 600)));
    const double share = shareBetween(before, after).value();
    QVERIFY(share > 0.1 && share < 0.4);
  }

  void colourPicturesCountAsGreyOnes() {
    cv::Mat colour;
    cv::cvtColor(texture(), colour, cv::COLOR_GRAY2BGR);
    const cv::Mat shift = (cv::Mat_<double>(2, 3) << 1, 0, 8, 0, 1, 0);
    QVERIFY(shareBetween(colour, warped(colour, shift)).value() > 0.9);
  }

  void cannotTellFromTheFirstPictureNorAfterAChangeOfSizeOrAReset() {
    SceneMotion motion;
    QVERIFY(!motion.shareMoved(texture()));
    QVERIFY(motion.shareMoved(texture()));
    QVERIFY(!motion.shareMoved(texture(800, 500)));
    QVERIFY(motion.shareMoved(texture(800, 500)));
    motion.reset();
    QVERIFY(!motion.shareMoved(texture(800, 500)));
  }

  void cannotTellFromPicturesWithoutCorners() {
    for (const int grey : {0, 128, 255}) {
      const cv::Mat blank(600, 800, CV_8UC1, cv::Scalar(grey));
      QVERIFY(!shareBetween(blank, blank));
      QVERIFY(!shareBetween(texture(), blank));
    }
  }

  void oddPicturesAreTaken() {
    SceneMotion motion;
    for (const cv::Mat& odd :
         {cv::Mat(), cv::Mat(1, 1, CV_8UC1, cv::Scalar(9)),
          cv::Mat(1, 5000, CV_8UC1, cv::Scalar(9)), cv::Mat(5000, 1, CV_8UC3, cv::Scalar(9)),
          cv::Mat(600, 800, CV_16UC1, cv::Scalar(9)), cv::Mat(600, 800, CV_32FC1, cv::Scalar(9)),
          cv::Mat(600, 800, CV_8UC4, cv::Scalar(9)),
          cv::Mat(3, std::array{4, 5, 6}.data(), CV_8UC1, cv::Scalar(9))}) {
      QVERIFY(!motion.shareMoved(odd));
      QVERIFY(!motion.shareMoved(odd));
      QVERIFY(!motion.shareMoved(texture()));
    }
    cv::Mat small(3, 4, CV_8UC1);
    cv::RNG(3).fill(small, cv::RNG::UNIFORM, 0, 256);
    motion.shareMoved(small);
    motion.shareMoved(small);
  }

  void peopleInTheOverheadRecordingAreNotTheScene() {
    const QString film = sharedData("stereo_static_topdown_oakd/left.mp4");
    REQUIRE_DATA(film);
    verifyStill(film, 300);
  }
  void aBoxOnTheConveyorIsNotTheScene() {
    const QString film = sharedData("stereo_static_conveyor_dtu/left.mp4");
    REQUIRE_DATA(film);
    verifyStill(film, 280);
  }
  void pedestriansInDebiansOwnFilmAreNotTheScene() {
    const QString film = QStringLiteral("/usr/share/doc/opencv-doc/examples/data/vtest.avi");
    REQUIRE_DATA(film);
    verifyStill(film, 300);
  }

  void aCameraOnACarMovesInEveryPair() {
    const QString folder = sharedData("stereo_seq_kitti_odometry/KITTI_sequence_1/image_l");
    REQUIRE_DATA(folder);
    std::vector<cv::String> files;
    cv::glob(folder.toStdString() + "/*.png", files);
    QVERIFY(files.size() >= 50);
    SceneMotion motion;
    motion.shareMoved(cv::imread(files.front()));
    for (std::size_t k = 1; k < files.size(); ++k) {
      const auto share = motion.shareMoved(cv::imread(files[k]));
      QVERIFY2(share && *share > 0.6, files[k].c_str());
    }
  }
};

BOOMWATCH_TEST(TestSceneMotion)
#include "test_scene_motion.moc"
