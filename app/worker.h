#pragma once

#include <QObject>
#include <thread>

#include "mailbox.h"
#include "messages.h"
#include "open_source.h"
#include "worker_loop.h"

namespace boomwatch {

/// The GUI's end of the worker thread: orders in, news out, one latest-wins slot each way.
/// Every call returns at once. GUI thread.
class Worker : public QObject {
  Q_OBJECT

 public:
  /// Starts the thread, with nothing open.
  explicit Worker(const Parameters& parameters = {}, SourceOpener opener = openSource,
                  QObject* parent = nullptr);
  /// Ends the thread after the frame it is at.
  ~Worker() override;

  void command(const Command& command);
  void setParameters(const Parameters& parameters);
  void setDisplayOptions(const DisplayOptions& options);

  /// Everything since it was last taken.
  News takeNews() { return m_news.take(); }

 signals:
  /// takeNews() has something; not sent again until it has been taken.
  void newsWaiting();

 private:
  Mailbox<Orders> m_orders;
  Mailbox<News> m_news;
  std::thread m_thread;
};

}  // namespace boomwatch
