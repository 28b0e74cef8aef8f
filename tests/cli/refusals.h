#pragma once

#include "tests/cli/run.h"

#include <QtTest/QtTest>

namespace fumage::tests {

/// Rows of a test of what is refused: arguments, and what the message says.
class RefusalRows {
public:
    /// @param first arguments that all rows begin with
    explicit RefusalRows(QStringList first = {})
        : m_first(std::move(first))
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("says");
    }

    void operator()(const char* name, const QStringList& arguments, const char* says) const
    {
        QTest::newRow(name) << m_first + arguments << QByteArray(says);
    }

private:
    QStringList m_first;
};

/// Runs a row's arguments in an empty folder: they are refused by one line with what the row says, and nothing is
/// written.
inline void isRefusedAsTheRowSays()
{
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, says);
    const QTemporaryDir folder;
    const Outcome outcome = runIn(folder, arguments);
    QCOMPARE(outcome.code, 3);
    QVERIFY2(outcome.error.contains(says), outcome.error.constData());
    QCOMPARE(outcome.error.count('\n'), 1);
    QVERIFY(QDir(folder.path()).isEmpty());
}

} // namespace fumage::tests
