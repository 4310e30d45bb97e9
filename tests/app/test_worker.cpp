#include "worker.h"

#include <QtTest>
#include <algorithm>
#include <atomic>
#include <future>

#include "base/error.h"
#include "support/fake_source.h"
#include "support/test_registry.h"

using namespace boomwatch;
using Status = ReadResult::Status;

/// Gathers what a worker publishes, as the window would.
class Reader : public QObject {
  Q_OBJECT

 public:
  explicit Reader(Worker& worker) : m_worker(worker) {
    connect(&worker, &Worker::newsWaiting, this, &Reader::take);
  }

  News last;
  DisplayPtr display;
  std::size_t frames = 0;
  std::size_t shown = 0;
  std::size_t skipped = 0;
  std::size_t lost = 0;
  bool finished = false;
  std::vector<Notice> notices;
  std::vector<Reason> reasons;

  bool isIn(PlayState state) const {
    return last.status.player && last.status.player->state == state;
  }
  bool told(Notice::Kind kind, const QString& text) const {
    return std::any_of(notices.begin(), notices.end(), [&](const Notice& notice) {
      return notice.kind == kind && notice.text.contains(text);
    });
  }

 private:
  void take() {
    last = m_worker.takeNews();
    frames += last.frames;
    skipped += last.skipped;
    lost += last.lost;
    finished = finished || last.finished;
    notices.insert(notices.end(), last.notices.begin(), last.notices.end());
    if (!last.display) return;
    ++shown;
    display = last.display;
    reasons.push_back(display->result->clearance.reason);
  }

  Worker& m_worker;
};

class TestWorker : public QObject {
  Q_OBJECT

 private:
  static SourceOpener opening(const test::Script& script) {
    return [script](const std::string&, const SourceOptions&) {
      return std::make_unique<test::FakeSource>(script);
    };
  }
  static test::Script live() {
    test::Script script;
    script.info.live = true;
    script.info.frameCount.reset();
    return script;
  }
  static Parameters small() {
    Parameters parameters;
    parameters.bounds = {-2, 2, -2, 2, 0, 5};
    return parameters;
  }

 private slots:
  void playsARecordingToItsEndAndKeepsTheLastFrame() {
    Worker worker(small(), opening({}));
    Reader reader(worker);
    worker.command(SpeedCommand{Player::unlimited});
    worker.command(OpenCommand{"fake", {}});
    QTRY_VERIFY(reader.isIn(PlayState::Ended));
    QCOMPARE(reader.frames, std::size_t(10));
    QCOMPARE(reader.shown + reader.skipped, std::size_t(10));
    QVERIFY(reader.display->result->frame);
    QCOMPARE(reader.display->result->frame->sequence, std::uint64_t(9));
    QVERIFY(reader.display->result->model);
    QCOMPARE(reader.last.status.address, QStringLiteral("fake"));
  }

  void stopsAfterTheFramesAskedFor() {
    Worker worker(small(), opening({}));
    Reader reader(worker);
    worker.command(SpeedCommand{Player::unlimited});
    worker.command(StopAfterCommand{4});
    worker.command(OpenCommand{"fake", {}});
    QTRY_VERIFY(reader.finished);
    QCOMPARE(reader.frames, std::size_t(4));
    QTRY_VERIFY(reader.isIn(PlayState::Paused));
  }

  void everyCommandIsObeyedInOrder() {
    Worker worker(small(), opening({}));
    Reader reader(worker);
    worker.command(OpenCommand{"fake", {}});
    QTRY_VERIFY(reader.frames > 0);
    worker.command(PauseCommand{});
    QTRY_VERIFY(reader.isIn(PlayState::Paused));
    worker.command(LoopCommand{true});
    worker.command(SeekCommand{2});
    worker.command(SeekCommand{7});
    worker.command(SpeedCommand{2.0});
    QTRY_VERIFY(reader.display->result->frame->sequence == 7);
    QTRY_VERIFY(reader.last.status.player->loop);
    QCOMPARE(reader.last.status.player->speed, 2.0);
    worker.command(StepCommand{1});
    QTRY_VERIFY(reader.display->result->frame->sequence == 8);
    worker.command(StepCommand{-1});
    QTRY_VERIFY(reader.display->result->frame->sequence == 7);
  }

