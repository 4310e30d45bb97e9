#include "program/interrupt_watch.h"

#include <atomic>
#include <csignal>

namespace boomwatch {
namespace {

std::atomic<bool> stopped = false;
static_assert(std::atomic<bool>::is_always_lock_free);  // a signal handler may set it

void note(int) { stopped = true; }

}  // namespace

InterruptWatch::InterruptWatch() {
  stopped = false;
  m_interrupt = std::signal(SIGINT, note);
  m_terminate = std::signal(SIGTERM, note);
}

InterruptWatch::~InterruptWatch() {
  std::signal(SIGINT, m_interrupt);
  std::signal(SIGTERM, m_terminate);
}

bool InterruptWatch::interrupted() { return stopped; }

}  // namespace boomwatch
