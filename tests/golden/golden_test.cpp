// Small pictures of every built-in preset, held against their stored checksums bit for bit: any machine and compiler
// gives these. They change only on purpose: FUMAGE_WRITE_GOLDEN=1 writes checksums and reference pictures anew. The
// references (8 bits) decide nothing: a test that fails shows its picture and the difference from them.

#include "tests/golden/checksum.h"
#include "tests/golden/golden_pictures.h"
#include "tests/helpers.h"

#include "core/preset/library.h"
#include "core/preset/preset_file.h"

#include <QFile>
#include <QTemporaryDir>

using namespace fumage;
using namespace fumage::tests;

namespace {

QString referenceOf(const LibraryEntry& entry)
{
    return QStringLiteral(FUMAGE_GOLDEN_SOURCE "/pictures/") + QString::fromStdString(entry.id) + ".png";
}

void writeAnew(QFile& file)
{
    QVERIFY(file.open(QIODevice::WriteOnly));
    for (const LibraryEntry& entry : builtinPresets()) {
        const Scene scene = goldenScene(entry.id);
        const Image image = goldenPicture(scene).value();
        file.write(QByteArray::fromStdString(goldenLine(entry.id, image)) + "\n");
        QVERIFY(writeReference(image, scene.output, referenceOf(entry)));
    }
    file.close();
}

/// The lines of the stored checksums by their preset.
QHash<QByteArray, QByteArray> checksums()
{
    QHash<QByteArray, QByteArray> lines;
    QFile file(FUMAGE_GOLDEN_SOURCE "/golden.txt");
    if (file.open(QIODevice::ReadOnly)) {
        for (const QByteArray& line : file.readAll().split('\n')) {
            lines.insert(line.split(' ').first(), line);
        }
    }
    return lines;
}

} // namespace

class GoldenTest : public QObject {
    Q_OBJECT

private slots:
    void picturesOfThePresets_data()
    {
        QTest::addColumn<QByteArray>("expected");
        QFile file(FUMAGE_GOLDEN_SOURCE "/golden.txt");
        if (qEnvironmentVariableIsSet("FUMAGE_WRITE_GOLDEN")) {
            writeAnew(file);
        }
        const QHash<QByteArray, QByteArray> lines = checksums();
        for (const LibraryEntry& entry : builtinPresets()) {
            QTest::newRow(entry.id.c_str()) << lines.value(QByteArray::fromStdString(entry.id));
        }
    }
    void picturesOfThePresets()
    {
        QFETCH(QByteArray, expected);
        for (const LibraryEntry& entry : builtinPresets()) {
            if (entry.id != QTest::currentDataTag()) {
                continue;
            }
            const Scene scene = goldenScene(entry.id);
            const Image image = goldenPicture(scene).value();
            const QByteArray line = QByteArray::fromStdString(goldenLine(entry.id, image));
            if (line != expected) {
                const QString shown = showDifference(image, scene.output, referenceOf(entry),
                    QStringLiteral(FUMAGE_GOLDEN_SEEN), QString::fromStdString(entry.id));
                QFAIL(qPrintable(QString("%1 was expected, %2 seen: %3").arg(QString(expected), QString(line), shown)));
            }
        }
    }

    /// Presets of version 1 of the format give what they gave when it ended.
    void picturesOfVersion1_data()
    {
        QTest::addColumn<QByteArray>("expected");
        QFile file(FUMAGE_VERSION_1 "golden.txt");
        QVERIFY(file.open(QIODevice::ReadOnly));
        for (const QByteArray& line : file.readAll().trimmed().split('\n')) {
            QTest::newRow(line.split(' ').first().constData()) << line;
        }
    }
    void picturesOfVersion1()
    {
        QFETCH(QByteArray, expected);
        const std::string id = QTest::currentDataTag();
        const Result<PresetReading> frozen = readPresetFile(FUMAGE_VERSION_1 "presets/" + id + ".json");
        QVERIFY2(frozen.ok(), frozen ? "" : frozen.error().text().c_str());
        const Scene scene = goldenScene(frozen.value().preset.scene);
        // Where the preset of today is the same, picturesOfThePresets() renders it.
        if (scene == goldenScene(id) && expected == checksums().value(QByteArray::fromStdString(id))) {
            return;
        }
        QCOMPARE(QByteArray::fromStdString(goldenLine(id, goldenPicture(scene).value())), expected);
    }

    void everyPresetHasAReferencePicture()
    {
        for (const LibraryEntry& entry : builtinPresets()) {
            QVERIFY2(QFile::exists(referenceOf(entry)), qPrintable(referenceOf(entry)));
        }
    }

    void aPictureThatDiffersIsShownBesideTheExpectedOne()
    {
        const QTemporaryDir folder;
        Image image;
        image.resize(4, 2);
        std::fill(image.pixels.begin(), image.pixels.end(), 1.0F);
        const QString reference = folder.filePath("reference.png");
        QVERIFY(writeReference(image, Output(), reference));
        image.row(1)[3 * 4 + 2] = 0.0F; // one of 32 channels is black instead of white
        const QString text = showDifference(image, Output(), reference, folder.filePath("seen"), "smoke");
        QVERIFY2(text.startsWith("largest difference 255 of 255, mean 7.97;"), qPrintable(text));
        QCOMPARE(QDir(folder.filePath("seen")).entryList(QDir::Files, QDir::Name),
            (QStringList{"smoke.difference.png", "smoke.expected.png", "smoke.png"}));
    }

    void aPictureWithoutAReferenceIsShownAlone()
    {
        const QTemporaryDir folder;
        Image image;
        image.resize(4, 2);
        std::fill(image.pixels.begin(), image.pixels.end(), 1.0F);
        QVERIFY(showDifference(image, Output(), folder.filePath("none.png"), folder.path(), "smoke")
                    .contains("there is no reference"));
        QVERIFY(QFile::exists(folder.filePath("smoke.png")));
    }
};

QTEST_GUILESS_MAIN(GoldenTest)
#include "golden_test.moc"
