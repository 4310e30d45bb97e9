#include <QtTest>
#include <limits>

#include "parameters/parameter_table.h"
#include "parameters/parameter_text.h"
#include "pipeline/parameter_checks.h"
#include "support/temporary_file.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

QString text(std::string_view view) { return QString::fromUtf8(view.data(), int(view.size())); }

bool isNumber(const ParameterInfo& info) {
  const ParameterValue value = info.get(Parameters{});
  return !std::holds_alternative<bool>(value) && !std::holds_alternative<Choice>(value);
}

Parameters with(std::string_view key, std::string_view value) {
  Parameters parameters;
  setParameter(parameters, key, value);
  return parameters;
}

}  // namespace

class TestParameters : public QObject {
  Q_OBJECT
 private slots:
  void theTableHoldsTheKeysThatPeopleWereToldOf() {
    for (const char* key : {"x_min",
                            "x_max",
                            "y_min",
                            "y_max",
                            "z_min",
                            "z_max",
                            "z_reprojection",
                            "low_pass",
                            "resolution",
                            "probtresh",
                            "p_prior",
                            "p_post",
                            "cluster_tolerance",
                            "cluster_minimum",
                            "interval",
                            "radius",
                            "clearance_method",
                            "memory_limit",
                            "model_update",
                            "leave_threshold"}) {
      QCOMPARE(text(findParameter(key).key), QString(key));
    }
  }

  void everyRowReadsAndWritesAFieldOfItsOwn() {
    for (const ParameterInfo& changed : parameterTable()) {
      Parameters parameters;
      const ParameterValue value = changed.get(parameters);
      ParameterValue other = changed.minimum;
      if (const auto* flag = std::get_if<bool>(&value)) other = !*flag;
      if (std::holds_alternative<int>(value)) other = int(changed.minimum);
      if (std::holds_alternative<std::optional<double>>(value)) other = std::optional<double>(1.5);
      if (const auto* choice = std::get_if<Choice>(&value)) other = Choice{1 - choice->index};
      if (other == value) {
        other = std::holds_alternative<int>(value) ? ParameterValue(int(changed.maximum))
                                                   : ParameterValue(changed.maximum);
      }
      changed.set(parameters, other);
      for (const ParameterInfo& row : parameterTable()) {
        const bool differs = row.get(parameters) != row.get(Parameters{});
        QVERIFY2(differs == (row.key == changed.key), qPrintable(text(changed.key)));
      }
      QVERIFY(changed.get(parameters) == other);
    }
  }

  void everyValueSurvivesBeingWrittenAndReadBack() {
    for (const ParameterInfo& info : parameterTable()) {
      const ParameterValue value = info.get(Parameters{});
      QVERIFY(parseValue(info, formatValue(info, value)) == value);
      for (std::size_t k = 0; k < info.choices.size(); ++k) {
        QVERIFY(parseValue(info, info.choices[k]) == ParameterValue(Choice{int(k)}));
      }
      if (!std::holds_alternative<double>(value)) continue;
      for (const double share : {0.0, 1.0 / 3.0, 0.987654321, 1.0}) {
        const double exact = info.minimum + share * (info.maximum - info.minimum);
        const ParameterValue within = std::min(exact, info.maximum);
        QVERIFY(parseValue(info, formatValue(info, within)) == within);
      }
    }
  }

  void numbersAreWrittenAsPeopleWriteThem() {
    const ParameterInfo& info = findParameter("cluster_minimum");
    QCOMPARE(QString::fromStdString(rangeText(info)), QString("1 to 100000 points"));
    QCOMPARE(QString::fromStdString(rangeText(findParameter("resolution"))),
             QString("0.001 to 1 m"));
    QCOMPARE(QString::fromStdString(rangeText(findParameter("z_reprojection"))),
             QString("off or -1000 to 1000 m"));
    QCOMPARE(QString::fromStdString(rangeText(findParameter("clearance_method"))),
             QString("exact, rays"));
    QCOMPARE(QString::fromStdString(formatValue(findParameter("resolution"), 0.04)),
             QString("0.04"));
  }

