#pragma once

#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "mailbox.h"
#include "messages.h"
#include "pipeline/pipeline.h"
#include "rate_meter.h"

namespace boomwatch {

/// Opens a source; may take long. openSource in the program, something else in tests.
using SourceOpener =
    std::function<std::unique_ptr<FrameSource>(const std::string&, const SourceOptions&)>;

/// What the worker's thread does: obey orders, read the frame that is due, process it, make it
/// ready to be drawn, publish it. Everything in here is used by that one thread.
class WorkerLoop {
 public:
  using TimePoint = Player::TimePoint;

  /// `announce` is called, in the worker's thread, when news wait that nobody was told of.
  WorkerLoop(Mailbox<Orders>& orders, Mailbox<News>& news, std::function<void()> announce,
             SourceOpener opener, const Parameters& parameters);

  /// Returns after Orders::stop.
  void run();

 private:
  void obey(const Orders& orders);
  void obey(const OpenCommand& command);
  void obey(const PlayCommand& command);
  void obey(const PauseCommand& command);
  void obey(const StepCommand& command);
  void obey(const SeekCommand& command);
  void obey(const LoopCommand& command);
  void obey(const SpeedCommand& command);
  void obey(const StopAfterCommand& command);
  void adoptParameters(const Parameters& parameters);
  void adoptOpened();
  void startPlaying(std::unique_ptr<FrameSource> source);
  void advance();
  void take(const ReadResult& read);
  void process(const FramePtr& frame);
  void publishNoFrame(Reason reason, const std::string& message = {});
  void checkAge();
  void checkRows(const Result& result);
  void countFrame();
  void publish(ResultPtr result);
  void tell(Notice::Kind kind, const std::string& text);
  void publishStatus();
  void finish();
  SourceStatus status() const;
  template <class Change>
  void post(Change&& change);
  std::optional<TimePoint> wakeUpTime() const;

  Mailbox<Orders>& m_orders;
  Mailbox<News>& m_news;
  std::function<void()> m_announce;
  SourceOpener m_opener;
  Pipeline m_pipeline;
  Parameters m_parameters;  ///< free of contradictions
  DisplayOptions m_options;
  std::unique_ptr<Player> m_player;
  OpenCommand m_open;  ///< what m_player plays
  std::optional<OpenCommand> m_wanted;
  std::future<std::unique_ptr<FrameSource>> m_opening;
  bool m_loop = false;
  double m_speed = 1.0;
  std::optional<std::size_t> m_framesLeft;
  RateMeter m_rate;
  TimePoint m_readAt;   ///< of the frame that is being processed
  TimePoint m_aliveAt;  ///< when a frame last came, or when it began to be waited for
  bool m_stalled = false;
  bool m_rowsTold = false;  ///< that the calibration does not fit, of this source
  ResultPtr m_last;
  SourceStatus m_published;
};

}  // namespace boomwatch
