#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <QDeadlineTimer>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>
#include <fstream>

#include "sources/camera_source.h"
#include "sources/live_stream.h"
#include "support/temporary_file.h"
#include "support/test_registry.h"

using namespace boomwatch;
using namespace std::chrono_literals;
using Status = ReadResult::Status;

namespace {

// A UDP port on loopback that nobody uses just now.
int freePort() {
  const int handle = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof address;
  auto* generic = reinterpret_cast<sockaddr*>(&address);
  const bool bound =
      bind(handle, generic, length) == 0 && getsockname(handle, generic, &length) == 0;
  close(handle);
  return bound ? ntohs(address.sin_port) : 0;
}

/// A stream on loopback for as long as it lives; two minutes at most, should the test die first.
class Sender {
 public:
  explicit Sender(const QString& filter) {
    m_url = QString("udp://127.0.0.1:%1").arg(freePort());
    m_process.start("ffmpeg", {"-loglevel", "quiet", "-re", "-f", "lavfi", "-i", filter, "-t",
                               "120", "-c:v", "mpeg2video", "-b:v", "4M", "-g", "5", "-f", "mpegts",
                               m_url + "?pkt_size=1316"});
    m_process.waitForStarted();
  }
  ~Sender() { stop(); }
  void stop() {
    m_process.kill();
    m_process.waitForFinished();
  }
  std::string url() const { return m_url.toStdString(); }

 private:
  QString m_url;
  QProcess m_process;
};

// Left black, right white.
const QString blackAndWhite =
    "color=black:size=320x240:rate=20[l];color=white:size=320x240:rate=20[r];[l][r]hstack";

double brightness(const cv::Mat& image) { return cv::mean(image)[0]; }

// Reads until `wanted` comes or half a minute is over.
ReadResult readUntil(FrameSource& source, Status wanted) {
  const QDeadlineTimer deadline(30000);
  ReadResult read;
  do {
    read = source.next(200ms);
  } while (read.status != wanted && !deadline.hasExpired());
  return read;
}

}  // namespace

