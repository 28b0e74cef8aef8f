// Key frames as tables in CSV.

#include "tests/helpers.h"

#include "core/effect/known_parameter.h"
#include "core/effect/parameter_table.h"
#include "core/scene/key_table.h"

using namespace fumage;

namespace {

constexpr const Parameter& kPosition = knownParameter("emitter.position");
constexpr const Parameter& kRate = knownParameter("emitter.rate");

} // namespace

class KeyTableTest : public QObject {
    Q_OBJECT

private slots:
    /// Of every parameter that can change over time.
    void whatIsWrittenIsRead()
    {
        const Effect effect;
        int rows = 0;
        for (const Parameter& parameter : parameterTable()) {
            if (!canAnimate(parameter)) {
                continue;
            }
            Track track{&parameter, {}};
            setKey(track, {0.0, parameter.get(effect)});
            setKey(track, {1.0 / 3.0, parameter.get(effect)});
            const Result<Track> read = parseKeyTable(parameter, formatKeyTable(track), 30);
            QVERIFY2(read && read.value() == track, parameter.key.data());
            ++rows;
        }
        QVERIFY(rows > 100);
        Track way{&kPosition, {{0.0, glm::vec3(0.1F, -2.5F, 3e-7F)}, {0.1, glm::vec3(1.0F / 3.0F, 0.0F, 1.0F)}}};
        QVERIFY(formatKeyTable(way).starts_with("seconds,x,y,z\n0,0.1,-2.5,"));
        QVERIFY(parseKeyTable(kPosition, formatKeyTable(way), 30).value() == way);
    }

    void tablesOfOthersAreRead_data()
    {
        QTest::addColumn<QString>("table");
        QTest::newRow("spaces") << "seconds, x, y, z\n 0 , 1, 2, 3 \n 0.5, 4, 5, 6\n";
        QTest::newRow("no heading") << "0,1,2,3\n0.5,4,5,6";
        QTest::newRow("tabs, of a spreadsheet") << "t\tx\ty\tz\r\n0\t1\t2\t3\r\n0.5\t4\t5\t6\r\n\r\n";
        QTest::newRow("semicolons") << "time;x;y;z\n0;1;2;3\n0.5;4;5;6";
        QTest::newRow("frames") << "Frame,x,y,z\n0,1,2,3\n12,4,5,6";
        QTest::newRow("out of order") << "0.5,4,5,6\n0,1,2,3";
        QTest::newRow("one time twice") << "0.5,9,9,9\n0,1,2,3\n0.5,4,5,6";
    }
    void tablesOfOthersAreRead()
    {
        QFETCH(QString, table);
        const Result<Track> read = parseKeyTable(kPosition, table.toStdString(), 24);
        QVERIFY2(read, read ? "" : read.error().text().c_str());
        const Track way{&kPosition, {{0.0, glm::vec3(1.0F, 2.0F, 3.0F)}, {0.5, glm::vec3(4.0F, 5.0F, 6.0F)}}};
        QVERIFY(read.value() == way);
    }

    void whatIsNoTableIsRefusedWithItsLine_data()
    {
        QTest::addColumn<QString>("table");
        QTest::addColumn<QString>("says");
        QString many = QStringLiteral("seconds,value\n");
        for (int i = 0; i < 100'000; ++i) {
            many += QString::number(i) + QStringLiteral(",1\n");
        }
        QTest::newRow("empty") << ""
                               << "0 key frames";
        QTest::newRow("a heading alone") << "seconds,value\n"
                                         << "0 key frames";
        QTest::newRow("words") << "0,1\nsoon,1\n"
                               << "line 2: \"soon\"";
        QTest::newRow("no value") << "0,1\n1\n"
                                  << "line 2";
        QTest::newRow("two values") << "0,1\n1,2,3\n"
                                    << "line 2";
        QTest::newRow("NaN") << "0,nan\n"
                             << "line 1";
        QTest::newRow("NaN as time") << "0,1\nnan,1\n"
                                     << "line 2: \"nan\" is no time";
        QTest::newRow("never") << "-inf,1\n"
                               << "line 1: \"-inf\" is no time";
        QTest::newRow("far") << "1e300,1\n"
                             << "emitter.rate: a key frame lies";
        QTest::newRow("too many") << many << "10001 key frames";
        QTest::newRow("nothing, a million times") << QString(1'000'000, QLatin1Char('\n')) << "0 key frames";
        QTest::newRow("words after a million lines")
            << QString(1'000'000, QLatin1Char('\n')) + QStringLiteral("soon,1") << "line 1000001: \"soon\"";
        QTest::newRow("binary") << QString(4000, QChar(1)) << "0 key frames";
    }
    void whatIsNoTableIsRefusedWithItsLine()
    {
        QFETCH(QString, table);
        QFETCH(QString, says);
        const Result<Track> read = parseKeyTable(kRate, table.toStdString(), 30);
        QVERIFY(!read);
        QVERIFY2(read.error().text().find(says.toStdString()) != std::string::npos, read.error().text().c_str());
    }
};

QTEST_GUILESS_MAIN(KeyTableTest)
#include "key_table_test.moc"
