#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include "parameters/parameter_table.h"
#include "support/build_paths.h"
#include "support/test_registry.h"

namespace {

QByteArray outputOf(const QString& program, const QStringList& arguments) {
  QProcess process;
  process.start(program, arguments);
  if (!process.waitForFinished(120000)) process.kill();
  return process.exitCode() == 0 ? process.readAllStandardOutput() : QByteArray();
}

QByteArray contents(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QString typeOf(const QJsonValue& value) {
  switch (value.type()) {
    case QJsonValue::Null:
      return "null";
    case QJsonValue::Bool:
      return "boolean";
    case QJsonValue::Double:
      return "number";
    case QJsonValue::String:
      return "string";
    case QJsonValue::Array:
      return "array";
    default:
      return "object";
  }
}

bool typeFits(const QJsonValue& value, const QJsonValue& wanted) {
  const QJsonArray types = wanted.isArray() ? wanted.toArray() : QJsonArray{wanted};
  const bool whole = value.isDouble() && value.toDouble() == std::floor(value.toDouble());
  return types.contains(typeOf(value)) || (whole && types.contains("integer"));
}

/// What of JSON Schema the result line uses. Empty where `value` fits, else the place where not.
QString misfit(const QJsonValue& value, const QJsonObject& schema, const QString& place) {
  if (!typeFits(value, schema["type"])) return place + ": type " + typeOf(value);
  if (schema.contains("enum") && !schema["enum"].toArray().contains(value)) return place + ": enum";
  const QJsonObject properties = schema["properties"].toObject(), object = value.toObject();
  if (value.isObject() && !properties.isEmpty()) {
    for (const QJsonValue key : schema["required"].toArray()) {
      if (!object.contains(key.toString())) return place + ": lacks " + key.toString();
    }
    for (const QString& key : object.keys()) {
      if (!properties.contains(key)) return place + ": does not list " + key;
      const QString wrong = misfit(object[key], properties[key].toObject(), place + '.' + key);
      if (!wrong.isEmpty()) return wrong;
    }
  }
  if (!value.isArray()) return {};
  const QJsonArray items = value.toArray();
  if (items.size() < schema["minItems"].toInt(0)) return place + ": too short";
  if (items.size() > schema["maxItems"].toInt(1000)) return place + ": too long";
  for (const QJsonValue item : items) {
    const QString wrong = misfit(item, schema["items"].toObject(), place + "[]");
    if (!wrong.isEmpty()) return wrong;
  }
  return {};
}

}  // namespace

/// The documents that the programs make of their own tables.
class TestDocuments : public QObject {
  Q_OBJECT

  const QString m_boomwatch = builtProgram("boomwatch");
  const QString m_lab = builtProgram("boomwatch-lab");

 private slots:
  void theCommittedPagesAreCurrent_data() {
    QTest::addColumn<QString>("document");
    QTest::addColumn<QString>("file");
    QTest::newRow("parameters") << "parameters"
                                << "parameters.md";
    QTest::newRow("schema") << "schema"
                            << "result.schema.json";
  }
  void theCommittedPagesAreCurrent() {
    QFETCH(QString, document);
    QFETCH(QString, file);
    const QByteArray made = outputOf(m_boomwatch, {"--print", document});
    QVERIFY(!made.isEmpty());
    QVERIFY2(made == contents(sourceFile("docs/" + file)),
             qPrintable("docs/" + file + " is not current: run packaging/dev docs"));
  }

  void theSchemaDescribesTheLines_data() {
    QTest::addColumn<QString>("source");
    QTest::newRow("stereo yard") << "demo:yard";
    QTest::newRow("depth yard") << "demo:yard,as=depth";
    QTest::newRow("cylinders") << "demo:cylinders";
  }
  void theSchemaDescribesTheLines() {
    QFETCH(QString, source);
    const QByteArray schema = outputOf(m_boomwatch, {"--print", "schema"});
    const QJsonObject type = QJsonDocument::fromJson(schema).object();
    QCOMPARE(type["properties"].toObject().size(), 34);
    const QByteArray lines =
        outputOf(m_boomwatch, {"--headless", "--source", source, "--frames", "8"});
    QCOMPARE(lines.count('\n'), 8);
    for (const QByteArray& line : lines.trimmed().split('\n')) {
      const QString wrong = misfit(QJsonDocument::fromJson(line).object(), type, "line");
      QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    }
  }