  void aSourceThatCannotBeOpenedIsSaidAndTheOldOneGoesOn() {
    const SourceOpener opener = [](const std::string& address, const SourceOptions&) {
      if (address == "bad") throw Error("bad", "no such folder", "Choose another");
      return std::make_unique<test::FakeSource>(live());
    };
    Worker worker(small(), opener);
    Reader reader(worker);
    worker.command(OpenCommand{"good", {}});
    QTRY_VERIFY(reader.frames > 0);
    worker.command(OpenCommand{"bad", {}});
    QTRY_VERIFY(reader.told(Notice::Kind::OpenFailed, "no such folder"));
    const std::size_t before = reader.frames;
    QTRY_VERIFY(reader.frames > before);
    QCOMPARE(reader.last.status.address, QStringLiteral("good"));
    QVERIFY(reader.last.status.opening.isEmpty());
  }

  void theOldSourceGoesOnWhileTheNewOneIsOpened() {
    std::promise<void> gate;
    const std::shared_future<void> open = gate.get_future().share();
    const SourceOpener opener = [open](const std::string& address, const SourceOptions&) {
      if (address == "slow") open.wait();
      return std::make_unique<test::FakeSource>(live());
    };
    Worker worker(small(), opener);
    Reader reader(worker);
    worker.command(OpenCommand{"quick", {}});
    QTRY_VERIFY(reader.frames > 0);
    worker.command(OpenCommand{"slow", {}});
    QTRY_COMPARE(reader.last.status.opening, QStringLiteral("slow"));
    const std::size_t before = reader.frames;
    QTRY_VERIFY(reader.frames > before);
    QCOMPARE(reader.last.status.address, QStringLiteral("quick"));
    gate.set_value();
    QTRY_COMPARE(reader.last.status.address, QStringLiteral("slow"));
  }

  void endsWhileASourceIsStillBeingOpened() {
    auto gate = std::make_shared<std::promise<void>>();
    const auto open = gate->get_future().share();
    auto left = std::make_shared<std::promise<void>>();
    {
      Worker worker(small(), [open, left](const std::string&, const SourceOptions&) {
        open.wait();
        left->set_value();
        return std::make_unique<test::FakeSource>(live());
      });
      Reader reader(worker);
      worker.command(OpenCommand{"hangs", {}});
      QTRY_COMPARE(reader.last.status.opening, QStringLiteral("hangs"));
    }
    gate->set_value();
    left->get_future().wait();
  }

  void parametersTakeEffectWithTheNextFrame() {
    Worker worker(small(), opening(live()));
    Reader reader(worker);
    worker.command(OpenCommand{"fake", {}});
    QTRY_VERIFY(reader.frames > 0);
    Parameters other = small();
    other.model.resolution = 0.1;
    worker.setParameters(other);
    QTRY_COMPARE(reader.display->result->parameters.model.resolution, 0.1);
    QTRY_COMPARE(reader.display->result->model->geometry().columns(), 40);
  }

  void contradictionsAreSaidAndTheLastGoodParametersStay() {
    Worker worker(small(), opening(live()));
    Reader reader(worker);
    worker.command(OpenCommand{"fake", {}});
    QTRY_VERIFY(reader.frames > 0);
    Parameters wrong = small();
    wrong.bounds.xMin = wrong.bounds.xMax;
    worker.setParameters(wrong);
    QTRY_VERIFY(reader.told(Notice::Kind::Parameters, "x_min"));
    const std::size_t before = reader.frames;
    QTRY_VERIFY(reader.frames > before);
    QVERIFY(reader.display->result->parameters.bounds == small().bounds);
  }

  void aBadFrameHasNoDistanceAndSaysWhy() {
    test::Script script;
    script.read = [](std::size_t i) -> ReadResult {
      if (i == 4) return {Status::Bad, nullptr, "picture 4 is torn", 0};
      return {Status::Ok, test::wallFrame(i, 0.1 * static_cast<double>(i)), {}, 0};
    };
    Worker worker(small(), opening(script));
    Reader reader(worker);
    worker.command(OpenCommand{"fake", {}});
    QTRY_VERIFY(reader.frames > 0);
    worker.command(PauseCommand{});
    QTRY_VERIFY(reader.isIn(PlayState::Paused));
    worker.command(SeekCommand{4});
    QTRY_VERIFY(reader.told(Notice::Kind::Frame, "torn"));
    QTRY_VERIFY(reader.reasons.back() == Reason::UnreadableFrame);
    QVERIFY(!reader.display->result->clearance.nearest);
    worker.command(StepCommand{1});
    QTRY_VERIFY(reader.display->result->frame);
    QCOMPARE(reader.display->result->frame->sequence, std::uint64_t(5));
  }