class TestCameraSource : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  SourceOptions m_options;

  std::unique_ptr<FrameSource> open(const std::string& devices) {
    return openCameraSource(devices, "camera:" + devices, m_options);
  }
  QString faultOf(const std::string& devices, const SourceOptions& options) {
    return errorOf([&] { openCameraSource(devices, "camera:" + devices, options); });
  }

 private slots:
  void initTestCase() {
    m_options.calibration = m_folder.filePath("calib.txt").toStdString();
    std::ofstream(m_options.calibration)
        << "cam0=[300 0 160; 0 300 120; 0 0 1]\ncam1=[300 0 160; 0 300 120; 0 0 1]\n"
           "baseline=100\nwidth=320\nheight=240\n";
  }

  void saysWhyItCannotOpen() {
    QVERIFY(faultOf("0,1", {}).contains("--calibration"));
    QVERIFY(faultOf("", m_options).contains("does not name a camera"));
    QVERIFY(faultOf("left", m_options).contains("does not name a camera"));
    QVERIFY(faultOf("0,front", m_options).contains("does not name a camera"));
    QVERIFY(faultOf("9876", m_options).contains("camera 9876"));
    QVERIFY(faultOf("/dev/absent", m_options).contains("camera /dev/absent"));
    QVERIFY(faultOf("http://127.0.0.1:1/video", m_options).contains("cannot be opened"));
  }

  void keepsPasswordsOutOfItsMessages() {
    const QString fault = faultOf("http://operator:secret@127.0.0.1:1/video", m_options);
    QVERIFY(fault.contains("127.0.0.1:1/video"));
    QVERIFY(!fault.contains("secret"));
  }

  void tellsDevicesFromOtherText() {
    for (const char* device : {"0", "12", "/dev/video0", "rtsp://host/a,b", "udp://127.0.0.1:5"}) {
      QVERIFY2(isDevice(device), device);
    }
    for (const char* other : {"", "video", "12345", "-1", "1.5", "a/b"}) {
      QVERIFY2(!isDevice(other), other);
    }
  }

  void splitsASideBySideStream() {
    if (QStandardPaths::findExecutable("ffmpeg").isEmpty()) QSKIP("absent: ffmpeg");
    Sender sender(blackAndWhite);
    const auto source = open(sender.url());
    QVERIFY(source->info().live);
    QVERIFY(!source->info().frameCount);
    QVERIFY(!source->seek(0));
    double stamp = -1;
    for (std::uint64_t i = 0; i < 8; ++i) {
      const auto read = readUntil(*source, Status::Ok);
      QCOMPARE(read.status, Status::Ok);
      QCOMPARE(read.frame->sequence, i);
      QVERIFY(read.frame->stamp > stamp);
      stamp = read.frame->stamp;
      QCOMPARE(read.frame->left.size(), cv::Size(320, 240));
      QCOMPARE(read.frame->right.size(), cv::Size(320, 240));
      QVERIFY(brightness(read.frame->left) < 40);
      QVERIFY(brightness(read.frame->right) > 215);
      QVERIFY(read.frame->rig);
    }
  }

  void givesTheLatestFrameAndCountsThoseItPassedOver() {
    if (QStandardPaths::findExecutable("ffmpeg").isEmpty()) QSKIP("absent: ffmpeg");
    Sender sender(blackAndWhite);
    const auto source = open(sender.url());
    std::size_t dropped = 0;
    for (const QDeadlineTimer deadline(20000); dropped == 0 && !deadline.hasExpired();) {
      QTest::qWait(150);  // a reader slower than the camera
      dropped += source->next(1000ms).dropped;
    }
    QVERIFY(dropped > 0);
  }

  void stallsAndIsLostWhenTheSenderDies() {
    if (QStandardPaths::findExecutable("ffmpeg").isEmpty()) QSKIP("absent: ffmpeg");
    Sender sender(blackAndWhite);
    const auto source = open(sender.url());
    QCOMPARE(readUntil(*source, Status::Ok).status, Status::Ok);
    sender.stop();
    const auto stalled = readUntil(*source, Status::Stalled);
    QCOMPARE(stalled.status, Status::Stalled);
    QVERIFY(QString::fromStdString(stalled.message).contains("udp://127.0.0.1"));
    QVERIFY(!stalled.frame);
    const auto lost = readUntil(*source, Status::Lost);
    QCOMPARE(lost.status, Status::Lost);
    QVERIFY(QString::fromStdString(lost.message).contains("is gone"));
    QCOMPARE(source->next(0ms).status, Status::Lost);
  }

  void closesWhileAStreamIsSilent() {
    if (QStandardPaths::findExecutable("ffmpeg").isEmpty()) QSKIP("absent: ffmpeg");
    Sender sender(blackAndWhite);
    auto source = open(sender.url());
    sender.stop();
    source.reset();
    QVERIFY(!source);
  }

  void pairsTwoStreamsByArrival() {
    if (QStandardPaths::findExecutable("ffmpeg").isEmpty()) QSKIP("absent: ffmpeg");
    Sender left("color=black:size=320x240:rate=40"), right("color=white:size=320x240:rate=40");
    const auto source = open(left.url() + "," + right.url());
    for (int i = 0; i < 5; ++i) {
      const auto read = readUntil(*source, Status::Ok);
      QCOMPARE(read.status, Status::Ok);
      QVERIFY(brightness(read.frame->left) < 40);
      QVERIFY(brightness(read.frame->right) > 215);
      QVERIFY(QString::fromStdString(read.message).contains("ms apart"));
    }
    right.stop();
    QCOMPARE(readUntil(*source, Status::Lost).status, Status::Lost);
  }

  void refusesACalibrationForAnotherSize() {
    if (QStandardPaths::findExecutable("ffmpeg").isEmpty()) QSKIP("absent: ffmpeg");
    Sender sender("testsrc=size=320x240:rate=20");
    const QString fault = faultOf(sender.url(), m_options);
    QVERIFY2(fault.contains("160 x 240") && fault.contains("320 x 240"), qPrintable(fault));
  }
};

BOOMWATCH_TEST(TestCameraSource)
#include "test_camera_source.moc"
