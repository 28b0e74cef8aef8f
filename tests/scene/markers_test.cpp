// Markers of the timeline: what may be one, files that keep them, and the words of the command line.

#include "tests/effects.h"

#include "core/preset/preset_file.h"
#include "core/preset/schema.h"
#include "core/scene/marker_assignment.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest/QtTest>

#include <cmath>
#include <limits>

using namespace fumage;
using namespace fumage::tests;

namespace {

std::string textOf(const Scene& scene)
{
    Preset preset;
    preset.scene = scene;
    return formatPreset(preset);
}

/// A preset whose scene has a member more.
std::string withMember(const std::string& member)
{
    std::string text = textOf({});
    const std::string scene = "\"scene\": {\n";
    return text.insert(text.find(scene) + scene.size(), "    " + member + ",\n");
}

} // namespace

class MarkersTest : public QObject {
    Q_OBJECT

private slots:
    void theyStandInTheOrderOfTheirTimes()
    {
        std::vector<Marker> markers;
        QCOMPARE(addMarker(markers, {"b", 1.0}), std::size_t{0});
        QCOMPARE(addMarker(markers, {"a", 0.5}), std::size_t{0});
        QCOMPARE(addMarker(markers, {"c", 1.0}), std::size_t{2}); // of one time the first stays the first
        QCOMPARE(addMarker(markers, {"a", 0.75}), std::size_t{1});
        QVERIFY((markers == std::vector<Marker>{{"a", 0.5}, {"a", 0.75}, {"b", 1.0}, {"c", 1.0}}));
        QVERIFY(checkMarkers(markers).ok());
        std::swap(markers.front(), markers.back());
        QVERIFY(!checkMarkers(markers).ok());
    }

