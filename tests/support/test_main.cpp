// The main function of every test program. The first argument names one test; without it all run.
// BOOMWATCH_TEST_WIDGETS says whether they need windows.
#include <cstdio>
#include <memory>

#include "support/test_registry.h"

#ifdef BOOMWATCH_TEST_WIDGETS
#include <QApplication>
using Application = QApplication;
#else
#include <QCoreApplication>
using Application = QCoreApplication;
#endif

namespace boomwatch {

TestRegistry& testRegistry() {
  static TestRegistry tests;
  return tests;
}

}  // namespace boomwatch

int main(int count, char** words) {
  const Application application(count, words);
  const auto& tests = boomwatch::testRegistry();
  if (count < 2 || words[1][0] == '-') {
    int failures = 0;
    for (const auto& [name, run] : tests) failures += run(count, words);
    return failures;
  }
  const auto found = tests.find(words[1]);
  if (found == tests.end()) {
    std::fprintf(stderr, "There is no test %s here. There are:\n", words[1]);
    for (const auto& [name, run] : tests) std::fprintf(stderr, "  %s\n", name.c_str());
    return 2;
  }
  words[1] = words[0];
  return found->second(count - 1, words + 1);
}
