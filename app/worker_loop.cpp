#include "worker_loop.h"

#include <algorithm>
#include <array>
#include <thread>
#include <utility>

#include "base/error.h"
#include "pipeline/parameter_checks.h"
#include "stereo/row_alignment.h"
#include "tool_models.h"
#include "tracking/tool_model_file.h"

namespace boomwatch {
namespace {

using Clock = std::chrono::steady_clock;
// A live source is waited for this long at a time, so that commands are obeyed soon.
constexpr std::chrono::milliseconds patience(50);
constexpr std::chrono::milliseconds openingCheck(20);
constexpr std::size_t maxNotices = 50;

}  // namespace

WorkerLoop::WorkerLoop(Mailbox<Orders>& orders, Mailbox<News>& news, std::function<void()> announce,
                       SourceOpener opener, const Parameters& parameters)
    : m_orders(orders), m_news(news), m_announce(std::move(announce)), m_opener(std::move(opener)) {
  adoptParameters(parameters);
}

void WorkerLoop::run() {
  while (true) {
    m_orders.wait(wakeUpTime());
    const Orders orders = m_orders.take();
    if (orders.stop) return;
    obey(orders);
    adoptOpened();
    advance();
    publishStatus();
  }
}

std::optional<WorkerLoop::TimePoint> WorkerLoop::wakeUpTime() const {
  std::optional<TimePoint> time = m_player ? m_player->due() : std::nullopt;
  if (!m_wanted) return time;
  const TimePoint check = Clock::now() + openingCheck;
  return time ? std::min(*time, check) : check;
}

void WorkerLoop::obey(const Orders& orders) {
  if (orders.parameters) adoptParameters(*orders.parameters);
  for (const Command& command : orders.commands) {
    std::visit([this](const auto& known) { obey(known); }, command);
  }
  if (orders.options) {
    m_options = *orders.options;
    if (m_last) post([this](News& news) { news.display = makeDisplay(m_last, m_options); });
  }
}

void WorkerLoop::obey(const OpenCommand& command) {
  // In a thread of its own: a camera that does not answer must hold up neither the source that is
  // still playing nor the end of the program. One that is no longer wanted is left to itself.
  std::packaged_task<std::unique_ptr<FrameSource>()> task(
      [opener = m_opener, command] { return opener(command.address, command.options); });
  m_opening = task.get_future();
  m_wanted = command;
  std::thread(std::move(task)).detach();
}

void WorkerLoop::obey(const PlayCommand&) {
  if (!m_player) return;
  if (m_player->state() == PlayState::Lost) {
    obey(OpenCommand(m_open));
    return;
  }
  m_player->play();
  m_aliveAt = Clock::now();
  m_rate.reset();
}

void WorkerLoop::obey(const PauseCommand&) {
  if (m_player) m_player->pause();
}

void WorkerLoop::obey(const StepCommand& command) {
  if (m_player) m_player->step(command.direction);
}

void WorkerLoop::obey(const SeekCommand& command) {
  if (m_player) m_player->seek(command.index);
}

void WorkerLoop::obey(const LoopCommand& command) {
  m_loop = command.loop;
  if (m_player) m_player->setLoop(m_loop);
}

void WorkerLoop::obey(const SpeedCommand& command) {
  m_speed = command.speed;
  if (m_player) m_player->setSpeed(m_speed);
}

void WorkerLoop::obey(const StopAfterCommand& command) {
  m_framesLeft = std::max<std::size_t>(1, command.frames);
}

void WorkerLoop::obey(const ToolCommand& command) {
  if (!m_player) m_firstTool = command.order;
  m_pipeline.order(command.order);
}

void WorkerLoop::obey(const LoadToolModelCommand& command) {
  try {
    TrackModel order{loadToolModels(command.files)};
    const auto current = m_last ? m_last->tool.model : nullptr;
    if (command.withCurrent && current) {
      const std::array both{*current, *order.model};
      order.model = std::make_shared<const ToolModel>(mergeToolModels(both));
    }
    obey(ToolCommand{order});
  } catch (const std::exception& error) {
    tell(Notice::Kind::Tool, error.what());
  }
}

void WorkerLoop::obey(const SaveToolModelCommand& command) {
  try {
    const auto model = m_last ? m_last->tool.model : nullptr;
    if (!model) {
      throw Error(command.file, "the tracker has learnt nothing that could be saved",
                  "Start tld with a box or a model first.");
    }
    saveToolModel(*model, command.file);
  } catch (const std::exception& error) {
    tell(Notice::Kind::Tool, error.what());
  }
}

void WorkerLoop::adoptParameters(const Parameters& parameters) {
  try {
    validate(parameters);
    m_parameters = parameters;
  } catch (const Error& error) {
    tell(Notice::Kind::Parameters, error.what());
  }
}

void WorkerLoop::adoptOpened() {
  if (!m_wanted || m_opening.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  const OpenCommand opened = *std::exchange(m_wanted, std::nullopt);
  try {
    startPlaying(m_opening.get());
    m_open = opened;
  } catch (const std::exception& error) {
    tell(Notice::Kind::OpenFailed, error.what());
    if (!m_player) finish();
  }
}

void WorkerLoop::startPlaying(std::unique_ptr<FrameSource> source) {
  m_player = std::make_unique<Player>(std::move(source));
  m_player->setLoop(m_loop);
  m_player->setSpeed(m_speed);
  m_pipeline.reset();
  if (m_firstTool) m_pipeline.order(*std::exchange(m_firstTool, std::nullopt));
  m_last.reset();
  m_stalled = false;
  m_rowsTold = false;
  if (const SourceInfo& info = m_player->info(); !info.note.empty()) {
    tell(Notice::Kind::Source, info.note);
  }
  obey(PlayCommand{});
}

void WorkerLoop::advance() {
  if (!m_player) return;
  if (const auto read = m_player->poll(Clock::now(), patience)) take(*read);
}

void WorkerLoop::take(const ReadResult& read) {
  m_readAt = Clock::now();
  if (read.dropped > 0) post([&](News& news) { news.lost += read.dropped; });
  switch (read.status) {
    case ReadResult::Status::Ok:
      process(read.frame);
      break;
    case ReadResult::Status::Bad:
      publishNoFrame(Reason::UnreadableFrame, read.message);
      countFrame();
      break;
    case ReadResult::Status::Stalled:
      checkAge();
      break;
    case ReadResult::Status::Lost:
      tell(Notice::Kind::Lost, read.message);
      publishNoFrame(Reason::NoFrame);
      finish();
      break;
    case ReadResult::Status::End:
      finish();
      break;
  }
}

void WorkerLoop::process(const FramePtr& frame) {
  m_aliveAt = m_readAt;
  m_stalled = false;
  try {
    auto result = std::make_shared<Result>(m_pipeline.process(frame, m_parameters));
    if (!result->model) {
      result->model = std::make_shared<const EnvironmentModel>(m_pipeline.model());
    }
    checkRows(*result);
    if (!result->message.empty()) tell(Notice::Kind::Frame, result->message);
    if (!result->tool.fault.empty()) tell(Notice::Kind::Tool, result->tool.fault);
    publish(std::move(result));
  } catch (const std::exception& error) {
    publishNoFrame(Reason::UnreadableFrame, error.what());
  }
  countFrame();
}

void WorkerLoop::publishNoFrame(Reason reason, const std::string& message) {
  auto result = std::make_shared<Result>(noFrameResult(reason, m_parameters));
  result->message = message;
  if (reason == Reason::UnreadableFrame) tell(Notice::Kind::Frame, message);
  publish(std::move(result));
}

void WorkerLoop::checkAge() {
  const std::chrono::duration<double> age = m_readAt - m_aliveAt;
  if (m_stalled || age.count() <= m_parameters.validity.maxFrameAge) return;
  m_stalled = true;
  publishNoFrame(Reason::NoFrame);
}

void WorkerLoop::checkRows(const Result& result) {
  if (m_rowsTold || result.rowResidue.value_or(0.0) <= maxRowResidue) return;
  m_rowsTold = true;
  const auto kind = result.rowsCorrected ? Notice::Kind::RowsCorrected : Notice::Kind::Calibration;
  tell(kind, QString::number(*result.rowResidue, 'f', 1).toStdString());
}

void WorkerLoop::countFrame() {
  if (!m_framesLeft || --*m_framesLeft > 0) return;
  m_player->pause();
  finish();
}

void WorkerLoop::finish() {
  if (!m_framesLeft) return;
  m_framesLeft.reset();
  post([](News& news) { news.finished = true; });
}

void WorkerLoop::publish(ResultPtr result) {
  m_last = std::move(result);
  m_rate.note(Clock::now());
  const DisplayPtr display = makeDisplay(m_last, m_options);
  post([&](News& news) {
    if (news.display) ++news.skipped;
    news.display = display;
    news.readAt = m_readAt;
    news.levels.note(m_last->level);
    ++news.frames;
    news.framesPerSecond = m_rate.perSecond();
  });
}

void WorkerLoop::tell(Notice::Kind kind, const std::string& text) {
  const Notice notice{kind, QString::fromStdString(text)};
  post([&](News& news) {
    if (!news.notices.empty() && news.notices.back() == notice) return;
    if (news.notices.size() == maxNotices) news.notices.erase(news.notices.begin());
    news.notices.push_back(notice);
  });
}

void WorkerLoop::publishStatus() {
  if (status() != m_published) post([](News&) {});
}

SourceStatus WorkerLoop::status() const {
  SourceStatus now;
  if (m_wanted) now.opening = QString::fromStdString(m_wanted->address);
  if (!m_player) return now;
  now.address = QString::fromStdString(m_open.address);
  now.player = m_player->status();
  return now;
}

template <class Change>
void WorkerLoop::post(Change&& change) {
  m_published = status();
  const bool first = m_news.post([&](News& news) {
    change(news);
    news.status = m_published;
  });
  if (first) m_announce();
}

}  // namespace boomwatch
