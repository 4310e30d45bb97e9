#include "worker.h"

#include <utility>

namespace boomwatch {

Worker::Worker(const Parameters& parameters, SourceOpener opener, QObject* parent)
    : QObject(parent) {
  // The loop is made in its own thread: whatever it owns never meets another one.
  m_thread = std::thread([this, parameters, opener = std::move(opener)] {
    WorkerLoop(
        m_orders, m_news, [this] { emit newsWaiting(); }, opener, parameters)
        .run();
  });
}

Worker::~Worker() {
  m_orders.post([](Orders& orders) { orders.stop = true; });
  m_thread.join();
}

void Worker::command(const Command& command) {
  m_orders.post([&](Orders& orders) {
    // A slider that is dragged: only where it is now matters.
    const bool scrubbing = std::holds_alternative<SeekCommand>(command) &&
                           !orders.commands.empty() &&
                           std::holds_alternative<SeekCommand>(orders.commands.back());
    if (scrubbing) {
      orders.commands.back() = command;
    } else {
      orders.commands.push_back(command);
    }
  });
}

void Worker::setParameters(const Parameters& parameters) {
  m_orders.post([&](Orders& orders) { orders.parameters = parameters; });
}

void Worker::setDisplayOptions(const DisplayOptions& options) {
  m_orders.post([&](Orders& orders) { orders.options = options; });
}

}  // namespace boomwatch
