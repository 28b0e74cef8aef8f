// Markers as those pass them who play a sheet: when, at which cell, and in what is written of it.

#include "tests/effects.h"

#include "core/export/engines/engine_files.h"
#include "core/export/remarks.h"
#include "core/export/sheets/cell_frames.h"
#include "core/export/sheets/flipbook.h"
#include "core/export/sheets/flipbook_files.h"
#include "core/export/sheets/sheet_events.h"
#include "core/system/file.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest/QtTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace fumage;
using namespace fumage::tests;

namespace {

constexpr int kRate = 30;

/// A scene with markers at frames.
Scene marked(const std::vector<double>& frames, int loopLength = 0)
{
    Scene scene = thesisEffect(300);
    scene.timeline.frameRate = kRate;
    scene.timeline.length = loopLength > 0 ? loopLength : 1000;
    scene.timeline.loop = loopLength > 0;
    scene.output.width = 24;
    scene.output.height = 16;
    for (const double frame : frames) {
        addMarker(scene.markers, {"at " + std::to_string(frame), frame / kRate});
    }
    return scene;
}

FlipbookOptions sheet(FrameRange frames, int columns, int rows = 1)
{
    FlipbookOptions options;
    options.frames = frames;
    options.columns = columns;
    options.rows = rows;
    return options;
}

FlipbookOptions retimed(std::initializer_list<CurvePoint> points, FrameRange frames, int cells)
{
    FlipbookOptions options = sheet(frames, cells);
    options.retime = Curve(points);
    return options;
}

struct Passed {
    int cell;
    double place; ///< in cells since the first
};

/// Whether the events of a scene are these.
bool arePassed(const Scene& scene, const FlipbookOptions& options, const std::vector<Passed>& wanted)
{
    const std::vector<SheetEvent> events = sheetEvents(scene, options);
    bool same = events.size() == wanted.size();
    for (std::size_t i = 0; same && i < events.size(); ++i) {
        const double place = events[i].seconds * cellsPerSecond(scene, options);
        same = events[i].cell == wanted[i].cell && std::abs(place - wanted[i].place) < 1e-9;
    }
    for (std::size_t i = 0; !same && i < events.size(); ++i) {
        qWarning("%s: cell %d, %.9g s", events[i].name.c_str(), events[i].cell, events[i].seconds);
    }
    return same;
}

std::string saidOf(const Scene& scene, const ExportPlan& plan)
{
    std::string all;
    for (const Message& remark : remarksOn(scene, plan)) {
        all += remark.text() + "\n";
    }
    return all;
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

class SheetEventsTest : public QObject {
    Q_OBJECT

private slots:
    void withACellAFrameTheyComeAtTheirTimes()
    {
        Scene scene;
        scene.timeline.frameRate = kRate;
        for (int tenth = 0; tenth < 10; ++tenth) {
            scene.markers.push_back({"x", tenth / 10.0}); // frame 3, 6, ..., but for rounding
        }
        const std::vector<SheetEvent> events = sheetEvents(scene, sheet({0, 31, 1}, 8, 4));
        QCOMPARE(events.size(), std::size_t{10});
        for (int tenth = 0; tenth < 10; ++tenth) {
            QCOMPARE(events[static_cast<std::size_t>(tenth)].cell, 3 * tenth);
            QVERIFY(std::abs(events[static_cast<std::size_t>(tenth)].seconds - tenth / 10.0) < 1e-12);
        }
    }

    void withFewerCellsTheyComeBetweenThem()
    {
        // 60 frames in 8 cells: these show 0, 7, 15, 22, 30, 37, 45 and 52, 4 a second.
        QVERIFY(arePassed(marked({0, 10, 15, 59}), sheet({0, 59, 1}, 4, 2),
            {{0, 0.0}, {1, 1.0 + 3.0 / 8.0}, {2, 2.0}, {7, 7.0 + 7.0 / 8.0}}));
    }

    void timesAreThoseOfTheSheetThatIsLeft()
    {
        QVERIFY(
            arePassed(marked({0, 9, 10, 20, 25.5, 26}), sheet({10, 25, 1}, 4, 4), {{0, 0.0}, {10, 10.0}, {15, 15.5}}));
        QVERIFY(arePassed(marked({5, 30, 31.5, 32}), sheet({0, 30, 2}, 4, 4), {{2, 2.5}, {15, 15.0}, {15, 15.75}}));
    }

    void aCurveBringsThemEarlierOrLater()
    {
        // Half of the frames in all cells: 0, 5, 10, ..., 45, and then to 50.
        const FlipbookOptions slow = retimed({{0.0F, 0.0F}, {1.0F, 0.5F}}, {0, 99, 1}, 10);
        QVERIFY(arePassed(marked({12, 25, 47.5, 50}), slow, {{2, 2.4}, {5, 5.0}, {9, 9.5}}));
        const FlipbookOptions eased = retimed({{0.0F, 0.0F}, {0.5F, 0.2F}, {1.0F, 1.0F}}, {0, 99, 1}, 10);
        for (int cell = 0; cell < 9; ++cell) {
            const int from = frameOfCell(eased, cell);
            const int to = frameOfCell(eased, cell + 1);
            QVERIFY(to > from);
            const double middle = (from + to) / 2.0;
            QVERIFY(arePassed(marked({middle}), eased, {{cell, cell + 0.5}}));
        }
        // 99, 75, 50, 25, and then to 0
        const FlipbookOptions backwards = retimed({{0.0F, 1.0F}, {1.0F, 0.0F}}, {0, 99, 1}, 4);
        QVERIFY(arePassed(marked({10, 60, 99}), backwards, {{0, 0.0}, {1, 1.6}, {3, 3.6}}));
        const FlipbookOptions there = retimed({{0.0F, 0.0F}, {0.5F, 1.0F}, {1.0F, 0.0F}}, {0, 99, 1}, 4);
        const double place = 25.0 / frameOfCell(there, 1); // and not on the way back
        QVERIFY(arePassed(marked({25}), there, {{0, place}}));
        const FlipbookOptions still = retimed({{0.0F, 0.5F}, {1.0F, 0.5F}}, {0, 99, 1}, 4);
        QVERIFY(arePassed(marked({49, 50, 51}), still, {{0, 0.0}}));
    }

    void inALoopTheyComeOnceATurn()
    {
        QVERIFY(arePassed(marked({10, 30}, 30), sheet({0, 59, 1}, 10, 6), {{10, 10.0}, {40, 40.0}}));
        QVERIFY(arePassed(marked({10}, 30), sheet({20, 49, 1}, 6, 5), {{20, 20.0}}));
        QVERIFY(arePassed(marked({20}, 30), sheet({20, 49, 1}, 6, 5), {{0, 0.0}}));
        // Without the loop frame 30 is one as any other.
        QVERIFY(arePassed(marked({30}), sheet({0, 59, 1}, 10, 6), {{30, 30.0}}));
    }

    void anotherFrameRateMovesNone()
    {
        Scene scene = marked({15});
        const std::vector<SheetEvent> before = sheetEvents(scene, sheet({0, 59, 1}, 10, 6));
        scene.timeline.frameRate = 2 * kRate;
        const std::vector<SheetEvent> after = sheetEvents(scene, sheet({0, 119, 1}, 12, 10));
        QCOMPARE(before.front().seconds, 0.5);
        QCOMPARE(after.front().seconds, 0.5);
    }

    void cellsShowTheirMoments()
    {
        std::mt19937 random(7);
        for (int i = 0; i < 200; ++i) {
            const int columns = 1 + static_cast<int>(random() % 8);
            const int step = 1 + static_cast<int>(random() % 3);
            const int first = static_cast<int>(random() % 50);
            const int frames = columns + static_cast<int>(random() % 40);
            const FlipbookOptions options = sheet({first, first + (frames - 1) * step, step}, columns);
            const double frame = first + frames * step * static_cast<double>(random() % 1000) / 1000.0;
            const Scene scene = marked({frame});
            const std::vector<SheetEvent> events = sheetEvents(scene, options);
            QCOMPARE(events.size(), std::size_t{1});
            const int cell = events.front().cell;
            QCOMPARE(static_cast<int>(events.front().seconds * cellsPerSecond(scene, options) + 1e-9), cell);
            QVERIFY(frameOfCell(options, cell) <= frame + 1e-6);
            QVERIFY(cell + 1 == columns || frameOfCell(options, cell + 1) > frame - 1e-6);
            const double away = events.front().seconds - (frame - first) / kRate;
            QVERIFY(std::abs(away) <= static_cast<double>(step) / kRate + 1e-9);
        }
    }

    void theSideCarHasThem()
    {
        const QTemporaryDir folder;
        FlipbookOptions options = sheet({0, 15, 1}, 4, 2);
        options.output = folder.path().toStdString() + "/a.png";
        Scene scene = marked({});
        scene.markers = {{"Boom <&> \"x\"", 0.2}, {"late", 9.0}};
        const auto sideCar = [&] {
            const Result<Flipbook> done = renderFlipbook(scene, options);
            const std::string text = done ? readFile(done.value().description, 100'000).value() : done.error().text();
            return QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
        };
        const QJsonObject with = sideCar();
        const QJsonArray events = with["events"].toArray();
        QCOMPARE(events.size(), 1);
        QCOMPARE(events[0]["name"].toString(), QStringLiteral("Boom <&> \"x\""));
        QCOMPARE(events[0]["cell"].toInt(), 3); // frame 6 of 16 in 8 cells
        QCOMPARE(events[0]["seconds"].toDouble(), 0.2);
        scene.markers.clear();
        QJsonObject without = sideCar();
        QVERIFY(!without.contains("events"));
        without["events"] = events;
        QCOMPARE(without, with);
    }

    void enginesAreToldOfThem_data()
    {
        QTest::addColumn<int>("engine");
        QTest::addColumn<QString>("says");
        const auto row = [](Engine engine, const char* says) {
            QTest::newRow(std::string(nameOf(engine)).c_str()) << static_cast<int>(engine) << says;
        };
        row(Engine::Unity, "MarkerAt(0.2f, \"Boom\", 3),");
        row(Engine::Unreal, "(\"Boom\", 0.2, 3),");
        row(Engine::Godot, "\"args\": [\"Boom\"],");
        row(Engine::Godot3, "\"args\": [ \"Boom\" ],");
        row(Engine::Web, "<li data-seconds=\"0.2\">Boom</li>");
    }
    void enginesAreToldOfThem()
    {
        QFETCH(int, engine);
        QFETCH(QString, says);
        const QTemporaryDir folder;
        FlipbookOptions options = sheet({0, 15, 1}, 4, 2);
        options.engine = static_cast<Engine>(engine);
        options.output = folder.path().toStdString() + "/a.png";
        Scene scene = marked({});
        const auto text = [&] {
            const Result<Flipbook> done = renderFlipbook(scene, options);
            const std::filesystem::path picture = folder.path().toStdString() + "/a.png";
            const std::vector files = engineFilesOf(options.engine, picture, std::span(&picture, 1));
            return done ? readFile(files.front(), 10'000'000).value() : done.error().text();
        };
        const std::string without = text();
        scene.markers = {{"Boom", 0.2}, {"Hit", 0.4}, {"late", 9.0}};
        const std::string with = text();
        QVERIFY2(contains(with, says.toStdString()), with.substr(0, 4000).c_str());
        QVERIFY(contains(with, "Hit") && !contains(with, "late"));
        for (const char* word : {"arker", "Boom"}) {
            QVERIFY(!contains(without, word));
        }
        if (options.engine == Engine::Godot || options.engine == Engine::Godot3) {
            const QString made = QString::fromStdString(with);
            const auto resources =
                made.count(QStringLiteral("[ext_resource ")) + made.count(QStringLiteral("[sub_resource "));
            QVERIFY(made.startsWith(QStringLiteral("[gd_scene load_steps=%1 ").arg(resources + 1)));
        }
    }

    void godotHearsOfAllThatComeAtOneTime_data()
    {
        QTest::addColumn<int>("engine");
        QTest::newRow("4") << static_cast<int>(Engine::Godot);
        QTest::newRow("3") << static_cast<int>(Engine::Godot3);
    }
    void godotHearsOfAllThatComeAtOneTime()
    {
        QFETCH(int, engine);
        Scene scene = marked({});
        FlipbookOptions options = sheet({0, 15, 1}, 4, 2);
        EngineSheet drawn{scene, 4, 2, cellsPerSecond(scene, options), false, {}, {}, {}};
        drawn.pictures.push_back({Pass::Colour, "a.png", {}});
        drawn.events = {{"a", 0.1, 1}, {"b", 0.1, 1}, {"c", 0.100004, 1}, {"d", 0.2, 3}, {"e", 0.2, 3}, {"f", 50.0, 7},
            {"g", 50.0004, 7}};
        const QString text = QString::fromStdString(makeEngineFiles(static_cast<Engine>(engine), drawn).front());
        const QRegularExpression times(QStringLiteral("\ntracks/(\\d+)/keys = \\{\n\"times\": \\w+\\(([^)]*)\\)"));
        int tracks = 0;
        int keys = 0;
        for (auto found = times.globalMatch(text); found.hasNext(); ++tracks) {
            const QRegularExpressionMatch track = found.next();
            QCOMPARE(track.captured(1).toInt(), tracks);
            double before = -1.0;
            for (const QString& time : track.captured(2).split(u',')) {
                const double now = time.trimmed().toDouble();
                QVERIFY2(now - before > 1e-5 * std::max(1.0, now), qPrintable(track.captured(2))); // is_equal_approx()
                before = now;
                ++keys;
            }
        }
        QCOMPARE(keys, 7);
        QCOMPARE(tracks, 3);
    }

    void thoseThatNobodyHearsOfAreNamedBefore()
    {
        ExportPlan plan;
        plan.kind = ExportKind::Flipbook;
        plan.frames = {10, 73, 1};
        Scene scene = marked({20});
        scene.timeline.length = 100;
        QCOMPARE(saidOf(scene, plan), std::string());
        addMarker(scene.markers, {"at 20.000000", 5.0 / kRate}); // of the same name, and outside
        addMarker(scene.markers, {"over", 100.0 / kRate});
        const std::string said = saidOf(scene, plan);
        QVERIFY2(contains(said, "markers outside of the frames of the sheet: \"at 20.000000\"\n"), said.c_str());
        QVERIFY2(contains(said, "markers after the end of the timeline: \"over\"\n"), said.c_str());
        plan.kind = ExportKind::Sequence; // has no events, but the end is the end
        QCOMPARE(saidOf(scene, plan), std::string("markers after the end of the timeline: \"over\"\n"));
        for (int i = 0; i < 9; ++i) {
            addMarker(scene.markers, {"x", 50.0});
        }
        QVERIFY(contains(saidOf(scene, plan), "\"over\", \"x\", \"x\", \"x\", \"x\", ...\n"));
    }
};

QTEST_GUILESS_MAIN(SheetEventsTest)
#include "sheet_events_test.moc"