  void aLiveSourceThatStallsHasNoDistanceUntilItIsBack() {
    auto stalled = std::make_shared<std::atomic<bool>>(false);
    test::Script script = live();
    script.read = [stalled](std::size_t i) -> ReadResult {
      if (*stalled) return {Status::Stalled, nullptr, {}, 0};
      return {Status::Ok, test::wallFrame(i, 0.1 * static_cast<double>(i)), {}, 0};
    };
    Parameters parameters = small();
    parameters.validity.maxFrameAge = 0.1;
    Worker worker(parameters, opening(script));
    Reader reader(worker);
    worker.command(OpenCommand{"fake", {}});
    QTRY_VERIFY(reader.frames > 5);
    *stalled = true;
    QTRY_VERIFY(reader.reasons.back() == Reason::NoFrame);
    QVERIFY(!reader.display->result->clearance.nearest);
    *stalled = false;
    QTRY_VERIFY(reader.display->result->frame);
  }

  void aLostSourceIsSaidAndPlayOpensItAgain() {
    auto openings = std::make_shared<std::atomic<int>>(0);
    const SourceOpener opener = [openings](const std::string&, const SourceOptions&) {
      test::Script script = live();
      if (++*openings == 1) {
        script.read = [](std::size_t) -> ReadResult {
          return {Status::Lost, nullptr, "cable pulled", 0};
        };
      }
      return std::make_unique<test::FakeSource>(script);
    };
    Worker worker(small(), opener);
    Reader reader(worker);
    worker.command(OpenCommand{"fake", {}});
    QTRY_VERIFY(reader.isIn(PlayState::Lost));
    QVERIFY(reader.told(Notice::Kind::Lost, "cable pulled"));
    QVERIFY(reader.reasons.back() == Reason::NoFrame);
    worker.command(PlayCommand{});
    QTRY_VERIFY(reader.isIn(PlayState::Playing));
    QTRY_VERIFY(reader.display->result->frame);
  }

  void framesThatWentUnreadAreCounted() {
    test::Script script = live();
    script.read = [](std::size_t i) -> ReadResult {
      return {Status::Ok, test::wallFrame(i, 0.1 * static_cast<double>(i)), {}, 2};
    };
    Worker worker(small(), opening(script));
    Reader reader(worker);
    worker.command(StopAfterCommand{5});
    worker.command(OpenCommand{"fake", {}});
    QTRY_VERIFY(reader.finished);
    QCOMPARE(reader.lost, std::size_t(10));
  }

  void aWarningThatNobodyHadTimeToShowIsKept() {
    auto reads = std::make_shared<std::atomic<int>>(0);
    test::Script script;
    script.read = [reads](std::size_t i) -> ReadResult {
      auto frame = std::make_shared<Frame>(*test::wallFrame(i, 0.1 * static_cast<double>(i)));
      // In the wall for one frame, far in front of it before and after. The wall is in small
      // pieces, which count only once they are certain.
      frame->load->centre.z() = i == 8 ? 3.0 : 0.5;
      ++*reads;
      return {Status::Ok, frame, {}, 0};
    };
    Worker worker(small(), opening(script));
    worker.command(SpeedCommand{Player::unlimited});
    worker.command(OpenCommand{"fake", {}});
    // Nobody takes the news before the last frame is read.
    QTRY_COMPARE(reads->load(), 10);
    WarningLatch worst;
    bool over = false;
    const auto takeUntilOver = [&] {
      News news = worker.takeNews();
      worst.note(news.levels.take());
      over = over || (news.status.player && news.status.player->state == PlayState::Ended);
      return over;
    };
    QTRY_VERIFY(takeUntilOver());
    QVERIFY(worst.take() == WarningLevel::Collision);
  }

  void aNewColouringRedrawsWhatIsShown() {
    Worker worker(small(), opening({}));
    Reader reader(worker);
    worker.command(StopAfterCommand{6});
    worker.command(SpeedCommand{Player::unlimited});
    worker.command(OpenCommand{"fake", {}});
    QTRY_VERIFY(reader.finished);
    const std::size_t before = reader.frames;
    worker.setDisplayOptions({CloudColouring::Height, MapColouring::Uniform});
    QTRY_COMPARE(reader.display->options.maps, MapColouring::Uniform);
    QCOMPARE(reader.frames, before);
  }

  void theToolPixelReachesTheResult() {
    Worker worker(small(), opening(live()));
    Reader reader(worker);
    worker.command(OpenCommand{"fake", {}});
    QTRY_VERIFY(reader.frames > 0);
    worker.command(ToolCommand{PickTool{{10, 20}}});
    QTRY_VERIFY(reader.display->result->tool.pixel == std::optional(cv::Point(10, 20)));
    worker.command(ToolCommand{ForgetTool{}});
    QTRY_VERIFY(!reader.display->result->tool.pixel);
  }
};

BOOMWATCH_TEST(TestWorker)
#include "test_worker.moc"