  void whatIsOutOfRangeIsRefusedByKeyValueAndRange() {
    for (const ParameterInfo& info : parameterTable()) {
      if (!isNumber(info)) continue;
      for (const double beyond : {info.minimum - 1.0, info.maximum + 1.0}) {
        const std::string value = std::to_string(static_cast<long>(std::floor(beyond)));
        const QString message = errorOf([&] { parseValue(info, value); });
        COMPARE_CONTAINS(message, text(info.key));
        COMPARE_CONTAINS(message, QString::fromStdString(value));
        COMPARE_CONTAINS(message, QString::fromStdString(rangeText(info)));
      }
    }
  }

  void whatIsNoValueIsRefused_data() {
    QTest::addColumn<QString>("value");
    for (const char* value : {"", " ", "nan", "-nan", "inf", "-inf", "0.5m", "0.5 ", " 0.5", "0,5",
                              "1e999", "0x1", "+0.5", "--1", "yes", "1 2"}) {
      QTest::newRow(value) << value;
    }
    QTest::newRow("a line feed") << "0.5\n";
    QTest::newRow("a null character") << QString(QChar(0));
  }
  void whatIsNoValueIsRefused() {
    QFETCH(QString, value);
    for (const ParameterInfo& info : parameterTable()) {
      const std::string bytes = value.toStdString();
      QVERIFY2(!errorOf([&] { parseValue(info, bytes); }).isEmpty(), qPrintable(text(info.key)));
    }
  }

  void wholeNumbersTakeNoFractions() {
    QVERIFY(!errorOf([] { with("interval", "2.5"); }).isEmpty());
    QVERIFY(!errorOf([] { with("interval", "99999999999999999999"); }).isEmpty());
    QCOMPARE(with("interval", "5").clearance.interval, 5);
  }

  void switchesAndOptionalValuesCanBeOff() {
    QCOMPARE(with("low_pass", "on").filter.lowPass, true);
    QCOMPARE(with("low_pass", "false").filter.lowPass, false);
    QCOMPARE(with("z_reprojection", "2.5").filter.zReprojection, std::optional<double>(2.5));
    QCOMPARE(with("z_reprojection", "off").filter.zReprojection, std::optional<double>());
    QVERIFY(!errorOf([] { with("resolution", "off"); }).isEmpty());
  }

  void anUnknownKeySuggestsTheNearestKnownOne() {
    const QString message = errorOf([] { with("probthresh", "0.5"); });
    COMPARE_CONTAINS(message, QString("probthresh"));
    COMPARE_CONTAINS(message, QString("'probtresh'"));
    COMPARE_CONTAINS(errorOf([] { with("", "0.5"); }), QString("no such parameter"));
  }

  void messagesStayShortWhateverIsFedIn() {
    const std::string monster(3'000'000, '\n');
    const QString key = errorOf([&] { with(monster, "1"); });
    const QString value = errorOf([&] { with("radius", monster); });
    QVERIFY(key.size() < 300 && value.size() < 300);
    QVERIFY(!key.contains('\n') && !value.contains('\n'));
  }

  void theDefaultsAreValidAndUnremarkable() {
    QVERIFY(errorOf([] { validate(Parameters{}); }).isEmpty());
    QVERIFY(warningsFor(Parameters{}).empty());
  }

