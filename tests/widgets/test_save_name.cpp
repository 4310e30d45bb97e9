// A file that is saved by its name without an ending gets one.
#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <functional>

#include "save_name.h"
#include "support/test_registry.h"

using boomwatch::askSaveName;

class TestSaveName : public QObject {
  Q_OBJECT
 private slots:
  void endings_data();
  void endings();
  void nobodyWantsTo();

 private:
  QString name(const QString& file) const { return m_folder.filePath(file); }
  QTemporaryDir m_folder;
};

namespace {

/// Does it as soon as the dialog is open.
void inTheDialog(const std::function<void(QFileDialog&)>& act) {
  auto* timer = new QTimer(qApp);
  QObject::connect(timer, &QTimer::timeout, qApp, [timer, act] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (!dialog) return;
    timer->deleteLater();
    act(*dialog);
  });
  timer->start(1);
}

}  // namespace

void TestSaveName::endings_data() {
  QTest::addColumn<QString>("typed");
  QTest::addColumn<QString>("expected");
  QTest::newRow("suggestion") << QString() << "boomwatch.tool";
  QTest::newRow("with its ending") << "mine.tool"
                                   << "mine.tool";
  QTest::newRow("without") << "mine"
                           << "mine.tool";
  QTest::newRow("another") << "mine.old"
                           << "mine.old";
}

void TestSaveName::endings() {
  QFETCH(QString, typed);
  QFETCH(QString, expected);
  inTheDialog([&](QFileDialog& dialog) {
    auto* edit = dialog.findChild<QLineEdit*>();
    if (!typed.isEmpty()) edit->setText(name(typed));
    QTest::keyClick(edit, Qt::Key_Return);
  });
  QCOMPARE(askSaveName(nullptr, "Save", name("boomwatch.tool"), "Models (*.tool)", "tool"),
           name(expected));
}

void TestSaveName::nobodyWantsTo() {
  inTheDialog([](QFileDialog& dialog) { dialog.reject(); });
  QVERIFY(
      askSaveName(nullptr, "Save", name("boomwatch.tool"), "Models (*.tool)", "tool").isEmpty());
}

BOOMWATCH_TEST(TestSaveName)
#include "test_save_name.moc"
