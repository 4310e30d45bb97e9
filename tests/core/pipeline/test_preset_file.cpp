#include <QtTest>
#include <algorithm>

#include "parameters/parameter_table.h"
#include "pipeline/preset_file.h"
#include "support/temporary_file.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

bool equal(const Parameters& a, const Parameters& b) {
  return std::ranges::all_of(parameterTable(),
                             [&](const ParameterInfo& info) { return info.get(a) == info.get(b); });
}

Parameters unusual() {
  Parameters parameters;
  parameters.bounds.xMin = -3.2;
  parameters.model.resolution = 0.1 + 0.2;
  parameters.filter.zReprojection = 1.25;
  parameters.filter.lowPass = true;
  parameters.clearance.method = ClearanceMethod::Rays;
  parameters.load.source = LoadSource::Manual;
  parameters.load.yaw = -45.0;
  return parameters;
}

}  // namespace

class TestPresets : public QObject {
  Q_OBJECT
 private slots:
  void whatIsSavedIsLoaded() {
    const TemporaryFolder folder;
    const auto file = folder.path("preset.yaml");
    savePreset(file, unusual());
    QVERIFY(equal(loadPreset(file), unusual()));
    QVERIFY(!equal(loadPreset(file), Parameters{}));
  }

  void anEmptyOptionalValueOverwritesASetOne() {
    const TemporaryFolder folder;
    savePreset(folder.path("preset.yaml"), Parameters{});
    QVERIFY(equal(loadPreset(folder.path("preset.yaml"), unusual()), Parameters{}));
  }

  void whatAPresetDoesNotNameStaysAsItWas() {
    const TemporaryFolder folder;
    const auto file = folder.write("p.yaml", "# mine\nradius: 100\nlow_pass: 'on'\n");
    Parameters wanted = unusual();
    wanted.clearance.radius = 100;
    QVERIFY(equal(loadPreset(file, unusual()), wanted));
  }

  void savingReplacesTheOldFileAndLeavesNothingElse() {
    const TemporaryFolder folder;
    const auto file = folder.write("p.yaml", "old");
    savePreset(file, unusual());
    QVERIFY(equal(loadPreset(file), unusual()));
    const std::filesystem::directory_iterator files(folder.path());
    QCOMPARE(std::distance(begin(files), end(files)), 1);
  }

  void aLinkStaysALink() {
    const TemporaryFolder folder;
    folder.write("real.yaml", "old");
    std::filesystem::create_symlink("real.yaml", folder.path("link.yaml"));
    savePreset(folder.path("link.yaml"), unusual());
    QVERIFY(std::filesystem::is_symlink(folder.path("link.yaml")));
    QVERIFY(equal(loadPreset(folder.path("real.yaml")), unusual()));
  }

  void whatCannotBeWrittenIsSaidAndTheOldFileStays() {
    const TemporaryFolder folder;
    const auto lost = folder.path("absent/p.yaml");
    COMPARE_CONTAINS(errorOf([&] { savePreset(lost, {}); }), QString::fromStdString(lost.string()));
    // A folder of the same name cannot be replaced, whoever runs this test.
    folder.write("p.yaml/inside", "kept");
    COMPARE_CONTAINS(errorOf([&] { savePreset(folder.path("p.yaml"), {}); }), QString("p.yaml"));
    QVERIFY(std::filesystem::exists(folder.path("p.yaml/inside")));
    const std::filesystem::directory_iterator files(folder.path());
    QCOMPARE(std::distance(begin(files), end(files)), 1);
  }

  void faultyPresetsAreRefusedByFileLineKeyValueAndRange_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QStringList>("named");
    const auto row = [](const char* name, const QByteArray& bytes, const QStringList& named) {
      QTest::newRow(name) << bytes << named;
    };
    row("unknown key", "radius: 5\nradios: 6\n", {"line 2", "'radios'", "'radius'"});
    row("out of range", "\n\nresolution: 7\n", {"line 3", "'resolution'", "'7'", "0.001 to 1 m"});
    row("not a number", "resolution: small\n", {"line 1", "'small'", "0.001 to 1 m"});
    row("NaN", "resolution: .nan\n", {"line 1", "'.nan'"});
    row("not a choice", "clearance_method: guess\n", {"'guess'", "exact, rays"});
    row("duplicated key", "radius: 5\nradius: 6\n", {"line 2", "'radius'", "twice"});
    row("a list", "radius: [5, 6]\n", {"line 1", "'radius'", "1 to 10000 cells"});
    row("a map", "radius: {a: 1}\n", {"line 1", "'radius'"});
    row("no value", "radius:\n", {"line 1", "'radius'"});
    row("a key that is a list", "? [a, b]\n: 5\n", {"line 1"});
    row("a contradiction", "x_min: 20\n", {"x_min", "x_max"});
    row("empty", "", {"empty"});
    row("only a comment", "# nothing\n", {"not a preset"});
    row("one word", "hello\n", {"not a preset"});
    row("a list of values", "- 1\n- 2\n", {"not a preset"});
    row("not YAML", "radius: 5\n: : [\n", {"line"});
    row("unclosed", "radius: \"5\n", {"line"});
    row("unknown anchor", "radius: *nowhere\n", {"line 1"});
    row("binary",
        QByteArray("\x7f"
                   "ELF\x02\x01\x00\x00\xff\xfe",
                   10),
        {});
    row("zeros", QByteArray(4096, '\0'), {});
    row("deeply nested", QByteArray(500'000, '['), {});
    row("two megabytes", QByteArray(2 << 20, '#'), {"larger"});
  }
  void faultyPresetsAreRefusedByFileLineKeyValueAndRange() {
    QFETCH(QByteArray, bytes);
    QFETCH(QStringList, named);
    const TemporaryFolder folder;
    const auto file = folder.write("faulty.yaml", bytes);
    const QString message = errorOf([&] { loadPreset(file); });
    COMPARE_CONTAINS(message, QString::fromStdString(file.string()));
    for (const QString& part : named) COMPARE_CONTAINS(message, part);
    QVERIFY(message.size() < 600);
  }

  void absentFilesAndFoldersAreRefused() {
    const TemporaryFolder folder;
    COMPARE_CONTAINS(errorOf([&] { loadPreset(folder.path("none.yaml")); }), QString("no such"));
    COMPARE_CONTAINS(errorOf([&] { loadPreset(folder.path()); }), QString("ordinary"));
  }
};

BOOMWATCH_TEST(TestPresets)
#include "test_preset_file.moc"
