// What everyone may take for granted of the presets that come along.
#include "tests/helpers.h"

#include "core/export/flipbook.h"
#include "core/preset/library.h"

#include <QTemporaryDir>

using namespace fumage;

class BuiltinTest : public QObject {
    Q_OBJECT

private slots:
    void halfOfThemLoop()
    {
        const std::vector<LibraryEntry> presets = builtinPresets();
        const auto loops = [](const LibraryEntry& entry) { return loadPreset(entry).value().preset.effect.timeline.loop; };
        QVERIFY(std::ranges::count_if(presets, loops) >= 8);
    }

    void eachGivesAWholeFlipbook_data()
    {
        QTest::addColumn<std::string>("name");
        for (const LibraryEntry& entry : builtinPresets()) {
            QTest::newRow(entry.id.c_str()) << entry.id;
        }
    }

    void eachGivesAWholeFlipbook()
    {
        QFETCH(std::string, name);
        const QTemporaryDir folder;
        Effect effect = loadPreset(name).value().preset.effect;
        effect.emitter.count /= 4; // reach as far, and are simulated sooner
        effect.output.width = effect.output.height = 64;
        effect.output.background = Background::Transparent;
        FlipbookOptions flipbook;
        flipbook.output = folder.path().toStdString() + "/a.png";
        flipbook.columns = 4;
        flipbook.rows = 3;
        flipbook.frames = {0, effect.timeline.length - 1, 1};
        const Flipbook book = renderFlipbook(effect, flipbook, [](int, int) {}).value();
        QVERIFY2(book.edgeAlpha < 1.0F / 255.0F, qPrintable(QString::number(static_cast<double>(book.edgeAlpha))));
    }
};

QTEST_GUILESS_MAIN(BuiltinTest)
#include "builtin_test.moc"
