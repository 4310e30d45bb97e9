#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>

#include "support/fake_source.h"
#include "support/flat_scene.h"
#include "support/test_registry.h"
#include "tracking/tool_model.h"
#include "worker.h"

using namespace boomwatch;

namespace {

/// What a worker publishes.
class Reader : public QObject {
  Q_OBJECT

 public:
  explicit Reader(Worker& worker) : m_worker(worker) {
    connect(&worker, &Worker::newsWaiting, this, [this] {
      const News news = m_worker.takeNews();
      if (news.display) tool = news.display->result->tool;
      notices.insert(notices.end(), news.notices.begin(), news.notices.end());
    });
  }

  bool told(const QString& text) const {
    return std::any_of(notices.begin(), notices.end(), [&](const Notice& notice) {
      return notice.kind == Notice::Kind::Tool && notice.text.contains(text);
    });
  }

  ToolTrack tool;
  std::vector<Notice> notices;

 private:
  Worker& m_worker;
};

/// A live source that always shows the same wall.
SourceOpener wallSource() {
  test::Script script;
  script.info.live = true;
  script.info.frameCount.reset();
  script.read = [](std::size_t index) {
    return ReadResult{ReadResult::Status::Ok, test::wallFrame(index, 3.0F), {}, 0};
  };
  return [script](const std::string&, const SourceOptions&) {
    return std::make_unique<test::FakeSource>(script);
  };
}

Parameters following(TrackerKind kind) {
  Parameters parameters;
  parameters.bounds = {-2, 2, -2, 2, 0, 5};
  parameters.tracking.tracker = kind;
  return parameters;
}

const TrackBox box{cv::Rect2d(40, 40, 60, 60)};

}  // namespace

/// The worker obeys what is said about the tool. (Its other orders: test_worker.)
class TestWorkerTool : public QObject {
  Q_OBJECT

 private slots:
  void aBoxIsFollowed();
  void whatIsSaidBeforeTheSourceIsOpenHoldsForIt();
  void aBoxThatDoesNotFitIsToldAndNothingIsTracked();
  void aMissingModelIsToldByName();
  void thereIsNothingToSave();
  void aModelGoesThroughAFile();
  void aFolderThatIsNotThereIsToldByName();
};

void TestWorkerTool::aBoxIsFollowed() {
  Worker worker(following(TrackerKind::Klt), wallSource());
  Reader reader(worker);
  worker.command(OpenCommand{"fake:one", {}});
  QTRY_VERIFY(!reader.tool.running());
  worker.command(ToolCommand{box});
  QTRY_VERIFY(reader.tool.state == TrackState::Tracked);
  worker.command(ToolCommand{ForgetTool{}});
  QTRY_VERIFY(!reader.tool.running());
}

void TestWorkerTool::whatIsSaidBeforeTheSourceIsOpenHoldsForIt() {
  Worker worker(following(TrackerKind::Klt), wallSource());
  Reader reader(worker);
  worker.command(ToolCommand{PickTool{{7, 9}}});
  worker.command(OpenCommand{"fake:one", {}});
  QTRY_VERIFY(reader.tool.pixel == std::optional(cv::Point(7, 9)));
  // Not for the one after it.
  worker.command(OpenCommand{"fake:two", {}});
  QTRY_VERIFY(!reader.tool.pixel);
}

void TestWorkerTool::aBoxThatDoesNotFitIsToldAndNothingIsTracked() {
  Worker worker(following(TrackerKind::Klt), wallSource());
  Reader reader(worker);
  worker.command(OpenCommand{"fake:one", {}});
  worker.command(ToolCommand{TrackBox{cv::Rect2d(150, 40, 30, 30)}});
  QTRY_VERIFY(reader.told("reaches outside"));
  QTRY_VERIFY(reader.tool.lost());
}

void TestWorkerTool::aMissingModelIsToldByName() {
  Worker worker(following(TrackerKind::Tld), wallSource());
  Reader reader(worker);
  worker.command(OpenCommand{"fake:one", {}});
  worker.command(LoadToolModelCommand{{"/there/is/no.tool"}, false});
  QTRY_VERIFY(reader.told("/there/is/no.tool"));
  QVERIFY(!reader.tool.running());
}

void TestWorkerTool::thereIsNothingToSave() {
  const QTemporaryDir folder;
  const QString file = folder.filePath("none.tool");
  Worker worker(following(TrackerKind::Klt), wallSource());
  Reader reader(worker);
  worker.command(OpenCommand{"fake:one", {}});
  worker.command(SaveToolModelCommand{file.toStdString()});
  QTRY_VERIFY(reader.told(file));
  QVERIFY(!QFile::exists(file));
}

void TestWorkerTool::aModelGoesThroughAFile() {
  const QTemporaryDir folder;
  const QString file = folder.filePath("known.tool");
  Worker worker(following(TrackerKind::Tld), wallSource());
  Reader reader(worker);
  worker.command(OpenCommand{"fake:one", {}});
  worker.command(ToolCommand{box});
  QTRY_VERIFY(reader.tool.model);
  worker.command(SaveToolModelCommand{file.toStdString()});
  QTRY_VERIFY(QFile::exists(file));
  worker.command(ToolCommand{ForgetTool{}});
  QTRY_VERIFY(!reader.tool.running());
  worker.command(LoadToolModelCommand{{file.toStdString()}, false});
  QTRY_VERIFY(reader.tool.box);
  const std::size_t known = reader.tool.model->positives.size();
  worker.command(LoadToolModelCommand{{file.toStdString()}, true});
  QTRY_VERIFY(reader.tool.model->positives.size() > known);
  QVERIFY(reader.notices.empty());
}

void TestWorkerTool::aFolderThatIsNotThereIsToldByName() {
  Worker worker(following(TrackerKind::Tld), wallSource());
  Reader reader(worker);
  worker.command(OpenCommand{"fake:one", {}});
  worker.command(ToolCommand{box});
  QTRY_VERIFY(reader.tool.model);
  worker.command(SaveToolModelCommand{"/there/is/none/tool"});
  QTRY_VERIFY(reader.told("/there/is/none/tool"));
}

BOOMWATCH_TEST(TestWorkerTool)
#include "test_worker_tool.moc"
