// Presets of version 1 of the format give, bit for bit, what they gave when it ended.

#include "tests/golden/checksum.h"
#include "tests/helpers.h"

#include "core/preset/preset_file.h"

using namespace fumage;
using namespace fumage::tests;

class GoldenVersion1Test : public QObject {
    Q_OBJECT

private slots:
    void picturesOfVersion1_data()
    {
        QTest::addColumn<std::string>("expected");
        const std::map<std::string, std::string> lines = goldenLines(FUMAGE_VERSION_1 "golden.txt");
        QVERIFY(!lines.empty());
        for (const auto& [id, line] : lines) {
            QTest::newRow(id.c_str()) << line;
        }
    }
    void picturesOfVersion1()
    {
        QFETCH(std::string, expected);
        const std::string id = QTest::currentDataTag();
        const Result<PresetReading> frozen = readPresetFile(FUMAGE_VERSION_1 "presets/" + id + ".json");
        QVERIFY2(frozen.ok(), frozen ? "" : frozen.error().text().c_str());
        const Scene scene = goldenScene(frozen.value().preset.scene);
        // Where the preset of today is the same, golden_test renders it.
        static const std::map<std::string, std::string> today = goldenLines(FUMAGE_GOLDEN_SOURCE "/golden.txt");
        const auto line = today.find(id);
        if (line != today.end() && line->second == expected && scene == goldenScene(id)) {
            return;
        }
        const std::string seen = goldenLine(id, goldenPicture(scene).value());
        QVERIFY2(seen == expected, (seen + " is seen, " + expected + " was expected").c_str());
    }
};

QTEST_GUILESS_MAIN(GoldenVersion1Test)
#include "golden_version1_test.moc"
