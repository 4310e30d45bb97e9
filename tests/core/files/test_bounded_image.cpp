#include <QTemporaryDir>
#include <QtTest>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "files/bounded_image.h"
#include "support/temporary_file.h"
#include "support/test_registry.h"

using namespace boomwatch;
namespace fs = std::filesystem;

class TestBoundedImage : public QObject {
  Q_OBJECT

  std::unique_ptr<QTemporaryDir> m_temporary;
  fs::path m_folder;

  fs::path write(const std::string& name, const cv::Mat& image) {
    cv::imwrite((m_folder / name).string(), image);
    return m_folder / name;
  }
  void writeText(const std::string& name, const std::string& text) {
    std::ofstream(m_folder / name, std::ios::binary) << text;
  }

 private slots:
  void init() {
    m_temporary = std::make_unique<QTemporaryDir>();
    m_folder = m_temporary->path().toStdString();
  }

  void refusesPicturesThatClaimABillionPixels() {
    const std::string png("\x89PNG\r\n\x1A\n\0\0\0\rIHDR\0\0\x80\0\0\0\x80\0\x08\0\0\0\0", 29);
    const std::string pgm = "P5\n# large\n40000 40000\n255\n";
    const std::string bmp("BM\0\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\0\0\1\0\0\0\1\0\1\0\x18\0", 30);
    const std::string jpg("\xFF\xD8\xFF\xC0\0\x11\x08\xFF\xFF\xFF\xFF\3\1\x22\0\2\x11\1\3\x11\1",
                          21);
    for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
             {"a.png", png}, {"a.pgm", pgm}, {"a.bmp", bmp}, {"a.jpg", jpg}}) {
      writeText(name, text);
      COMPARE_CONTAINS(errorOf([&] { readImage(m_folder / name); }), QString("is not read"));
      QVERIFY(!imageSize(m_folder / name));
    }
  }

  void tellsTheSizeOfEveryFormatItReads() {
    for (const std::string name : {"a.png", "a.jpg", "a.bmp", "a.pgm", "a.ppm"}) {
      const int type = name == "a.pgm" ? CV_8UC1 : CV_8UC3;
      const auto file = write(name, cv::Mat(37, 53, type, cv::Scalar(1, 2, 3)));
      QVERIFY2(imageSize(file) == cv::Size(53, 37), name.c_str());
      QVERIFY2(readImage(file).size() == cv::Size(53, 37), name.c_str());
    }
  }

  void refusesTruncatedPictures() {
    cv::Mat noise(37, 53, CV_8UC1);
    cv::RNG(1).fill(noise, cv::RNG::UNIFORM, 0, 256);
    for (const char* name : {"a.png", "a.jpg", "a.bmp", "a.pgm"}) {
      const auto file = write(name, noise);
      std::ifstream stream(file, std::ios::binary);
      const std::string whole(std::istreambuf_iterator<char>(stream), {});
      for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 12) {
        writeText(name, whole.substr(0, size));
        QVERIFY2(errorOf([&] { readImage(file); }).contains(name), name);
      }
    }
  }
};

BOOMWATCH_TEST(TestBoundedImage)
#include "test_bounded_image.moc"
