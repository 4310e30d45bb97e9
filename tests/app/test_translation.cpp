#include <QDockWidget>
#include <QFile>
#include <QRegularExpression>
#include <QTranslator>
#include <QtTest>

#include "main_window.h"
#include "parameters/parameter_table.h"
#include "state_text.h"
#include "support/build_paths.h"
#include "support/test_registry.h"

using namespace boomwatch;

class TestTranslation : public QObject {
  Q_OBJECT

 private:
  QTranslator m_german;

 private slots:
  void initTestCase() {
    QVERIFY(m_german.load(QStringLiteral(":/i18n/boomwatch_de.qm")));
    QVERIFY(QCoreApplication::installTranslator(&m_german));
  }

  void everyTextOfTheParameterTableIsTranslated() {
    for (const ParameterInfo& info : parameterTable()) {
      for (const char* text : {info.group, info.label, info.tooltip}) {
        QVERIFY2(!m_german.translate("Parameters", text).isEmpty(), text);
      }
    }
  }

  void noTextIsLeftUntranslated() {
    QFile file(sourceFile("translations/boomwatch_de.ts"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QString text = QString::fromUtf8(file.readAll());
    QVERIFY(text.count("<source>") > 250);
    QVERIFY(!text.contains("unfinished"));
    QVERIFY(!text.contains("<translation></translation>"));
  }

  void placeholdersAreKept() {
    QFile file(sourceFile("translations/boomwatch_de.ts"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    static const QRegularExpression message(
        QStringLiteral("<source>(.*?)</source>\\s*<translation>(.*?)</translation>"),
        QRegularExpression::DotMatchesEverythingOption);
    static const QRegularExpression argument(QStringLiteral("%\\d"));
    auto messages = message.globalMatch(QString::fromUtf8(file.readAll()));
    const auto placeholders = [](const QString& text) {
      QStringList found;
      auto matches = argument.globalMatch(text);
      while (matches.hasNext()) found << matches.next().captured();
      found.sort();
      return found;
    };
    QVERIFY(messages.hasNext());
    while (messages.hasNext()) {
      const auto match = messages.next();
      QCOMPARE(placeholders(match.captured(2)), placeholders(match.captured(1)));
    }
  }

  void theWindowSpeaksGerman() {
    MainWindow window({}, nullptr);
    QCOMPARE(window.panes().docks[1]->windowTitle(), QStringLiteral("Wahrscheinlichkeitskarte"));
    QCOMPARE(window.panes().parameters->windowTitle(), QStringLiteral("Parameter"));
    QVERIFY(window.panes().state->text().startsWith("Keine Quelle ist offen"));
    QCOMPARE(barCaption({}), QStringLiteral("KEINE QUELLE"));
    QCOMPARE(window.menus().resetLayout->text(), QStringLiteral("An&ordnung zurücksetzen"));
  }
};

BOOMWATCH_TEST(TestTranslation)
#include "test_translation.moc"