  void everyKeyIsExplained() {
    const QByteArray schema = outputOf(m_boomwatch, {"--print", "schema"});
    const QJsonObject keys = QJsonDocument::fromJson(schema).object()["properties"].toObject();
    for (const QString& key : keys.keys()) {
      QVERIFY2(keys[key]["description"].toString().size() > 5, qPrintable(key));
      if (key.endsWith("_m")) QCOMPARE(keys[key]["unit"].toString(), QStringLiteral("m"));
      if (key.endsWith("_px")) QCOMPARE(keys[key]["unit"].toString(), QStringLiteral("px"));
      if (key.endsWith("_m_s")) QCOMPARE(keys[key]["unit"].toString(), QStringLiteral("m/s"));
    }
  }

  void everyParameterIsOnItsPageAndInTheManual() {
    const QByteArray page = outputOf(m_boomwatch, {"--print", "parameters"});
    const QByteArray manual = outputOf(m_boomwatch, {"--print", "man"});
    for (const auto& info : boomwatch::parameterTable()) {
      const QByteArray key(info.key.data(), qsizetype(info.key.size()));
      QCOMPARE(page.count("| `" + key + "` |"), 1);
      QVERIFY2(manual.contains("\\fB" + key + ' '), key);
    }
  }

  void theManualsAreTroff_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<QByteArray>("heading");
    QTest::newRow("boomwatch") << m_boomwatch << QByteArray(".TH BOOMWATCH 1 ");
    QTest::newRow("lab") << m_lab << QByteArray(".TH BOOMWATCH-LAB 1 ");
  }
  void theManualsAreTroff() {
    QFETCH(QString, program);
    QFETCH(QByteArray, heading);
    const QByteArray manual = outputOf(program, {"--print", "man"});
    QVERIFY(manual.startsWith(heading));
    for (const char* section : {".SH NAME\n", ".SH SYNOPSIS\n", ".SH OPTIONS\n", "SEE ALSO\n"}) {
      QVERIFY2(manual.contains(section), section);
    }
    for (const QByteArray& line : manual.split('\n')) {
      static const QRegularExpression macro(QStringLiteral("^\\.(TH|SH|SS|TP|PP|br|nf|fi)( .*)?$"));
      if (line.startsWith('.')) QVERIFY2(macro.match(line).hasMatch(), line);
      QVERIFY2(!line.startsWith('\''), line);
    }
  }

  // By bash itself, as it calls a completion.
  void bashCompletes_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<QString>("wanted");
    const auto row = [](const char* name, const QString& program, const QStringList& words,
                        const char* wanted) {
      QTest::newRow(name) << program << words << QString::fromLatin1(wanted);
    };
    row("an option", m_boomwatch, {"boomwatch", "--head"}, "--headless");
    row("a key", m_boomwatch, {"boomwatch", "--set", "probt"}, "probtresh=");
    row("a tracker", m_boomwatch, {"boomwatch", "--tracker", "t"}, "tld");
    row("a file", m_boomwatch, {"boomwatch", "--output", "pres"}, "preset.yaml");
    row("a number", m_boomwatch, {"boomwatch", "--frames", "1"}, "");
    row("a document", m_boomwatch, {"boomwatch", "--print", "s"}, "schema");
    row("a command", m_lab, {"boomwatch-lab", "ex"}, "export experiments");
    row("a demo", m_lab, {"boomwatch-lab", "export", "y"}, "yard");
    row("its option", m_lab, {"boomwatch-lab", "evaluate", "--abs"}, "--absences");
    row("its value", m_lab, {"boomwatch-lab", "evaluate", "--tracker", "opencv_m"},
        "opencv_medianflow");
    row("its file", m_lab, {"boomwatch-lab", "evaluate", "pre"}, "preset.yaml");
  }
  void bashCompletes() {
    QFETCH(QString, program);
    QFETCH(QStringList, words);
    QFETCH(QString, wanted);
    const QTemporaryDir folder;
    QFile script(folder.filePath("completion")), preset(folder.filePath("preset.yaml"));
    QVERIFY(script.open(QIODevice::WriteOnly) && preset.open(QIODevice::WriteOnly));
    script.write(outputOf(program, {"--print", "completion"}));
    script.close();
    QProcess bash;
    bash.setWorkingDirectory(folder.path());
    QString function = '_' + words[0];
    function.replace('-', '_');
    bash.start("bash", QStringList{"-uc",
                                   "compopt() { :; }; . ./completion; COMP_WORDS=(\"$@\"); "
                                   "COMP_CWORD=$(($# - 1)); " +
                                       function + "; echo ${COMPREPLY[*]:-}",
                                   "bash"} +
                           words);
    QVERIFY(bash.waitForFinished(30000));
    QCOMPARE(bash.readAllStandardError(), QByteArray());
    QCOMPARE(QString::fromUtf8(bash.readAllStandardOutput()).trimmed(), wanted);
  }
};

BOOMWATCH_TEST(TestDocuments)
#include "test_documents.moc"