    void whatIsNoMarkerIsRefused_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<double>("seconds");
        QTest::addColumn<bool>("isOne");
        QTest::newRow("plain") << QByteArray("Boom") << 0.5 << true;
        QTest::newRow("beginning") << QByteArray("Boom") << 0.0 << true;
        QTest::newRow("latest") << QByteArray("Boom") << kMaxMarkerSeconds << true;
        QTest::newRow("as long as may be") << QByteArray(100, 'x') << 1.0 << true;
        QTest::newRow("letters of all kinds") << QByteArray("\xC3\xA5 \xE7\x83\x9F <b>&amp;") << 1.0 << true;
        QTest::newRow("before the beginning") << QByteArray("Boom") << -0.001 << false;
        QTest::newRow("too late") << QByteArray("Boom") << 1e9 << false;
        QTest::newRow("NaN") << QByteArray("Boom") << std::nan("") << false;
        QTest::newRow("never") << QByteArray("Boom") << std::numeric_limits<double>::infinity() << false;
        QTest::newRow("no name") << QByteArray() << 1.0 << false;
        QTest::newRow("too long") << QByteArray(101, 'x') << 1.0 << false;
        QTest::newRow("two lines") << QByteArray("a\nb") << 1.0 << false;
        QTest::newRow("escape") << QByteArray("\x1b[31m") << 1.0 << false;
        QTest::newRow("control of two bytes") << QByteArray("a\xC2\x9B") << 1.0 << false;
        QTest::newRow("turned") << QByteArray("a\xE2\x80\xAE") << 1.0 << false;
        QTest::newRow("not UTF-8") << QByteArray("a\xFF") << 1.0 << false;
        QTest::newRow("NUL") << QByteArray("a\0b", 3) << 1.0 << false;
    }
    void whatIsNoMarkerIsRefused()
    {
        QFETCH(QByteArray, name);
        QFETCH(double, seconds);
        QFETCH(bool, isOne);
        const Marker marker{name.toStdString(), seconds};
        QCOMPARE(checkMarker(marker).ok(), isOne);
        QCOMPARE(checkMarkers(std::vector{marker}).ok(), isOne);
        const std::string made = markerNameOf(marker.name);
        QVERIFY(made.empty() || checkMarker({made, 0.0}).ok());
        QVERIFY(!isOne || made == marker.name);
    }

    void moreThanThereMayBeAreRefused()
    {
        std::vector<Marker> markers(kMaxMarkers, {"x", 1.0});
        QVERIFY(checkMarkers(markers).ok());
        markers.push_back({"x", 1.0});
        QCOMPARE(checkMarkers(markers).error().code, ErrorCode::TooLarge);
    }

    void namesAreCutAtACharacter()
    {
        const std::string smoke = "\xE7\x83\x9F"; // three bytes: 33 of them fit
        std::string many;
        for (int i = 0; i < 50; ++i) {
            many += smoke;
        }
        QCOMPARE(markerNameOf(many), many.substr(0, 99));
        QCOMPARE(markerNameOf("  a\nb\t "), std::string("a b"));
        QCOMPARE(markerNameOf(" \n "), std::string());
    }

    void theyBelongToTheScene()
    {
        Scene scene = everythingOn();
        const Scene without = scene;
        scene.markers = {{"Boom", 0.5}};
        QVERIFY(!(scene == without));
        Scene changed = scene;
        changed.assign(0, Effect());
        changed.setSurroundings(Effect());
        QVERIFY(changed.markers == scene.markers);
        QVERIFY(scene.atFrame(3).markers == scene.markers);
        QVERIFY(scene.effect() == without.effect());
    }

    void filesKeepThem()
    {
        Scene scene = everythingOn();
        scene.layers.resize(3);
        const std::string before = textOf(scene);
        QVERIFY(before.find("markers") == std::string::npos); // nothing is written where there is none
        scene.markers = {{"Boom", 1.0 / 3.0}, {"a \"b\" \\ <c>", 0.5}, {"Boom", 0.5}, {"\xE7\x83\x9F", 2.25}};
        const std::string text = textOf(scene);
        const Result<PresetReading> reading = parsePreset(text, "here.json");
        QVERIFY2(reading.ok(), reading ? "" : reading.error().text().c_str());
        QVERIFY(reading.value().warnings.empty());
        QVERIFY(reading.value().preset.scene == scene);
        QCOMPARE(formatPreset(reading.value().preset), text);
        QVERIFY(QJsonDocument::fromJson(QByteArray::fromStdString(text)).isObject());
        scene.markers.clear();
        QCOMPARE(textOf(scene), before);
    }

    void filesMayHaveThemInAnyOrder()
    {
        const Result<PresetReading> reading = parsePreset(
            withMember(R"("markers": [{"time": 2, "name": "c"}, {"name": "a", "time": 0}, {"name": "b", "time": 0}])"));
        QVERIFY2(reading.ok(), reading ? "" : reading.error().text().c_str());
        QVERIFY((reading.value().preset.scene.markers == std::vector<Marker>{{"a", 0.0}, {"b", 0.0}, {"c", 2.0}}));
        QVERIFY(parsePreset(withMember(R"("markers": [])")).value().preset.scene.markers.empty());
    }

    void thoseOfLaterVersionsAreKept()
    {
        const std::string later = R"({"name": "Boom", "time": 1, "colour": [1, 0, 0]})";
        const Result<PresetReading> reading =
            parsePreset(withMember("\"markers\": [" + later + R"(, {"name": "a", "time": 2}])"), "here.json");
        QVERIFY2(reading.ok(), reading ? "" : reading.error().text().c_str());
        QCOMPARE(reading.value().warnings.size(), std::size_t{1});
        const std::string said = reading.value().warnings[0].text();
        QVERIFY2(said.find("here.json, line ") != std::string::npos && said.find("colour") != std::string::npos,
            said.c_str());
        QCOMPARE(reading.value().preset.scene.markers.size(), std::size_t{1});
        const std::string again = formatPreset(reading.value().preset);
        QVERIFY(again.find(later) != std::string::npos);
        QCOMPARE(formatPreset(parsePreset(again).value().preset), again);
    }

    void thoseOfLaterVersionsTakeNoRoom()
    {
        Preset preset;
        preset.scene.markers.assign(kMaxMarkers, {"x", 1.0});
        preset.unknown.push_back({"markers", {}, R"({"name": "a", "frame": 3})", 0, true});
        const Result<PresetReading> reading = parsePreset(formatPreset(preset));
        QVERIFY2(reading.ok(), reading ? "" : reading.error().text().c_str());
        QCOMPARE(reading.value().preset.scene.markers.size(), kMaxMarkers);
        QCOMPARE(reading.value().preset.unknown.size(), std::size_t{1});
    }

    void brokenOnesAreRefused_data()
    {
        QTest::addColumn<QString>("markers");
        QTest::addColumn<QString>("says");
        QTest::newRow("no list") << QStringLiteral("{}") << "list";
        QTest::newRow("no object") << QStringLiteral("[0.5]") << "an object";
        QTest::newRow("null") << QStringLiteral("[null]") << "an object";
        QTest::newRow("no time") << QStringLiteral(R"([{"name": "a"}])") << "\"time\" in seconds";
        QTest::newRow("no name") << QStringLiteral(R"([{"time": 1}])") << "\"name\" in quotes";
        QTest::newRow("a number for a name") << QStringLiteral(R"([{"name": 1, "time": 1}])") << "in quotes";
        QTest::newRow("a text for a time") << QStringLiteral(R"([{"name": "a", "time": "1"}])") << "in seconds";
        QTest::newRow("NaN") << QStringLiteral(R"([{"name": "a", "time": NaN}])") << "";
        QTest::newRow("beyond numbers") << QStringLiteral(R"([{"name": "a", "time": 1e999}])") << "";
        QTest::newRow("negative") << QStringLiteral(R"([{"name": "a", "time": -1}])") << "lies at -1 s";
        QTest::newRow("far") << QStringLiteral(R"([{"name": "a", "time": 1e300}])") << "from 0 to 100000 s";
        QTest::newRow("controls") << QStringLiteral(R"([{"name": "a\u0007", "time": 1}])") << "control characters";
        QTest::newRow("empty") << QStringLiteral(R"([{"name": "", "time": 1}])") << "empty";
        QTest::newRow("long") << QStringLiteral(R"([{"name": "%1", "time": 1}])").arg(QString(101, QLatin1Char('x')))
                              << "101 bytes";
        QString many = QStringLiteral("[");
        for (int i = 0; i < 100'000; ++i) {
            many += QLatin1String("{},");
        }
        QTest::newRow("a hundred thousand") << many + QStringLiteral("{}]") << "100001 markers";
    }
    void brokenOnesAreRefused()
    {
        QFETCH(QString, markers);
        QFETCH(QString, says);
        const Result<PresetReading> reading =
            parsePreset(withMember("\"markers\": " + markers.toStdString()), "a.json");
        QVERIFY(!reading);
        const std::string said = reading.error().text();
        QVERIFY2(said.find("a.json, line ") != std::string::npos, said.c_str());
        QVERIFY2(said.find(says.toStdString()) != std::string::npos, said.c_str());
    }

    void theSchemaKnowsThem()
    {
        const QJsonObject schema = QJsonDocument::fromJson(QByteArray::fromStdString(presetSchema())).object();
        const QJsonValue markers = schema["properties"]["scene"]["properties"]["markers"];
        QCOMPARE(markers["type"].toString(), QStringLiteral("array"));
        QCOMPARE(markers["maxItems"].toInt(), static_cast<int>(kMaxMarkers));
        QCOMPARE(markers["items"]["properties"]["time"]["minimum"].toInt(), 0);
        QCOMPARE(markers["items"]["required"].toArray().size(), 2);
    }

    void theCommandLineSetsThem()
    {
        Scene scene;
        QVERIFY(markScene(scene, "Boom=0.5").ok());
        QVERIFY(markScene(scene, " Hit = 1.25; 0.25 ").ok());
        QVERIFY((scene.markers == std::vector<Marker>{{"Hit", 0.25}, {"Boom", 0.5}, {"Hit", 1.25}}));
        QVERIFY(markScene(scene, "Hit=2").ok()); // in place of both
        QVERIFY((scene.markers == std::vector<Marker>{{"Boom", 0.5}, {"Hit", 2.0}}));
        QVERIFY(markScene(scene, "a=b=1").ok());
        QCOMPARE(scene.markers[1].name, std::string("a=b"));
        for (const char* name : {"Boom=", "Hit=", "a=b=", "not there="}) {
            QVERIFY(markScene(scene, name).ok());
        }
        QVERIFY(scene.markers.empty());
    }

    void wordsOfTheCommandLine_data()
    {
        QTest::addColumn<QString>("text");
        QTest::newRow("no time") << "Boom";
        QTest::newRow("no name") << "=1";
        QTest::newRow("no number") << "Boom=soon";
        QTest::newRow("NaN") << "Boom=nan";
        QTest::newRow("never") << "Boom=inf";
        QTest::newRow("negative") << "Boom=-1";
        QTest::newRow("empty among them") << "Boom=1;;2";
        QTest::newRow("controls") << "Bo\nom=1";
        QTest::newRow("more than there may be")
            << QStringLiteral("Boom=1") + QStringLiteral(";1").repeated(static_cast<int>(kMaxMarkers));
        QTest::newRow("a million") << QStringLiteral("Boom=1") + QStringLiteral(";1").repeated(1'000'000);
    }
    void wordsOfTheCommandLine()
    {
        QFETCH(QString, text);
        Scene scene;
        scene.markers = {{"Boom", 0.5}};
        const Scene before = scene;
        QVERIFY(!markScene(scene, text.toStdString()));
        QVERIFY(scene == before);
    }
};

QTEST_GUILESS_MAIN(MarkersTest)
#include "markers_test.moc"
