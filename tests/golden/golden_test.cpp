// Small pictures of every built-in preset, held against their stored checksums bit for bit: any machine and compiler
// gives these. They change only on purpose: FUMAGE_WRITE_GOLDEN=1 writes checksums and reference pictures anew. The
// references (8 bits) decide nothing: a test that fails shows its picture and the difference from them.

#include "tests/golden/checksum.h"
#include "tests/golden/golden_pictures.h"
#include "tests/helpers.h"

#include "core/preset/library.h"

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

} // namespace

class GoldenTest : public QObject {
    Q_OBJECT

private slots:
    void picturesOfThePresets_data()
    {
        QTest::addColumn<std::string>("expected");
        if (qEnvironmentVariableIsSet("FUMAGE_WRITE_GOLDEN")) {
            QFile file(FUMAGE_GOLDEN_SOURCE "/golden.txt");
            writeAnew(file);
        }
        const std::map<std::string, std::string> lines = goldenLines(FUMAGE_GOLDEN_SOURCE "/golden.txt");
        for (const LibraryEntry& entry : builtinPresets()) {
            const auto line = lines.find(entry.id);
            QTest::newRow(entry.id.c_str()) << (line == lines.end() ? std::string() : line->second);
        }
    }
    void picturesOfThePresets()
    {
        QFETCH(std::string, expected);
        for (const LibraryEntry& entry : builtinPresets()) {
            if (entry.id != QTest::currentDataTag()) {
                continue;
            }
            const Scene scene = goldenScene(entry.id);
            const Image image = goldenPicture(scene).value();
            const std::string line = goldenLine(entry.id, image);
            if (line != expected) {
                const QString shown = showDifference(image, scene.output, referenceOf(entry),
                    QStringLiteral(FUMAGE_GOLDEN_SEEN), QString::fromStdString(entry.id));
                QFAIL(qPrintable(QString("%1 was expected, %2 seen: %3")
                                     .arg(QString::fromStdString(expected), QString::fromStdString(line), shown)));
            }
        }
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
