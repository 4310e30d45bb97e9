#include <QtTest>

#include "open_source.h"
#include "sources/frame_source.h"
#include "support/temporary_file.h"
#include "support/test_registry.h"

using namespace boomwatch;

class TestOpenSource : public QObject {
  Q_OBJECT

  static QString faultOf(const std::string& address) {
    return errorOf([&] { openSource(address); });
  }

 private slots:
  void listsTheKindsWhenItKnowsNone_data() {
    QTest::addColumn<QString>("address");
    for (const char* address : {"", ":", "a/folder", "video:0", "stereo", "Stereo:x", ":x"}) {
      QTest::newRow(address) << address;
    }
  }
  void listsTheKindsWhenItKnowsNone() {
    QFETCH(QString, address);
    const QString fault = faultOf(address.toStdString());
    for (const char* kind : {"stereo:", "cloud:", "depth:", "camera:", "demo:"}) {
      QVERIFY2(fault.contains(kind), qPrintable(fault));
    }
    QVERIFY2(fault.contains("'" + address + "'"), qPrintable(fault));
  }

  void handsTheRestToTheKindThatIsNamed_data() {
    QTest::addColumn<QString>("kind");
    for (const char* kind : {"stereo", "cloud", "depth", "camera", "demo"}) {
      QTest::newRow(kind) << kind;
    }
  }
  void handsTheRestToTheKindThatIsNamed() {
    QFETCH(QString, kind);
    const QString fault = faultOf((kind + ":no/such:thing").toStdString());
    QVERIFY2(fault.contains("no/such:thing"), qPrintable(fault));
    QVERIFY2(!fault.contains("kind of source"), qPrintable(fault));
  }
};

BOOMWATCH_TEST(TestOpenSource)
#include "test_open_source.moc"
