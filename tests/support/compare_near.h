#pragma once

#include <QTest>
#include <cmath>

namespace boomwatch {

/// Fails the running test function when two numbers are further apart than the tolerance, and
/// prints both. Not a number is near nothing.
inline bool compareNear(double actual, double expected, double tolerance, const char* actualText,
                        const char* expectedText, const char* file, int line) {
  const double apart = std::abs(actual - expected);
  if (apart <= tolerance) return QTest::qVerify(true, actualText, "", file, line);
  const QString message = QStringLiteral(
                              "\n   Actual   (%1): %2\n   Expected (%3): %4\n"
                              "   Apart: %5, allowed: %6")
                              .arg(QString::fromUtf8(actualText))
                              .arg(actual, 0, 'g', 12)
                              .arg(QString::fromUtf8(expectedText))
                              .arg(expected, 0, 'g', 12)
                              .arg(apart, 0, 'g', 4)
                              .arg(tolerance, 0, 'g', 4);
  return QTest::qVerify(false, actualText, qPrintable(message), file, line);
}

}  // namespace boomwatch

/// QCOMPARE for measured numbers: prints both and their distance, and leaves the test function.
#define BW_COMPARE_NEAR(actual, expected, tolerance)                                          \
  do {                                                                                        \
    if (!boomwatch::compareNear(static_cast<double>(actual), static_cast<double>(expected),   \
                                static_cast<double>(tolerance), #actual, #expected, __FILE__, \
                                __LINE__))                                                    \
      return;                                                                                 \
  } while (false)
