// What artists are told of engines that play a sheet otherwise than it was made, and that what they are told is a way
// out.

#include "tests/effects.h"

#include "core/export/sheets/cell_frames.h"
#include "core/export/engines/engine_remarks.h"

#include <cmath>

#include <QRegularExpression>
#include <QtTest/QtTest>

using namespace fumage;
using namespace fumage::tests;

namespace {

FlipbookOptions optionsFor(Engine engine, int columns, int rows, int frames)
{
    FlipbookOptions options;
    options.engine = engine;
    options.columns = columns;
    options.rows = rows;
    options.frames = {0, frames - 1, 1};
    return options;
}

Effect atRate(int framesPerSecond)
{
    Effect effect = thesisEffect(10);
    effect.timeline.frameRate = framesPerSecond;
    return effect;
}

double error(Engine engine, double rate)
{
    return std::abs(playedRate(engine, rate) / rate - 1.0);
}

} // namespace

class EngineRemarksTest : public QObject {
    Q_OBJECT

private slots:
    void onlyClocksOfWholeStepsChangeTheRate()
    {
        for (const Engine engine : kAllEngines) {
            for (double rate = 0.37; rate < 240.0; rate *= 1.13) {
                const double played = playedRate(engine, rate);
                if (engine == Engine::Effekseer) {
                    QVERIFY(std::abs(60.0 / played - std::round(60.0 / played)) < 1e-9 && played <= 60.0);
                } else if (engine == Engine::Defold) {
                    QVERIFY(played == std::floor(played) && played >= 1.0);
                } else {
                    QCOMPARE(played, rate);
                }
            }
        }
    }

    void aSpeedThatIsNotKeptIsTold_data()
    {
        QTest::addColumn<int>("engine");
        QTest::addColumn<int>("fps");
        QTest::addColumn<int>("frames");
        QTest::addColumn<bool>("told");
        for (const int fps : {30, 60}) {
            QTest::addRow("Effekseer keeps %d", fps) << static_cast<int>(Engine::Effekseer) << fps << 64 << false;
        }
        for (const int fps : {24, 25, 48, 50}) {
            QTest::addRow("Effekseer does not keep %d", fps)
                << static_cast<int>(Engine::Effekseer) << fps << 64 << true;
            QTest::addRow("Godot keeps %d", fps) << static_cast<int>(Engine::Godot) << fps << 64 << false;
        }
        QTest::newRow("Effekseer has no 120 a second") << static_cast<int>(Engine::Effekseer) << 120 << 64 << true;
        QTest::newRow("Defold keeps whole rates") << static_cast<int>(Engine::Defold) << 24 << 64 << false;
        QTest::newRow("Defold has no 3.2 a second") << static_cast<int>(Engine::Defold) << 5 << 100 << true;
    }
    void aSpeedThatIsNotKeptIsTold()
    {
        QFETCH(int, engine);
        QFETCH(int, fps);
        QFETCH(int, frames);
        QFETCH(bool, told);
        const Effect effect = atRate(fps);
        FlipbookOptions options = optionsFor(static_cast<Engine>(engine), 8, 8, frames);
        QCOMPARE(error(options.engine, cellsPerSecond(effect, options)) > 0.02, told);
        const std::vector<Message> remarks = engineRemarks(effect, options);
        QCOMPARE(remarks.size(), told ? std::size_t{1} : std::size_t{0});
        if (told) {
            const QString text = QString::fromStdString(remarks.front().text());
            QVERIFY2(text.startsWith(QString::fromUtf8(
                         titleOf(options.engine).data(), static_cast<qsizetype>(titleOf(options.engine).size()))),
                qPrintable(text));
            QVERIFY2(text.contains("frames a second"), qPrintable(text));
        }
    }

    /// Both ways out that are told, taken, leave nothing to tell.
    void whatIsAdvisedFits()
    {
        int frameCounts = 0;
        for (const Engine engine : {Engine::Effekseer, Engine::Defold}) {
            for (const int fps : {12, 15, 23, 24, 25, 30, 48, 50, 60, 90, 120, 144}) {
                for (const int count : {16, 17, 25, 33, 64, 100, 150, 400}) {
                    const FlipbookOptions options = optionsFor(engine, 4, 4, count);
                    for (const Message& remark : engineRemarks(atRate(fps), options)) {
                        const QString text = QString::fromStdString(remark.text());
                        const QRegularExpressionMatch frames =
                            QRegularExpression(": (\\d+) frames in its cells").match(text);
                        if (frames.hasMatch()) {
                            ++frameCounts;
                            FlipbookOptions other = optionsFor(engine, 4, 4, frames.captured(1).toInt());
                            QVERIFY2(engineRemarks(atRate(fps), other).empty(), qPrintable(text));
                        }
                        const double rate =
                            QRegularExpression("([\\d.]+) frames a second").match(text).captured(1).toDouble();
                        QVERIFY2(
                            error(engine, cellsPerSecond(atRate(fps), options) * rate / fps) < 0.02, qPrintable(text));
                    }
                }
            }
        }
        QVERIFY(frameCounts > 20);
    }

    void vectorsOfGridsThatUnrealMisreadsAreTold()
    {
        for (const auto& [columns, rows] : {std::pair{8, 8}, std::pair{8, 4}, std::pair{3, 5}}) {
            FlipbookOptions options = optionsFor(Engine::Unreal, columns, rows, 64);
            options.passes = {Pass::Colour, Pass::Motion};
            QCOMPARE(engineRemarks(atRate(30), options).empty(), columns == rows);
            options.passes = {Pass::Colour};
            QVERIFY(engineRemarks(atRate(30), options).empty());
            options.engine = Engine::Unity;
            options.passes = {Pass::Colour, Pass::Motion};
            QVERIFY(engineRemarks(atRate(30), options).empty());
        }
    }
};

QTEST_GUILESS_MAIN(EngineRemarksTest)
#include "engine_remarks_test.moc"
