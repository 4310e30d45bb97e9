#pragma once

#include <QTest>
#include <functional>
#include <map>
#include <string>

namespace boomwatch {

/// The tests of one program: QtTest classes by the name of the file that holds them.
using TestRegistry = std::map<std::string, std::function<int(int, char**)>>;
TestRegistry& testRegistry();

/// Registers a class; see BOOMWATCH_TEST.
template <class Test>
bool registerTest(const std::string& file) {
  const auto begin = file.find_last_of('/') + 1;
  testRegistry()[file.substr(begin, file.find_last_of('.') - begin)] = [](int count, char** words) {
    Test test;
    return QTest::qExec(&test, count, words);
  };
  return true;
}

}  // namespace boomwatch

/// Makes a QtTest class a part of its folder's test program. One a file, in place of QTEST_MAIN.
#define BOOMWATCH_TEST(Class) \
  static const bool isRegistered = boomwatch::registerTest<Class>(__FILE__);
