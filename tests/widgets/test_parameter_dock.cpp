#include "parameter_dock.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSignalSpy>
#include <QSpinBox>
#include <QToolButton>
#include <QWheelEvent>
#include <QtTest>

#include "parameter_row.h"
#include "parameters/parameter_table.h"
#include "parameters/parameter_text.h"
#include "support/test_registry.h"

using namespace boomwatch;

class TestParameterDock : public QObject {
  Q_OBJECT

 private:
  template <class Control>
  static Control* control(const ParameterDock& dock, std::string_view key) {
    return dock.row(key)->findChild<Control*>();
  }
  static Parameters sent(const QSignalSpy& spy) { return spy.back().at(0).value<Parameters>(); }
  static void type(QAbstractSpinBox* spin, const QString& text) {
    spin->selectAll();
    QTest::keyClicks(spin, text);
    QTest::keyClick(spin, Qt::Key_Return);
  }

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }

  void everyParameterHasARow() {
    const ParameterDock dock;
    for (const ParameterInfo& info : parameterTable()) {
      const ParameterRow* row = dock.row(info.key);
      QVERIFY2(row, info.key.data());
      const QString help = row->findChild<QLabel*>()->toolTip();
      QVERIFY2(help.contains(QString::fromUtf8(info.key.data())), info.key.data());
      QVERIFY2(!*info.unit || help.contains(QString::fromUtf8(info.unit)), info.key.data());
    }
  }

  void everyParameterSurvivesTheFieldsUnchanged() {
    Parameters odd;
    setParameter(odd, "resolution", "0.0123456789");
    setParameter(odd, "z_reprojection", "2.5");
    setParameter(odd, "clearance_method", "rays");
    setParameter(odd, "low_pass", "true");
    setParameter(odd, "interval", "17");
    ParameterDock dock;
    dock.setParameters(odd);
    for (const ParameterInfo& info : parameterTable()) {
      QVERIFY2(info.get(dock.parameters()) == info.get(odd), info.key.data());
    }
  }

  void settingFromOutsideEmitsNothing() {
    ParameterDock dock;
    QSignalSpy spy(&dock, &ParameterDock::parametersChanged);
    Parameters other;
    other.model.resolution = 0.1;
    other.clearance.method = ClearanceMethod::Rays;
    dock.setParameters(other);
    QCOMPARE(spy.count(), 0);
    QCOMPARE(control<QDoubleSpinBox>(dock, "resolution")->value(), 0.1);
  }

  void aTypedNumberTakesEffectOnEnter() {
    ParameterDock dock;
    QSignalSpy spy(&dock, &ParameterDock::parametersChanged);
    auto* spin = control<QDoubleSpinBox>(dock, "resolution");
    spin->selectAll();
    QTest::keyClicks(spin, "0.08");
    QCOMPARE(spy.count(), 0);
    QTest::keyClick(spin, Qt::Key_Return);
    QCOMPARE(spy.count(), 1);
    QCOMPARE(sent(spy).model.resolution, 0.08);
  }

  void everyKindOfEditorTakesEffect() {
    ParameterDock dock;
    QSignalSpy spy(&dock, &ParameterDock::parametersChanged);
    control<QSpinBox>(dock, "interval")->stepUp();
    QCOMPARE(sent(spy).clearance.interval, 9);
    control<QCheckBox>(dock, "low_pass")->click();
    QVERIFY(sent(spy).filter.lowPass);
    control<QComboBox>(dock, "clearance_method")->setCurrentIndex(1);
    QCOMPARE(sent(spy).clearance.method, ClearanceMethod::Rays);
    control<QCheckBox>(dock, "z_reprojection")->click();
    QVERIFY(sent(spy).filter.zReprojection.has_value());
    type(control<QDoubleSpinBox>(dock, "z_reprojection"), "4.5");
    QCOMPARE(*sent(spy).filter.zReprojection, 4.5);
    control<QCheckBox>(dock, "z_reprojection")->click();
    QVERIFY(!sent(spy).filter.zReprojection.has_value());
    QCOMPARE(spy.count(), 6);
  }

  void contradictionsStayAsTypedAndAreNotSent() {
    ParameterDock dock;
    QSignalSpy spy(&dock, &ParameterDock::parametersChanged);
    auto* spin = control<QDoubleSpinBox>(dock, "x_min");
    type(spin, "50");
    QCOMPARE(spy.count(), 0);
    QCOMPARE(spin->value(), 50.0);
    QVERIFY(dock.message().contains("x_min"));
    QVERIFY(!dock.row("x_min")->message().isEmpty());
    QVERIFY(!dock.row("x_max")->message().isEmpty());
    QVERIFY(dock.row("y_min")->message().isEmpty());
    type(control<QDoubleSpinBox>(dock, "x_max"), "60");
    QCOMPARE(spy.count(), 1);
    QCOMPARE(sent(spy).bounds.xMin, 50.0);
    QVERIFY(dock.message().isEmpty());
    QVERIFY(dock.row("x_min")->message().isEmpty());
  }

  void aProbtreshThatLetsNothingThroughIsSaidThere() {
    ParameterDock dock;
    QSignalSpy spy(&dock, &ParameterDock::parametersChanged);
    type(control<QDoubleSpinBox>(dock, "probtresh"), "0.67");
    QCOMPARE(spy.count(), 1);
    QVERIFY(!dock.row("probtresh")->message().isEmpty());
    type(control<QDoubleSpinBox>(dock, "probtresh"), "0.6");
    QVERIFY(dock.row("probtresh")->message().isEmpty());
  }

  void resetBringsBackOneOrAll() {
    ParameterDock dock;
    Parameters other;
    other.model.resolution = 0.1;
    other.clearance.interval = 3;
    dock.setParameters(other);
    QSignalSpy spy(&dock, &ParameterDock::parametersChanged);
    dock.row("resolution")->findChild<QToolButton*>()->click();
    QCOMPARE(sent(spy).model.resolution, Parameters{}.model.resolution);
    QCOMPARE(sent(spy).clearance.interval, 3);
    dock.resetAll();
    QCOMPARE(sent(spy).clearance.interval, Parameters{}.clearance.interval);
    QCOMPARE(spy.count(), 2);
  }

  void searchFindsKeysLabelsAndExplanations() {
    ParameterDock dock;
    const auto found = [&](const QString& text) {
      dock.search(text);
      QStringList keys;
      for (const ParameterInfo& info : parameterTable()) {
        if (!dock.row(info.key)->isHidden()) keys << QString::fromUtf8(info.key.data());
      }
      return keys;
    };
    QVERIFY(found("PROBTRESH").contains("probtresh"));
    QVERIFY(found("stereo_block").contains("stereo_block_size"));
    QVERIFY(found("Probability threshold").contains("probtresh"));
    QVERIFY(found("nothing is called this").isEmpty());
    QCOMPARE(static_cast<std::size_t>(found("").size()), parameterTable().size());
  }

  void theWheelChangesNothingAndIsLeftToTheScrollArea() {
    ParameterDock dock;
    QSignalSpy spy(&dock, &ParameterDock::parametersChanged);
    for (const ParameterInfo& info : parameterTable()) {
      for (QWidget* field :
           dock.row(info.key)->findChildren<QWidget*>(QString::fromUtf8(info.key.data()))) {
        field->setFocus();
        QWheelEvent wheel(QPointF(5, 5), QPointF(5, 5), QPoint(), QPoint(0, -240), Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(field, &wheel);
        QVERIFY2(!wheel.isAccepted(), info.key.data());
      }
    }
    QCOMPARE(spy.count(), 0);
  }

  void presetsAreSavedAndLoaded() {
    QTemporaryDir folder;
    const QString file = folder.filePath("one.yaml");
    ParameterDock dock;
    Parameters other;
    other.model.resolution = 0.05;
    other.filter.zReprojection = 1.25;
    dock.setParameters(other);
    QVERIFY(dock.savePresetFile(file));
    dock.resetAll();
    QSignalSpy spy(&dock, &ParameterDock::parametersChanged);
    QVERIFY(dock.loadPresetFile(file));
    QCOMPARE(spy.count(), 1);
    QCOMPARE(sent(spy).model.resolution, 0.05);
    QCOMPARE(sent(spy).filter.zReprojection, std::optional(1.25));
  }

  void aPresetThatCannotBeReadIsSaidAndChangesNothing() {
    QTemporaryDir folder;
    ParameterDock dock;
    QSignalSpy spy(&dock, &ParameterDock::parametersChanged);
    QVERIFY(!dock.loadPresetFile(folder.filePath("missing.yaml")));
    QVERIFY(dock.message().contains("missing.yaml"));
    QVERIFY(!dock.savePresetFile(folder.filePath("no/such/folder/x.yaml")));
    QCOMPARE(spy.count(), 0);
  }
};

BOOMWATCH_TEST(TestParameterDock)
#include "test_parameter_dock.moc"
