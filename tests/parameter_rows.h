#pragma once

#include "core/effect/parameter_table.h"

#include <QtTest/QtTest>

namespace fumage::tests {

/// One row of test data, "key", for each parameter of the table.
inline void addParameterRows()
{
    QTest::addColumn<QString>("key");
    for (const Parameter& parameter : parameterTable()) {
        const QString key = QString::fromUtf8(parameter.key.data(), static_cast<qsizetype>(parameter.key.size()));
        QTest::newRow(qPrintable(key)) << key;
    }
}

} // namespace fumage::tests