  void contradictionsAreRefusedByTheirKeys_data() {
    QTest::addColumn<QString>("settings");
    QTest::addColumn<QStringList>("named");
    const auto row = [](const char* settings, const QStringList& named) {
      QTest::newRow(settings) << settings << named;
    };
    row("x_min=10", {"x_min", "x_max"});
    row("y_max=-6", {"y_min", "y_max"});
    row("z_min=10 z_max=10", {"z_min", "z_max", "10 is not below 10"});
    row("warning_distance=3", {"warning_distance", "caution_distance"});
    row("model_update=hysteresis probtresh=0.1", {"leave_threshold", "probtresh"});
    row("stereo_disparities=40", {"stereo_disparities", "16"});
    row("stereo_block_size=6", {"stereo_block_size", "odd"});
    row("stereo_block_size=3 stereo_matcher=bm", {"stereo_block_size", "5"});
    row("resolution=1 x_min=0 x_max=0.5", {"resolution", "larger than the bounds"});
    row("resolution=0.001 x_min=-100 x_max=100",
        {"resolution", "memory_limit", "11500 MB", "1024 MB"});
    row("resolution=0.01 memory_limit=1", {"resolution", "memory_limit"});
  }
  void contradictionsAreRefusedByTheirKeys() {
    QFETCH(QString, settings);
    QFETCH(QStringList, named);
    Parameters parameters;
    for (const QString& setting : settings.split(' ')) {
      const QStringList pair = setting.split('=');
      setParameter(parameters, pair[0].toStdString(), pair[1].toStdString());
    }
    const QString message = errorOf([&] { validate(parameters); });
    for (const QString& part : named) COMPARE_CONTAINS(message, part);
  }

  void theModelMayTakeJustItsLimit() {
    Parameters parameters;  // 2000 x 1150 cells of 5 bytes: 11.5 MB
    parameters.model.resolution = 0.01;
    parameters.model.memoryLimit = 12;
    QVERIFY(errorOf([&] { validate(parameters); }).isEmpty());
    parameters.model.memoryLimit = 11;
    QVERIFY(!errorOf([&] { validate(parameters); }).isEmpty());
  }

  void notANumberIsNotValid() {
    Parameters parameters;
    parameters.model.resolution = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(!errorOf([&] { validate(parameters); }).isEmpty());
    parameters = {};
    parameters.bounds.zMax = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(!errorOf([&] { validate(parameters); }).isEmpty());
    parameters = {};
    parameters.model.resolution = 0.0;
    QVERIFY(!errorOf([&] { validate(parameters); }).isEmpty());
  }

  // Eq. 8 has the fixed point p_prior / (1 - p_post): 2/3 by default.
  void whatWillNotDoWhatItSeemsToIsRemarkedOn_data() {
    QTest::addColumn<QString>("settings");
    QTest::addColumn<QString>("key");  // empty: nothing to say
    const auto row = [](const char* settings, const char* key) {
      QTest::newRow(settings) << settings << key;
    };
    row("probtresh=0.66", "");
    row("probtresh=0.67", "probtresh");
    row("probtresh=0.4 p_post=0.5", "probtresh");
    row("probtresh=0.3999 p_post=0.5", "");
    row("probtresh=0.67 model_update=hysteresis", "probtresh");
    row("probtresh=0.9 model_update=log_odds", "");
    row("probtresh=0.97 model_update=log_odds", "probtresh");
    row("probtresh=0 model_update=thesis", "probtresh");
    row("probtresh=0.01 leave_threshold=0.5 model_update=thesis", "");
    row("range=1.9", "range");
    row("range=2", "");
    row("clearance_method=rays radius=49", "radius");
    row("clearance_method=rays radius=50", "");
    row("radius=1", "");
  }
  void whatWillNotDoWhatItSeemsToIsRemarkedOn() {
    QFETCH(QString, settings);
    QFETCH(QString, key);
    Parameters parameters;
    for (const QString& setting : settings.split(' ')) {
      const QStringList pair = setting.split('=');
      setParameter(parameters, pair[0].toStdString(), pair[1].toStdString());
    }
    QVERIFY(errorOf([&] { validate(parameters); }).isEmpty());
    const auto warnings = warningsFor(parameters);
    QCOMPARE(warnings.size(), std::size_t(!key.isEmpty()));
    if (!key.isEmpty()) QCOMPARE(text(warnings[0].key), key);
  }
};

BOOMWATCH_TEST(TestParameters)
#include "test_parameter_checks.moc"
